// Proves that grids and lists give equal scenarios however they are read, that quarter turns are
// exact, and that a grid's description survives the wire while hostile bytes are rejected.

#include "common/job/poses/pose_source.hpp"

#include "common/core/limits/engine.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/scenarios.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

Grid make_grid() {
    Grid grid;
    grid.position = {GridAxis{-3, 3, 4}, GridAxis{0.5, 0.5, 1}, GridAxis{1, -1, 3}};
    grid.rotation[2] = rotation_axis({0, 270, 4}, 2);
    grid.rotation[0] = rotation_axis({-10, 10, 2}, 0);
    return grid;
}

Mat3 rotation_of(const Quaternion& q) {
    return Pose::from_quaternion(q, Vec3::Zero()).rotation();
}

/// Makes a turn about an axis by an angle of this cosine and sine.
Mat3 turn_about(int axis, double c, double s) {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    Mat3 matrix = Mat3::Identity();
    matrix(i, i) = c;
    matrix(j, j) = c;
    matrix(j, i) = s;
    matrix(i, j) = -s;
    return matrix;
}

} // namespace

TEST(GridAxis, EndsAreExactAndTheFormulaIsFixed) {
    const GridAxis axis{0.1, 0.7, 4};
    EXPECT_EQ(axis.at(0), 0.1);
    EXPECT_EQ(axis.at(1), 0.1 + (0.7 - 0.1) * 1.0 / 3.0);
    EXPECT_EQ(axis.at(3), 0.7);
    EXPECT_EQ((GridAxis{5, 9, 1}.at(0)), 5.0);
}

TEST(Grid, YawRunsFastestAndXSlowest) {
    const Grid grid = make_grid();
    ASSERT_EQ(grid.count(), 4u * 1 * 3 * 2 * 4);
    EXPECT_EQ(grid.at(0).translation(), Vec3(-3, 0.5, 1));
    EXPECT_EQ(grid.at(7).translation(), Vec3(-3, 0.5, 1));
    EXPECT_EQ(grid.at(8).translation(), Vec3(-3, 0.5, 0));
    EXPECT_EQ(grid.at(24).translation(), Vec3(-1, 0.5, 1));
    EXPECT_EQ(grid.at(95).translation(), Vec3(3, 0.5, -1));

    const Quaternion expected =
        rotation_axis({270, 270, 1}, 2)[0] * rotation_axis({10, 10, 1}, 0)[0];
    EXPECT_EQ(grid.at(7).quaternion(), expected);
}

TEST(Grid, CountSaturates) {
    Grid grid;
    for (GridAxis& axis : grid.position) {
        axis.count = std::uint64_t{1} << 40;
    }
    EXPECT_EQ(grid.count(), UINT64_MAX);
    grid.position[2].count = 0;
    EXPECT_EQ(grid.count(), 0u);
    EXPECT_EQ(Grid{}.count(), 1u);
}

TEST(Grid, RangesReadOneByOneEqualTheWhole) {
    const auto source = make_grid_source(make_grid());
    const auto whole = source->read(0, source->count());
    ASSERT_TRUE(whole);
    ASSERT_EQ(whole.value().size(), source->count());
    for (std::uint64_t first = 0; first < source->count(); first += 7) {
        const std::uint64_t count = std::min<std::uint64_t>(7, source->count() - first);
        const auto run = source->read(first, count);
        ASSERT_TRUE(run);
        for (std::uint64_t i = 0; i < count; ++i) {
            EXPECT_EQ(run.value()[i], scenario_on(*source->grid(), first + i));
            EXPECT_EQ(run.value()[i], whole.value()[first + i]);
            EXPECT_EQ(run.value()[i].index, first + i);
            EXPECT_EQ(run.value()[i].poses.a, Pose{});
        }
    }
}

TEST(Rotation, QuarterTurnsAreExact) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int quarter = -9; quarter <= 9; ++quarter) {
            const Mat3 rotation = rotation_of(rotation_axis({90.0 * quarter, 0, 1}, axis)[0]);
            constexpr std::array<int, 4> cosine{1, 0, -1, 0};
            const int c = cosine[static_cast<std::size_t>(quarter & 3)];
            const int s = cosine[static_cast<std::size_t>((quarter + 3) & 3)];
            ASSERT_EQ(rotation, turn_about(axis, c, s))
                << "axis " << axis << " quarter " << quarter;
        }
    }
}

TEST(Rotation, EulerAnglesRollFirstThenPitchThenYaw) {
    const double degree = std::acos(-1.0) / 180;
    const double roll = 20;
    const double pitch = -35;
    const double yaw = 110;
    const auto turn = [&](double degrees, int axis) {
        return turn_about(axis, std::cos(degrees * degree), std::sin(degrees * degree));
    };
    const Mat3 expected = turn(yaw, 2) * turn(pitch, 1) * turn(roll, 0);
    const Mat3 actual = rotation_of(quaternion_from_euler(roll, pitch, yaw));
    EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(GridBytes, ComeBackAsTheyWere) {
    const auto decoded = decode_grid(encode_grid(make_grid()));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded.value(), make_grid());
}

TEST(GridBytes, InvalidGridsAreRefused) {
    expect_no_other_length(encode_grid(make_grid()), decode_grid);
    Grid grid = make_grid();
    grid.position[1].last = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(decode_grid(encode_grid(grid)));
    grid = make_grid();
    grid.position[0] = {-1.5e308, 1.5e308, 3};
    EXPECT_FALSE(decode_grid(encode_grid(grid))) << "the step overflows";
    grid = make_grid();
    grid.rotation[1] = {Quaternion{0, 0, 0, 0}};
    EXPECT_FALSE(decode_grid(encode_grid(grid)));
    grid = make_grid();
    grid.position[0] = {0, 1e308, 3};
    EXPECT_FALSE(decode_grid(encode_grid(grid))) << "a place on the way overflows";
    for (const double size : {1e-120, 1e120}) {
        grid = make_grid();
        for (std::vector<Quaternion>& rotation : grid.rotation) {
            rotation = {Quaternion{size, 0, 0, 0}};
        }
        EXPECT_FALSE(decode_grid(encode_grid(grid))) << "the product of the turns is no turn";
    }
    grid = make_grid();
    grid.position[1].count = limits::scenarios_max;
    EXPECT_FALSE(decode_grid(encode_grid(grid)));
    grid.position[1].count = 0;
    EXPECT_FALSE(decode_grid(encode_grid(grid)));
}

TEST(ListSource, GivesWhatItHolds) {
    const std::vector<Scenario> scenarios = numbered_scenarios(10);
    const auto source = make_list_source(scenarios);
    EXPECT_EQ(source->count(), 10u);
    const auto run = source->read(3, 4);
    ASSERT_TRUE(run);
    EXPECT_EQ(run.value(), std::vector<Scenario>(scenarios.begin() + 3, scenarios.begin() + 7));
}

} // namespace cd::tests
