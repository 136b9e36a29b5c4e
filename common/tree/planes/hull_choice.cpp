#include "common/tree/planes/hull_choice.hpp"

#include "common/tree/planes/hull_distance.hpp"
#include "common/tree/planes/quick_hull.hpp"
#include "common/tree/planes/simplex.hpp"

#include <algorithm>
#include <queue>

namespace cd {

namespace {

/// One of so many points is chosen by its distance from the hull, and the others before by their
/// heights above facets. Heights are small beside the rim of thin hulls, where distances are not.
constexpr std::size_t last_share = 10;

/// A point that is not chosen, with an upper bound on its distance from the hull.
struct Waiting {
    double bound;
    std::uint32_t number;

    friend bool operator<(const Waiting& left, const Waiting& right) {
        return left.bound != right.bound ? left.bound < right.bound : left.number > right.number;
    }
};

} // namespace

HullChoice choose_hull(std::span<const FloatPoint> points,
                       std::size_t count_max,
                       double eps_wanted,
                       double radius) {
    // A bound by several points is not below `distance_rounding`.
    const double wanted = std::max(eps_wanted, 2 * distance_rounding * radius);
    QuickHull quick(points, wanted, radius);
    quick.grow(count_max - std::min(count_max / last_share, count_max - 4));
    HullChoice choice{quick.chosen(), 0};
    std::vector<Waiting> waiting;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (quick.bounds()[i] > wanted) {
            waiting.push_back({quick.bounds()[i], i});
        } else {
            choice.eps = std::max(choice.eps, quick.bounds()[i]);
        }
    }
    if (waiting.empty()) {
        return choice;
    }
    HullDistance hull(radius);
    for (const std::uint32_t number : choice.numbers) {
        hull.add(points[number]);
    }
    // Without room only the largest bound matters.
    std::priority_queue<Waiting> queue({}, std::move(waiting));
    while (!queue.empty() && queue.top().bound > choice.eps) {
        const auto [before, number] = queue.top();
        queue.pop();
        const bool has_room = choice.numbers.size() < count_max;
        const double enough = has_room ? wanted : std::max(wanted, choice.eps);
        const double bound = std::min(before, hull.bound(points[number], enough));
        if (!has_room || bound <= wanted) {
            choice.eps = std::max(choice.eps, bound);
        } else if (!queue.empty() && bound < queue.top().bound) {
            queue.push({bound, number});
        } else {
            choice.numbers.push_back(number);
            hull.add(points[number]);
        }
    }
    return choice;
}

} // namespace cd
