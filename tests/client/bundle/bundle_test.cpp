// Proves that a grid of lines covers a body from every direction, each part of it once, and that
// lines come from where a view says.
#include "client/bundle/bundle_poses.hpp"
#include "client/bundle/line_bundle.hpp"
#include "common/core/limits/client.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

LineGrid line_grid(double spacing, std::uint32_t tile) {
    LineGrid grid;
    grid.spacing = spacing;
    grid.tile = tile;
    return grid;
}

/// Returns where lines of a view come from.
Vec3 origin_of(double azimuth_deg, double elevation_deg) {
    return Pose::from_quaternion(view_rotation({azimuth_deg, elevation_deg}), Vec3::Zero())
        .apply(Vec3(1, 0, 0));
}

/// Returns the number of tiles of view 0 whose square a point of the world is in.
int tiles_around(const Vec3& point, const std::vector<BundlePose>& poses, double width) {
    int count = 0;
    for (const BundlePose& tile : poses) {
        const Vec3 at = tile.pose.rotation().transpose() * (point - tile.pose.translation());
        count += std::abs(at.y()) < width / 2 && std::abs(at.z()) < width / 2 ? 1 : 0;
    }
    return count;
}

/// Returns the number of crossings of all lines with a body.
std::uint64_t
crossings(const Mesh& body, const LineGrid& grid, const std::vector<BundlePose>& poses) {
    const ObbTree a = make_tree(body);
    const ObbTree b =
        make_tree(make_bundle(grid, bundle_reach(bounding_box(body.vertices()))).value());
    Query query = query_of(Level::Count);
    query.question = Question::Shots;
    query.maps = true;
    std::uint64_t count = 0;
    for (const BundlePose& tile : poses) {
        count += run_scenario(a, b, make_scenario({Pose(), tile.pose}), query).found.size();
    }
    return count;
}

} // namespace

TEST(ShotView, LinesComeFromWhereItLooksFrom) {
    EXPECT_EQ(origin_of(0, 0), Vec3(1, 0, 0)) << "the front";
    EXPECT_EQ(origin_of(90, 0), Vec3(0, 1, 0)) << "the left";
    EXPECT_EQ(origin_of(180, 0), Vec3(-1, 0, 0));
    EXPECT_EQ(origin_of(270, 0), Vec3(0, -1, 0));
    EXPECT_EQ(origin_of(0, 90), Vec3(0, 0, 1)) << "above";
    EXPECT_EQ(origin_of(0, -90), Vec3(0, 0, -1));
    constexpr double degree = 0.017453292519943295;
    for (const auto& [az, el] : {std::pair{30.0, 10.0}, {125.0, -70.0}, {-45.0, 33.0}}) {
        const Vec3 expected(std::cos(el * degree) * std::cos(az * degree),
                            std::cos(el * degree) * std::sin(az * degree),
                            std::sin(el * degree));
        EXPECT_LT((origin_of(az, el) - expected).norm(), 1e-14);
    }
}

TEST(LineBundle, LinesPassThroughTheMiddlesOfCells) {
    const Mesh bundle = make_bundle(line_grid(0.25, 4), 8).value();
    ASSERT_EQ(bundle.triangles().size(), 16u);
    for (std::uint32_t i = 0; i < 16; ++i) {
        const Corners line = bundle.corners(i);
        const double y = -0.375 + 0.25 * (i % 4);
        const double z = -0.375 + 0.25 * (i / 4);
        EXPECT_EQ(line[0], Vec3(8, y, z));
        EXPECT_EQ(line[1], Vec3(-8, y, z));
        EXPECT_EQ(line[2], line[1]);
    }
    LineGrid shifted = line_grid(0.25, 4);
    shifted.offset = {0, 0.25};
    EXPECT_EQ(make_bundle(shifted, 8).value().corners(0)[0], Vec3(8, -0.5, -0.4375));
}

TEST(LineBundle, JitterStaysInTheCellAndDependsOnTheSeed) {
    LineGrid grid = line_grid(1, 16);
    grid.jitter_seed = 1;
    const Mesh bundle = make_bundle(grid, 8).value();
    std::set<double> places;
    for (std::uint32_t i = 0; i < 256; ++i) {
        const Vec3 at = bundle.corners(i)[0] + Vec3(0, 8.0 - i % 16, 8.0 - i / 16);
        EXPECT_GE(at.y(), 0);
        EXPECT_LT(at.y(), 1);
        EXPECT_GE(at.z(), 0);
        EXPECT_LT(at.z(), 1);
        places.insert(at.y());
        places.insert(at.z());
    }
    EXPECT_GT(places.size(), 500u);
    EXPECT_EQ(make_bundle(grid, 8).value().hash(), bundle.hash());
    grid.jitter_seed = 2;
    EXPECT_NE(make_bundle(grid, 8).value().hash(), bundle.hash());
}

TEST(LineBundle, RefusesNumbersThatMakeNoGrid) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double spacing : {0.0, -1.0, std::nan(""), infinity, 1e308}) {
        EXPECT_THAT(check_grid(line_grid(spacing, 64)).error().detail, HasSubstr("spacing"));
    }
    for (const std::uint32_t tile : {0u, limits::bundle_side_max + 1}) {
        EXPECT_THAT(check_grid(line_grid(1, tile)).error().detail, HasSubstr("tile"));
    }
    for (const double offset : {-0.1, 1.1, std::nan("")}) {
        LineGrid grid;
        grid.offset[1] = offset;
        EXPECT_THAT(check_grid(grid).error().detail, HasSubstr("offset"));
    }
    EXPECT_TRUE(check_grid(LineGrid{}));
    EXPECT_FALSE(line_mesh({})) << "no lines";
    EXPECT_FALSE(line_mesh({{Vec3(infinity, 0, 0), Vec3(0, 0, 0)}}));
}

TEST(BundlePoses, CoverEachPointOfTheBoxOnce) {
    const LineGrid grid = line_grid(0.1, 4);
    for (SeededRandom random : seeds(40)) {
        const Vec3 middle = random_point(random, 50);
        Aabb box;
        for (int i = 0; i < 3; ++i) {
            box.add(middle + random_point(random, 1));
        }
        const std::vector<ShotView> views{{uniform(random, -360, 360), uniform(random, -90, 90)}};
        const auto poses = bundle_poses(grid, views, box).value();
        for (int i = 0; i < 20; ++i) {
            const Vec3 share(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
            const Vec3 point = box.min + share.cwiseProduct(box.size());
            ASSERT_EQ(tiles_around(point, poses, grid.width()), 1);
        }
        EXPECT_LE(poses.size(), std::pow(std::ceil(box.diagonal() / grid.width()) + 2, 2));
        for (const BundlePose& tile : poses) {
            // Both ends are farther from the box's middle than the box reaches.
            const Vec3 from = tile.pose.apply(Vec3(bundle_reach(box), 0, 0)) - box.center();
            ASSERT_GT(from.dot(tile.pose.rotation().col(0)), box.diagonal() / 2);
        }
    }
}

TEST(BundlePoses, AreInOrderOfViewRowAndColumn) {
    Aabb box;
    box.add(Vec3(-3, -3, -3));
    box.add(Vec3(3, 3, 3));
    const std::vector<ShotView> views{{0, 0}, {30, 20}, {0, 90}};
    const auto poses = bundle_poses(line_grid(0.5, 4), views, box).value();
    const auto key = [](const BundlePose& p) { return std::tuple(p.view, p.row, p.column); };
    for (std::size_t i = 1; i < poses.size(); ++i) {
        EXPECT_LT(key(poses[i - 1]), key(poses[i]));
    }
    EXPECT_EQ(poses.back().view, 2u);
}

TEST(BundlePoses, TooManyAreRefused) {
    Aabb box;
    box.add(Vec3(0, 0, 0));
    box.add(Vec3(1, 1, 1));
    const std::vector<ShotView> one{{0, 0}};
    EXPECT_THAT(bundle_poses(line_grid(1e-9, 1), one, box).error().detail, HasSubstr("at most"));
    EXPECT_THAT(bundle_poses(line_grid(1e-300, 1), one, box).error().detail, HasSubstr("at most"));
    const std::vector<ShotView> none{{std::nan(""), 0}};
    EXPECT_THAT(bundle_poses(LineGrid{}, none, box).error().detail, HasSubstr("not finite"));
    EXPECT_TRUE(bundle_poses(LineGrid{}, {}, box).value().empty());
}

TEST(BundlePoses, LinesEnterAndLeaveABoxOverItsShadow) {
    const Mesh body = make_box(Vec3(2, 2, 2));
    const LineGrid grid = line_grid(0.25, 4);
    const Aabb box = bounding_box(body.vertices());
    for (const ShotView& view : {ShotView{0, 0}, ShotView{90, 0}, ShotView{0, 90}}) {
        const auto poses = bundle_poses(grid, std::vector{view}, box).value();
        EXPECT_EQ(crossings(body, grid, poses), 2u * 64); // 8 x 8 lines, each twice.
    }
    const auto poses = bundle_poses(grid, std::vector<ShotView>{{45, 0}}, box).value();
    const double shadow = 2 * 2 * std::sqrt(2.0) / (0.25 * 0.25);
    EXPECT_NEAR(static_cast<double>(crossings(body, grid, poses)), 2 * shadow, 24);
}

} // namespace cd::tests
