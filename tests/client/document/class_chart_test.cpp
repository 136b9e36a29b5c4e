// Proves that charts show each scenario in its cell, and that the worst class in a cell counts.
#include "client/document/class_chart.hpp"

#include "client/document/run_overview.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

constexpr auto separate = static_cast<std::uint8_t>(ScenarioClass::Separate);
constexpr auto touch = static_cast<std::uint8_t>(ScenarioClass::Touch);
constexpr auto cross = static_cast<std::uint8_t>(ScenarioClass::Cross);
constexpr auto inside = static_cast<std::uint8_t>(ScenarioClass::Inside);
constexpr auto contact = static_cast<std::uint8_t>(ScenarioClass::Contact);
constexpr auto undecided = static_cast<std::uint8_t>(ScenarioClass::Undecided);
constexpr auto near_class = static_cast<std::uint8_t>(ScenarioClass::Near);
constexpr auto failed_class = static_cast<std::uint8_t>(ScenarioClass::Failed);

/// A part of the markup: a cell without its height and its class.
std::string cell(const std::string& x, const std::string& y, const std::string& width) {
    return "<rect x=\"" + x + "\" y=\"" + y + "\" width=\"" + width + "\"";
}

std::string svg(const ClassChart& chart) {
    return chart.svg().markup();
}

Grid grid_of(std::uint64_t x, std::uint64_t y, std::uint64_t yaws) {
    Grid grid;
    grid.position[0] = {-1, 1, x};
    grid.position[1] = {0, 5, y};
    grid.rotation[2] = rotation_axis({0, 90, yaws}, 2);
    return grid;
}

} // namespace

TEST(ClassChart, ScenariosThatAreLeftOutAreNotShown) {
    std::vector<std::uint8_t> classes(1024, RunOverview::left_out);
    classes[512] = touch;
    EXPECT_THAT(svg(ClassChart::strip(classes)), HasSubstr(cell("320.00", "0.00", "1.25")));
    EXPECT_THAT(svg(ClassChart::strip(classes)), Not(HasSubstr(cell("0.00", "0.00", "320.00"))));
}

TEST(ClassChart, AStripShowsTheWorstOfEachBin) {
    std::vector<std::uint8_t> classes(1024, separate);
    classes[1023] = touch;
    classes[2] = cross;
    classes[3] = touch;
    const ClassChart chart = ClassChart::strip(classes);
    EXPECT_EQ(chart.columns(), 512u);
    EXPECT_EQ(chart.rows(), 1u);
    EXPECT_THAT(svg(chart),
                HasSubstr(cell("1.25", "0.00", "1.25") + " height=\"28.00\" class=\"k7\""));
    EXPECT_THAT(svg(chart),
                HasSubstr(cell("638.75", "0.00", "1.25") + " height=\"28.00\" class=\"k5\""));
    EXPECT_THAT(svg(chart), HasSubstr(">1023</text>"));
}

TEST(ClassChart, ClassesHaveAnOrder) {
    const std::vector<std::uint8_t> order{RunOverview::no_result,
                                          separate,
                                          undecided,
                                          near_class,
                                          touch,
                                          contact,
                                          cross,
                                          inside,
                                          failed_class};
    for (std::size_t i = 1; i < order.size(); ++i) {
        std::vector<std::uint8_t> classes(1024, RunOverview::no_result);
        classes[0] = order[i];
        classes[1] = order[i - 1];
        EXPECT_THAT(svg(ClassChart::strip(classes)),
                    HasSubstr(cell("0.00", "0.00", "1.25") + " height=\"28.00\" class=\"k" +
                              std::to_string(i + 1) + "\""));
    }
    EXPECT_THAT(svg(ClassChart::strip({near_class, touch})), HasSubstr(">near</text>"));
    EXPECT_THAT(svg(ClassChart::strip({touch, cross})), Not(HasSubstr(">near</text>")));
}

TEST(ClassChart, AGridIsAMapOverItsLongestAxes) {
    const Grid grid = grid_of(8, 4, 2);
    std::vector<std::uint8_t> classes(64, separate);
    classes[(7 * 4 + 1) * 2 + 1] = cross; // The last x, the second y, the second yaw.
    const ClassChart chart = ClassChart::of_grid(grid, {}, "m", classes);
    EXPECT_EQ(chart.columns(), 8u);
    EXPECT_EQ(chart.rows(), 4u);
    EXPECT_THAT(svg(chart),
                HasSubstr(cell("560.00", "200.00", "80.00") + " height=\"100.00\" class=\"k7\""));
    EXPECT_THAT(svg(chart), HasSubstr(">x [m]</text>"));
    EXPECT_THAT(svg(chart), HasSubstr(">y [m]</text>"));
    EXPECT_TRUE(is_plane(grid));
    EXPECT_FALSE(is_plane(grid_of(8, 1, 1)));
}

TEST(ClassChart, AnAxisOfAnglesHasItsDegrees) {
    const Grid grid = grid_of(3, 1, 4);
    const std::vector<std::uint8_t> classes(12, separate);
    const std::vector<GridAxis> axes{{}, {}, {}, {}, {}, {0, 90, 4}};
    EXPECT_THAT(svg(ClassChart::of_grid(grid, axes, "m", classes)), HasSubstr(">yaw [deg]</text>"));
    EXPECT_THAT(svg(ClassChart::of_grid(grid, axes, "m", classes)), HasSubstr(">90</text>"));
}

TEST(ClassChart, PosesAreAMapOverWhereBMovesMost) {
    std::vector<Scenario> scenarios;
    for (std::uint64_t i = 0; i < 3; ++i) {
        Scenario& scenario = scenarios.emplace_back();
        scenario.index = i;
        scenario.poses.b =
            translation_pose(0.5, 2.0 * static_cast<double>(i), 0.1 * static_cast<double>(i));
    }
    const auto poses = make_list_source(scenarios);
    const auto chart = ClassChart::of_poses(*poses, "mm", {separate, touch, cross}, {});
    ASSERT_TRUE(chart);
    const std::string text = svg(chart.value());
    EXPECT_THAT(text, HasSubstr(">y [mm]</text>"));
    EXPECT_THAT(text, HasSubstr(">z [mm]</text>"));
    EXPECT_THAT(text, Not(HasSubstr(">x [mm]</text>")));
    EXPECT_THAT(text, HasSubstr(cell("633.33", "0.00", "6.67") + " height=\"4.17\" class=\"k7\""));
    const auto stopped =
        ClassChart::of_poses(*poses, "mm", {separate, touch, cross}, [] { return true; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
