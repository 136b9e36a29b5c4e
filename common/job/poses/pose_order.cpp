#include "common/job/poses/pose_order.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/packed_scenarios.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::size_t coordinates = 6;
constexpr unsigned coordinate_bits = 10;
constexpr double cells = 1u << coordinate_bits;

using Coordinates = std::array<double, coordinates>;

Coordinates coordinates_of(const PosePair& poses) {
    const RelativePose relative = relative_pose(poses);
    const Mat3& r = relative.rotation;
    const Vec3& t = relative.translation;
    return {t.x(), t.y(), t.z(), r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)};
}

/// Returns the cell of a coordinate between two bounds; cell 0 if the bounds are equal or NaN.
std::uint64_t cell_of(double value, double low, double high) {
    const double at = (value - low) / (high - low) * cells;
    return at >= 1 ? static_cast<std::uint64_t>(std::min(at, cells - 1)) : 0;
}

/// Returns the position on the Morton curve: the interleaved bits of the six cells, highest first.
std::uint64_t curve_of(const Coordinates& each, const Coordinates& low, const Coordinates& high) {
    std::array<std::uint64_t, coordinates> cell{};
    for (std::size_t k = 0; k < coordinates; ++k) {
        cell[k] = cell_of(each[k], low[k], high[k]);
    }
    std::uint64_t curve = 0;
    for (unsigned bit = coordinate_bits; bit-- > 0;) {
        for (const std::uint64_t c : cell) {
            curve = curve << 1 | (c >> bit & 1);
        }
    }
    return curve;
}

} // namespace

std::vector<std::uint32_t> coherent_order(std::span<const Scenario> scenarios) {
    std::vector<Coordinates> points(scenarios.size());
    std::transform(scenarios.begin(),
                   scenarios.end(),
                   points.begin(),
                   [](const Scenario& scenario) { return coordinates_of(scenario.poses); });
    Coordinates low = points.empty() ? Coordinates{} : points.front();
    Coordinates high = low;
    for (const Coordinates& each : points) {
        for (std::size_t k = 0; k < coordinates; ++k) {
            low[k] = std::min(low[k], each[k]);
            high[k] = std::max(high[k], each[k]);
        }
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> along; // Place on the curve, index.
    along.reserve(points.size());
    for (const Coordinates& each : points) {
        along.emplace_back(curve_of(each, low, high), static_cast<std::uint32_t>(along.size()));
    }
    std::ranges::sort(along);
    std::vector<std::uint32_t> order;
    order.reserve(along.size());
    for (const auto& [place, index] : along) {
        order.push_back(index);
    }
    return order;
}

std::vector<Bytes> pack_in_order(std::span<const Scenario> window,
                                 std::span<const std::uint32_t> trees) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Scenario>> by_trees;
    for (const Scenario& scenario : window) {
        by_trees[{trees[scenario.body_a], trees[scenario.body_b]}].push_back(scenario);
    }
    std::vector<Scenario> ordered;
    ordered.reserve(window.size());
    for (const auto& [pair, scenarios] : by_trees) {
        for (const std::uint32_t submitted : coherent_order(scenarios)) {
            ordered.push_back(scenarios[submitted]);
        }
    }
    std::vector<Bytes> runs;
    for (std::span<const Scenario> rest = ordered; !rest.empty();) {
        const auto run = rest.first(std::min<std::size_t>(rest.size(), limits::pose_run_scenarios));
        runs.push_back(pack_scenarios(run));
        rest = rest.subspan(run.size());
    }
    return runs;
}

} // namespace cd
