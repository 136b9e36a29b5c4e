// Proves that the poses of a scene's bodies are read from tables and arrays as the exact numbers of
// their file, that bodies are absent only where the file says so, and that every error names its
// place.
#include "client/poses/pose_file.hpp"
#include "client/poses/scene_csv.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::string header = "step,body,x,y,z,qx,qy,qz,qw\n";

class SceneFile : public testing::Test {
  protected:
    ScenePosesSpec spec(const std::string& name) {
        ScenePosesSpec made;
        made.file.path = folder_ / name;
        return made;
    }
    ScenePosesSpec csv(const std::string& text) {
        write_text(folder_ / "p.csv", text);
        return spec("p.csv");
    }
    ScenePosesSpec npy(const std::vector<std::uint64_t>& shape, const std::vector<double>& values) {
        const Bytes head = make_npy_header(NpyType::F8, shape);
        std::string text(reinterpret_cast<const char*>(head.data()), head.size());
        text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
        write_text(folder_ / "p.npy", text);
        ScenePosesSpec made = spec("p.npy");
        made.file.quat_order = "xyzw";
        made.body_order = {"a", "b"};
        return made;
    }

    /// Returns the x of each pose, step by step; NaN for an absent body.
    static std::vector<double> x_of(const OpenedTable& opened) {
        std::vector<double> x;
        const auto poses = poses_of_rows(opened.table, 0, opened.table.rows->row_count());
        EXPECT_TRUE(poses);
        for (const auto& pose : poses.value()) {
            x.push_back(pose ? pose->translation().x() : nan);
        }
        return x;
    }
    static std::string error_of(const ScenePosesSpec& spec) {
        const auto opened = open_scene_poses(spec);
        return opened ? "was taken" : opened.error().detail;
    }

    TemporaryFolder folder_;
};

std::string row(const std::string& place, double x) {
    return place + "," + std::to_string(x) + ",0,0,0,0,0,1\n";
}

} // namespace

TEST_F(SceneFile, RowsMayComeInAnyOrder) {
    const auto opened = open_scene_poses(
        csv(header + row("1,car", 3) + row("0,bus", 2) + row("0,car", 1) + row("1,bus", 4)));
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().table.bodies, (std::vector<std::string>{"car", "bus"}));
    EXPECT_EQ(x_of(opened.value()), (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(opened.value().table.lines, (std::vector<std::uint64_t>{4, 3, 2, 5}));
}

TEST_F(SceneFile, ColumnsMayBeAnglesOrAMatrix) {
    const auto angles = open_scene_poses(csv("body,yaw_deg,step,x\ncar,90,0,7\n"));
    ASSERT_TRUE(angles) << angles.error().detail;
    EXPECT_EQ(angles.value().table.zeros, (std::vector<std::string>{"y", "z", "roll", "pitch"}));
    const auto poses = poses_of_rows(angles.value().table, 0, 1);
    ASSERT_TRUE(poses);
    EXPECT_EQ(*poses.value()[0], Pose::from_quaternion(quaternion_from_euler(0, 0, 90), {7, 0, 0}));
    const auto matrix =
        open_scene_poses(csv("step,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n"
                             "0,car,0,-1,0,5,1,0,0,6,0,0,1,7\n"));
    ASSERT_TRUE(matrix) << matrix.error().detail;
    const auto turned = poses_of_rows(matrix.value().table, 0, 1);
    ASSERT_TRUE(turned);
    Mat3 expected;
    expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_EQ(*turned.value()[0], Pose::from_matrix(expected, Vec3(5, 6, 7)));
}

TEST_F(SceneFile, ABodyIsAbsentOnlyWhereTheFileMaySaySo) {
    const std::string text =
        header + row("0,car", 1) + "1,car,nan,nan,nan,nan,nan,nan,nan\n" + row("2,car", 3);
    EXPECT_THAT(error_of(csv(text)), HasSubstr("p.csv: line 3: x is 'nan', not a number"));
    ScenePosesSpec absent = csv(text);
    absent.nan_is_absent = true;
    const auto opened = open_scene_poses(absent);
    ASSERT_TRUE(opened) << opened.error().detail;
    const std::vector<double> x = x_of(opened.value());
    ASSERT_EQ(x.size(), 3u);
    EXPECT_EQ(x[0], 1);
    EXPECT_TRUE(std::isnan(x[1]));
    EXPECT_EQ(x[2], 3);
    ScenePosesSpec half = csv(header + "0,car,1,0,0,nan,nan,nan,nan\n");
    half.nan_is_absent = true;
    EXPECT_THAT(error_of(half), HasSubstr("line 2: qx is 'nan', not a number"));
    ScenePosesSpec other = csv(header + "0,car,nan,nan,nan,0,0,0,1\n");
    other.nan_is_absent = true;
    EXPECT_THAT(error_of(other), HasSubstr("line 2: x is 'nan', not a number"));
}

TEST_F(SceneFile, AnArrayHasAnAxisOfBodies) {
    const auto opened =
        open_scene_poses(npy({2, 2, 7}, {1, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 1,
                                         3, 0, 0, 0, 0, 0, 1, 4, 0, 0, 0, 0, 0, 1}));
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().table.bodies, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(x_of(opened.value()), (std::vector<double>{1, 2, 3, 4}));
    const std::vector<double> values(14, 0.0);
    EXPECT_THAT(error_of(npy({1, 2, 7}, values)),
                HasSubstr("p.npy: row 0, body a: the quaternion is zero"));
    ScenePosesSpec nameless = npy({1, 2, 7}, values);
    nameless.body_order.clear();
    EXPECT_THAT(error_of(nameless), HasSubstr("give [poses] body_order"));
    ScenePosesSpec three = npy({1, 2, 7}, values);
    three.body_order.push_back("c");
    EXPECT_THAT(error_of(three),
                HasSubstr("shape (1, 2, 7); body_order names 3 bodies, so the second axis has to"));
    ScenePosesSpec bare = npy({1, 2, 7}, values);
    bare.file.quat_order.clear();
    EXPECT_THAT(error_of(bare), HasSubstr("a bare (N, bodies, 7) array"));
    EXPECT_THAT(error_of(npy({1, 2, 6}, std::vector<double>(12, 0.0))),
                HasSubstr("expected (N,bodies,7)"));
    EXPECT_THAT(error_of(npy({2}, {1, 2})), HasSubstr("shape (2); body_order names 2 bodies"));
}

TEST_F(SceneFile, AnArrayNamesAbsentBodiesByNan) {
    const std::vector<double> values{1, 0, 0, 0, 0, 0, 1, nan, nan, nan, nan, nan, nan, nan};
    EXPECT_THAT(error_of(npy({1, 2, 7}, values)),
                HasSubstr("row 0, body b: the number nan is not finite"));
    ScenePosesSpec absent = npy({1, 2, 7}, values);
    absent.nan_is_absent = true;
    const auto opened = open_scene_poses(absent);
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_TRUE(std::isnan(x_of(opened.value())[1]));
    std::vector<double> half = values;
    half[13] = 1;
    ScenePosesSpec other = npy({1, 2, 7}, half);
    other.nan_is_absent = true;
    EXPECT_THAT(error_of(other), HasSubstr("row 0, body b: the number nan is not finite"));
}

TEST_F(SceneFile, EachStepHasEachBodyOnce) {
    EXPECT_THAT(error_of(csv(header + row("0,car", 1) + row("0,bus", 2) + row("1,car", 3))),
                HasSubstr("step 1 has no row of body bus; for an absent body write nan"));
    EXPECT_THAT(error_of(csv(header + row("0,car", 1) + row("2,car", 3))),
                HasSubstr("step 1 has no row of body car"));
    EXPECT_THAT(error_of(csv(header + row("1000000000,car", 1))),
                HasSubstr("step 0 has no row of body car"));
    EXPECT_THAT(error_of(csv(header + row("0,car", 1) + row("0,car", 3))),
                HasSubstr("line 3: step 0 has body car twice"));
    EXPECT_THAT(error_of(csv(header + row("-1,car", 1))), HasSubstr("step is '-1', not a count"));
    EXPECT_THAT(error_of(csv(header)), HasSubstr("has no poses"));
    EXPECT_THAT(error_of(csv(header + "0,car,1\n")), HasSubstr("line 2: 3 values, but"));
}

TEST_F(SceneFile, TimesAreThoseOfTheSteps) {
    const std::string timed = "t," + header;
    const auto opened = open_scene_poses(csv(timed + row("0.5,0,car", 1) + row("0.5,0,bus", 1) +
                                             row("0.75,1,car", 1) + row("0.75,1,bus", 1)));
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().table.labels.times, (std::vector<double>{0.5, 0.75}));
    EXPECT_THAT(error_of(csv(timed + row("1,0,car", 1) + row("2,0,bus", 1))),
                HasSubstr("line 3: step 0 has another t in line 2"));
    EXPECT_THAT(error_of(csv(timed + row("1,0,car", 1) + row("1,1,car", 1))),
                HasSubstr("line 3: t does not rise from step 0 to step 1"));
    EXPECT_THAT(error_of(csv(timed + row("x,0,car", 1))), HasSubstr("line 2: t is 'x'"));
}

TEST_F(SceneFile, TheFirstLineNamesStepAndBody) {
    EXPECT_THAT(error_of(csv("step,x\n0,1\n")), HasSubstr("need the columns 'step' and 'body'"));
    EXPECT_THAT(error_of(csv("scenario,body,step,x\n0,a,0,1\n")),
                HasSubstr("line 1: column 'scenario' is for two bodies; a scene has 'step'"));
    EXPECT_THAT(error_of(csv("step,body,x,vx,vy\n0,car,1,2,3\n")),
                HasSubstr("line 1: column 'vx' needs column 'vz' as well"));
    EXPECT_THAT(error_of(csv("step,body,x,vx,vy,vz\n0,car,1,2,3,nan\n")),
                HasSubstr("line 2: vz is 'nan', not a number"));
    ScenePosesSpec named = csv(header + row("0,car", 1));
    named.body_order = {"car"};
    EXPECT_THAT(error_of(named), HasSubstr("leave body_order out"));
    write_text(folder_ / "p.tum", "0 0 0 0 0 0 0 1\n");
    EXPECT_THAT(error_of(spec("p.tum")), HasSubstr("use .csv or .npy for a scene"));
    PoseFileSpec two_bodies;
    two_bodies.path = csv(header + row("0,car", 1)).file.path;
    EXPECT_THAT(open_pose_file(two_bodies).error().detail,
                HasSubstr("column 'step' is for the [poses] of a job with [bodies]"));
}

TEST_F(SceneFile, ATableOfManyRowsIsReadInParts) {
    std::string text = header;
    for (int step = 0; step < 100; ++step) {
        text +=
            row(std::to_string(step) + ",car", step) + row(std::to_string(step) + ",bus", -step);
    }
    const auto opened = open_scene_poses(csv(text));
    ASSERT_TRUE(opened) << opened.error().detail;
    for (std::uint64_t step = 0; step < 100; ++step) {
        const auto poses = poses_of_rows(opened.value().table, step, 1);
        ASSERT_TRUE(poses);
        ASSERT_EQ(poses.value().size(), 2u);
        EXPECT_EQ(poses.value()[0]->translation().x(), static_cast<double>(step));
        EXPECT_EQ(poses.value()[1]->translation().x(), -static_cast<double>(step));
    }
}

} // namespace cd::tests
