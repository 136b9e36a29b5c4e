// Proves that a job's lines cover a body from every direction asked for, and that poses have ids.
#include "client/bundle/shot_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

Aabb box_of(const Vec3& low, const Vec3& high) {
    Aabb box;
    box.min = low;
    box.max = high;
    return box;
}

ShotsSpec some_grid() {
    ShotsSpec spec;
    spec.grid.spacing = 0.25;
    spec.grid.tile = 4;
    spec.azimuth_deg = {0, 90, 2};
    spec.elevation_deg = {-45, 45, 3};
    spec.place = "job.toml:3: [shots]: ";
    return spec;
}

} // namespace

TEST(ShotPlan, AGridHasOneBundleAndPosesInAllDirections) {
    const ShotsSpec spec = some_grid();
    const Aabb box = box_of(Vec3(-1, -2, 0), Vec3(3, 2, 1));
    EXPECT_EQ(shot_mesh(spec, box).value().triangles().size(), 16u);
    const std::vector<BundlePose> poses = shot_poses(spec, box).value();
    std::set<std::uint32_t> views;
    for (const BundlePose& pose : poses) {
        views.insert(pose.view);
    }
    EXPECT_EQ(views.size(), 6u);
    EXPECT_GT(poses.size(), 60u) << "a body of 4 by 4 by 1 takes several tiles of 1 by 1";
}

TEST(ShotPlan, EachPoseOfAGridHasAnIdOfItsOwn) {
    const ShotsSpec spec = some_grid();
    const Aabb box = box_of(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const auto poses = shot_poses(spec, box).value();
    const PoseLabels labels = shot_labels(spec, poses);
    ASSERT_EQ(labels.texts.size(), poses.size());
    EXPECT_THAT(labels.texts.front(), HasSubstr("az=0 el=-45 tile="));
    EXPECT_THAT(labels.texts.back(), HasSubstr("az=90 el=45 tile="));
    const std::set<std::string> distinct(labels.texts.begin(), labels.texts.end());
    EXPECT_EQ(distinct.size(), poses.size());
    const ShotViews views(spec, box);
    ASSERT_EQ(views.bundles(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_EQ(views.id_of(i), labels.texts[i]);
    }
}

TEST(ShotPlan, LinesOfAFileStandWhereTheyAre) {
    ShotsSpec spec;
    spec.file = "/none/rays.npy";
    const Aabb box = box_of(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const auto poses = shot_poses(spec, box).value();
    ASSERT_EQ(poses.size(), 1u);
    EXPECT_EQ(poses.front().pose.apply(Vec3(1, 2, 3)), Vec3(1, 2, 3));
    EXPECT_TRUE(shot_labels(spec, poses).is_empty());
    EXPECT_EQ(ShotViews(spec, box).id_of(0), "");
    EXPECT_EQ(shot_mesh(spec, box).error().code, ErrorCode::NotFound);
}

TEST(ShotPlan, TooManyPosesAreRefusedWhereTheLinesAreAskedFor) {
    ShotsSpec spec = some_grid();
    spec.grid.spacing = 1e-6;
    const auto poses = shot_poses(spec, box_of(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_THAT(poses.error().detail, HasSubstr("job.toml:3: [shots]: "));
    EXPECT_THAT(poses.error().detail, HasSubstr("Take a larger spacing"));
}

TEST(ShotPlan, ViewsTellWhereALineIs) {
    const ShotsSpec spec = some_grid();
    const Aabb box = box_of(Vec3(-1, -2, 0), Vec3(3, 2, 1));
    const ShotViews views(spec, box);
    ASSERT_EQ(views.count(), 6u);
    EXPECT_EQ(views.cell_area(), 0.0625);
    const std::vector<BundlePose> poses = shot_poses(spec, box).value();
    const Mesh lines = shot_mesh(spec, box).value();
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
        const std::uint32_t view = views.view_of(i);
        ASSERT_EQ(view, poses[i].view);
        EXPECT_EQ(views.rotation(view), poses[i].pose.rotation());
        // Along the axes of the view, a line is as many cells from the first one as its place says.
        const auto first = static_cast<std::uint32_t>(
            std::ranges::find(poses, view, &BundlePose::view) - poses.begin());
        const Vec3 from = poses[first].pose.apply(lines.corners(0)[0]);
        for (const std::uint32_t line : {0u, 5u, 15u}) {
            const Vec3 way = views.rotation(view).transpose() *
                             (poses[i].pose.apply(lines.corners(line)[0]) - from);
            const LinePlace place = views.place_of(i, line);
            EXPECT_NEAR(way.y(), 0.25 * static_cast<double>(place.column), 1e-12);
            EXPECT_NEAR(way.z(), 0.25 * static_cast<double>(place.row), 1e-12);
            EXPECT_LT(place.column, views.size(view).column);
            EXPECT_LT(place.row, views.size(view).row);
        }
    }
}

TEST(ShotPlan, LinesOfAFileHaveOneViewWithoutCells) {
    ShotsSpec spec;
    spec.file = "rays.npy";
    const ShotViews views(spec, box_of(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_EQ(views.count(), 1u);
    EXPECT_EQ(views.view_of(0), 0u);
    EXPECT_EQ(views.cell_area(), 0);
    EXPECT_EQ(views.size(0).column, 0u);
    EXPECT_EQ(views.rotation(0), Mat3(Mat3::Identity()));
}

TEST(ShotPlan, LinesStandAlikeIfTheirBundlesDo) {
    ShotsSpec one = some_grid();
    one.box = box_of(Vec3(0, 0, 0), Vec3(1, 1, 1));
    ShotsSpec other = one;
    other.place = {};
    EXPECT_TRUE(stand_alike(one, other));
    other.grid.offset = {0.25, 0.5};
    EXPECT_TRUE(stand_alike(one, other)) << "lines move within their bundles";
    other.grid.tile = 8;
    EXPECT_FALSE(stand_alike(one, other));
    other = one;
    other.azimuth_deg.last = 60;
    EXPECT_FALSE(stand_alike(one, other));
    other = one;
    other.box->max.x() = 2;
    EXPECT_FALSE(stand_alike(one, other));
    other = {};
    other.file = "lines.npy";
    EXPECT_FALSE(stand_alike(one, other));
    EXPECT_TRUE(stand_alike(other, other));
}

} // namespace cd::tests
