// Proves that each body of a scene has at each step the pose that the job gives it, and that a body
// without a pose, with two, or with other steps is refused by its line.
#include "client/scene/scene_steps.hpp"

#include "tests/client/scene/scene_of.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

class SceneSteps : public testing::Test {
  protected:
    SceneSteps() {
        spec_.bodies = {body_entry("truck"), body_entry("wall"), body_entry("car")};
        for (std::uint32_t i = 0; i < 3; ++i) {
            spec_.bodies[i].line = 10 + i;
        }
        spec_.bodies[0].poses = file("truck.csv", "x,t\n1,0.5\n2,0.75\n");
        spec_.bodies[1].pose = translation_pose(7, 8, 9);
        spec_.bodies[2].count = 2;
        spec_.poses =
            ScenePosesSpec{file("all.csv",
                                "step,body,x,t\n0,car.0,3,0.5\n0,car.1,4,0.5\n1,car.0,nan,0.75\n"
                                "1,car.1,5,0.75\n"),
                           {},
                           true};
    }

    PoseFileSpec file(const std::string& name, const std::string& text) {
        write_text(folder_ / name, text);
        PoseFileSpec made;
        made.path = folder_ / name;
        return made;
    }
    [[nodiscard]] SceneBodies bodies() const {
        const auto mesh = mesh_of_parts({{"left", 1}, {"right", 1}});
        const std::vector meshes(spec_.bodies.size(), mesh);
        return expand_bodies(spec_, meshes, "job.toml").value();
    }
    [[nodiscard]] std::string problem() const {
        const auto opened = open_steps(spec_, bodies(), "job.toml");
        return opened ? "none" : opened.error().detail;
    }
    /// Returns x of each body's pose at a step; -1 for one that is absent.
    static std::vector<double> x_at(StepPoses& poses, std::uint64_t step) {
        std::vector<double> x;
        const auto read = poses.read(step);
        EXPECT_TRUE(read);
        for (const auto& pose : read.value()) {
            x.push_back(pose ? pose->translation().x() : -1);
        }
        return x;
    }

    TemporaryFolder folder_;
    SceneSpec spec_;
};

} // namespace

TEST_F(SceneSteps, EachBodyHasItsPoseAtEachStep) {
    const auto opened = open_steps(spec_, bodies(), "job.toml");
    ASSERT_TRUE(opened) << opened.error().detail;
    StepPoses& poses = *opened.value().poses;
    ASSERT_EQ(poses.steps(), 2u);
    EXPECT_EQ(x_at(poses, 0), (std::vector<double>{1, 7, 3, 4}));
    EXPECT_EQ(x_at(poses, 1), (std::vector<double>{2, 7, -1, 5}));
    EXPECT_EQ(opened.value().are_fixed, (std::vector<bool>{false, true, false, false}));
    EXPECT_EQ(poses.times(), (std::vector<double>{0.5, 0.75}));
}

TEST_F(SceneSteps, PartsOfASplitMeshStandAtTheIdentity) {
    spec_.bodies = {body_entry("factory"), body_entry("wall")};
    spec_.bodies[0].is_split = true;
    spec_.bodies[1].pose = translation_pose(1, 0, 0);
    spec_.poses.reset();
    const auto opened = open_steps(spec_, bodies(), "job.toml");
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().poses->steps(), 1u);
    EXPECT_EQ(x_at(*opened.value().poses, 0), (std::vector<double>{0, 0, 1}));
    EXPECT_EQ(opened.value().are_fixed, (std::vector<bool>{true, true, true}));
    spec_.bodies[0].pose = translation_pose(3, 0, 0);
    const auto posed = open_steps(spec_, bodies(), "job.toml");
    ASSERT_TRUE(posed);
    EXPECT_EQ(x_at(*posed.value().poses, 0), (std::vector<double>{3, 3, 1}));
}

TEST_F(SceneSteps, APartOfASplitMeshMayMove) {
    spec_.bodies[1].is_split = true;
    spec_.bodies[1].pose.reset();
    spec_.poses->file = file("all.csv",
                             "step,body,x\n0,car.0,3\n0,car.1,4\n0,wall.left,6\n1,car.0,5\n"
                             "1,car.1,5\n1,wall.left,8\n");
    const auto opened = open_steps(spec_, bodies(), "job.toml");
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().are_fixed, (std::vector<bool>{false, false, true, false, false}));
    EXPECT_EQ(x_at(*opened.value().poses, 1), (std::vector<double>{2, 8, 0, 5, 5}));
}

TEST_F(SceneSteps, TheTimesOfABodysOwnFileRise) {
    spec_.bodies[0].poses = file("truck.csv", "x,t\n1,0.5\n2,0.5\n");
    EXPECT_THAT(problem(), HasSubstr("truck.csv: line 3: the time 0.5 is not after 0.5 of line 2"));
}

TEST_F(SceneSteps, TheVelocitiesOfFilesAreThoseOfTheirBodies) {
    spec_.bodies[0].poses = file("v.csv", "x,vx,vy,vz\n1,4,5,6\n2,7,8,9\n");
    spec_.poses->file = file("all.csv",
                             "step,body,x,wx,wy,wz\n1,car.1,4,1,2,3\n1,car.0,3,4,5,6\n"
                             "0,car.1,1,7,8,9\n0,car.0,2,0,1,2\n");
    spec_.poses->file.length_factor = 1000;
    const auto opened = open_steps(spec_, bodies(), "job.toml");
    ASSERT_TRUE(opened) << opened.error().detail;
    ASSERT_EQ(opened.value().rates.size(), 2u);
    const StepRates& all = opened.value().rates[0];
    ASSERT_EQ(all.columns, 2u);
    for (const auto& [body, column] : all.bodies) {
        const bool is_second = body == 3;
        EXPECT_EQ(all.rates[column].spin, is_second ? Vec3(7, 8, 9) : Vec3(0, 1, 2));
        EXPECT_EQ(all.name(1, column),
                  (folder_ / "all.csv").string() + (is_second ? ": line 2" : ": line 3"));
    }
    const StepRates& own = opened.value().rates[1];
    ASSERT_EQ(own.bodies.size(), 1u);
    EXPECT_EQ(own.rates[1].velocity, Vec3(7, 8, 9));
    EXPECT_THAT(own.name(1, 0), HasSubstr("v.csv: line 3"));
}

TEST_F(SceneSteps, ABodyWithoutAPoseIsRefused) {
    spec_.bodies[1].pose.reset();
    EXPECT_THAT(problem(),
                AllOf(HasSubstr("job.toml:11: [bodies] wall: \"wall\" has no pose; give it rows in "
                                "[poses]"),
                      HasSubstr("pose = [x, y, z, qx, qy, qz, qw]")));
    spec_.bodies[1].pose = Pose();
    spec_.bodies[2].count = 3;
    EXPECT_THAT(problem(), HasSubstr("job.toml:12: [bodies] car: \"car.2\" has no pose"));
}

TEST_F(SceneSteps, ABodyWithTwoPosesIsRefused) {
    spec_.bodies.push_back(body_entry("car.0"));
    spec_.bodies[2] = body_entry("car.1");
    spec_.bodies[2].pose = Pose();
    spec_.bodies[2].line = 12;
    EXPECT_THAT(
        problem(),
        AllOf(HasSubstr("job.toml:12: [bodies] car.1: \"car.1\" has a pose here, and rows in"),
              HasSubstr("all.csv; leave one of them out")));
}

TEST_F(SceneSteps, RowsOfAnUnknownBodyAreRefused) {
    spec_.poses->file = file("all.csv", "step,body,x\n0,car.0,3\n0,cra.1,4\n");
    EXPECT_THAT(problem(),
                HasSubstr("all.csv: line 3: no body of [bodies] is called \"cra.1\"; did you mean "
                          "\"car.1\"?"));
}

TEST_F(SceneSteps, FilesHaveTheSameSteps) {
    spec_.bodies[0].poses = file("truck.csv", "x\n1\n2\n3\n");
    EXPECT_THAT(problem(),
                AllOf(HasSubstr("truck.csv has poses for 3 steps, and"),
                      HasSubstr("all.csv for 2; each body that moves needs a pose for each step")));
    spec_.bodies[0].poses = file("truck.csv", "x,t\n1,0.5\n2,0.8\n");
    EXPECT_THAT(problem(), HasSubstr("a step has one time for all bodies"));
    spec_.bodies[0].poses = file("truck.csv", "x\n1\n2\n");
    EXPECT_EQ(problem(), "none");
}

TEST_F(SceneSteps, ErrorsOfFilesAreTold) {
    spec_.bodies[0].poses->path = folder_ / "missing.csv";
    EXPECT_THAT(problem(), HasSubstr("missing.csv: cannot be opened"));
    spec_.poses->file.path = folder_ / "none.csv";
    EXPECT_THAT(problem(), HasSubstr("none.csv: cannot be opened"));
}

} // namespace cd::tests
