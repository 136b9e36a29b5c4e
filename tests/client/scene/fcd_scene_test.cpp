// Proves that the vehicles of SUMO become bodies of a scene, present where the file has them, and
// that two that meet at a crossing are paired at the steps at which they do.
#include "client/scene/prepared_scene.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A box of 4 by 2 by 1, whose front is at x = 6.
constexpr const char* box = "v 2 -1 0\nv 6 -1 0\nv 6 1 0\nv 2 1 0\nv 2 -1 1\nv 6 -1 1\nv 6 1 1\n"
                            "v 2 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
                            "f 4 1 5 8\n";

/// Car "e" drives east along y = 0, by 4 a step. Car "n" comes from the south along x = 20, and
/// waits with its front at y = 0 from step 3 on. Step 7 does not have it.
std::string crossing() {
    std::string text = "<fcd-export>\n";
    for (int s = 0; s < 9; ++s) {
        const int north = s < 3 ? 4 * s - 10 : 0;
        text += "<timestep time=\"" + std::to_string(s) + "\">\n";
        text += "<vehicle id=\"e\" x=\"" + std::to_string(4 * s) +
                "\" y=\"0\" angle=\"90\" type=\"passenger\"/>\n";
        text += s == 7 ? ""
                       : "<vehicle id=\"n\" x=\"20\" y=\"" + std::to_string(north) +
                             "\" angle=\"0\" type=\"passenger\"/>\n";
        text += "</timestep>\n";
    }
    return text + "</fcd-export>\n";
}

class FcdScene : public testing::Test {
  protected:
    FcdScene() {
        write_text(folder_ / "box.obj", box);
        write_text(folder_ / "fcd.xml", crossing());
    }

    /// Prepares a job with these further entries of [bodies] and tables.
    Result<PreparedScene> prepared(const std::string& bodies = "", const std::string& tables = "") {
        write_text(
            folder_ / "job.toml",
            "[bodies]\ncar = { mesh = \"box.obj\", origin = [6, 0, 0], group = \"traffic\" }\n" +
                bodies +
                "[poses]\nfcd = { file = \"fcd.xml\", types = { passenger = \"car\" } }\n" +
                tables);
        const auto spec = read_job_file(folder_ / "job.toml");
        return spec ? prepare_scene(spec.value(), true) : spec.error();
    }

    TemporaryFolder folder_;
};

} // namespace

TEST_F(FcdScene, VehiclesAreBodiesWithTheirIds) {
    const auto scene = prepared("post = { mesh = \"box.obj\", pose = [0, 0, 9, 0, 0, 0, 1], "
                                "quat_order = \"xyzw\" }\n");
    ASSERT_TRUE(scene) << scene.error().detail;
    std::vector<std::string> names;
    for (const NamedBody& body : scene.value().scene.bodies) {
        names.push_back(body.name);
    }
    EXPECT_THAT(names, ElementsAre("e", "n", "post"));
    EXPECT_EQ(scene.value().scene.bodies[0].group, "traffic");
    EXPECT_EQ(scene.value().scene.bodies[0].mesh, scene.value().scene.bodies[1].mesh);
    EXPECT_THAT(scene.value().are_fixed, ElementsAre(false, false, true));
    EXPECT_THAT(scene.value().facts.absences, ElementsAre(0, 1, 0));
}

TEST_F(FcdScene, TwoVehiclesArePairedWhereTheyMeet) {
    const auto scene = prepared();
    ASSERT_TRUE(scene) << scene.error().detail;
    ASSERT_EQ(scene.value().steps->steps(), 9u);
    // From step 3 on, n covers x in [19, 21] and y in [-4, 0]. e covers x in [4s - 4, 4s] and y in
    // [-1, 1], so they meet at steps 5 and 6; at step 7, n is absent, and at step 8 e has passed.
    std::vector<std::uint64_t> steps;
    for (std::uint64_t i = 0; i < scene.value().poses->count(); ++i) {
        steps.push_back(scene.value().steps->step_of(i));
    }
    EXPECT_THAT(steps, ElementsAre(5, 6));
}

TEST_F(FcdScene, VehiclesThatJumpPastEachOtherArePairedByMotionsAlone) {
    write_text(
        folder_ / "fcd.xml",
        "<fcd-export>\n<timestep time=\"0\">\n"
        "<vehicle id=\"e\" x=\"0\" y=\"0\" angle=\"90\" type=\"passenger\"/>\n"
        "<vehicle id=\"w\" x=\"20\" y=\"1\" angle=\"270\" type=\"passenger\"/>\n</timestep>\n"
        "<timestep time=\"1\">\n"
        "<vehicle id=\"e\" x=\"20\" y=\"0\" angle=\"90\" type=\"passenger\"/>\n"
        "<vehicle id=\"w\" x=\"0\" y=\"1\" angle=\"270\" type=\"passenger\"/>\n</timestep>\n"
        "</fcd-export>\n");
    const auto at_rest = prepared();
    ASSERT_TRUE(at_rest) << at_rest.error().detail;
    EXPECT_EQ(at_rest.value().poses->count(), 0u);
    const auto moving = prepared("", "[motion]\nresolution = 0.01\n");
    ASSERT_TRUE(moving) << moving.error().detail;
    EXPECT_EQ(moving.value().steps->steps(), 1u);
    const auto scenarios = moving.value().poses->read(0, 1);
    ASSERT_TRUE(scenarios);
    ASSERT_TRUE(scenarios.value()[0].to);
    EXPECT_EQ(scenarios.value()[0].to->a.translation(), Vec3(20, 0, 0));
    EXPECT_EQ(scenarios.value()[0].step, 0u);
}

TEST_F(FcdScene, AVehicleMayNotHaveTheNameOfAnotherBody) {
    EXPECT_THAT(prepared("n = { mesh = \"box.obj\", pose = [0, 0, 9, 0, 0, 0, 1], quat_order = "
                         "\"xyzw\" }\n")
                    .error()
                    .detail,
                HasSubstr("job.toml:3: [bodies] n: a body \"n\" exists already, of line 2"));
}

TEST_F(FcdScene, AFileWithoutVehiclesHasNoBodies) {
    write_text(folder_ / "fcd.xml", "<fcd-export><timestep time=\"0\"/></fcd-export>");
    EXPECT_THAT(prepared().error().detail, HasSubstr("[bodies] has no body; at least two"));
}

TEST_F(FcdScene, OtherFilesHaveItsSteps) {
    write_text(folder_ / "crane.csv", "x\n1\n2\n");
    EXPECT_THAT(prepared("crane = { mesh = \"box.obj\", poses = \"crane.csv\" }\n").error().detail,
                HasSubstr("crane.csv has poses for 2 steps, and"));
}

} // namespace cd::tests
