#include "common/search/search_cost.hpp"

#include "common/tree/query_statistics.hpp"
#include "common/tree/wide/candidates_at_once.hpp"
#include "common/tree/wide/wide_descent.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration duration) {
    return std::chrono::duration<double, std::nano>(duration).count();
}

/// Time and number of tests of a search under one pose.
struct PoseCost {
    Clock::duration boxes{};
    Clock::duration triangles{};
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
};

PoseCost search(const WideView& a,
                const WideView& b,
                const PosePair& poses,
                const SearchCostOptions& options) {
    PoseCost cost;
    TrianglePairTest test(poses, options.first_stage);
    const auto start = Clock::now();
    WideDescent descent(relative_pose(poses));
    descent.start(a, b, options.for_any ? WideDescent::Aim::First : WideDescent::Aim::All);
    cost.boxes = Clock::now() - start;
    bool is_found = false;
    while (!descent.is_done() && !is_found) {
        const auto before = Clock::now();
        const std::span<const Candidate> found =
            descent.next(options.for_any ? candidates_at_once_for_any : candidates_at_once);
        const auto between = Clock::now();
        if (options.for_any) {
            is_found = test.find_touch(a.triangles, b.triangles, found).has_value();
        } else {
            static_cast<void>(test.classify(a.triangles, b.triangles, found));
        }
        cost.boxes += between - before;
        cost.triangles += Clock::now() - between;
        cost.triangle_tests += found.size();
    }
    cost.box_tests = descent.box_tests();
    return cost;
}

/// Collects the cost of one kind of test under each pose.
class TestCost {
  public:
    void add(Clock::duration spent, std::uint64_t tests) {
        if (tests > 0) {
            const auto count = static_cast<double>(tests);
            costs_.push_back({nanoseconds(spent) / count, count});
            tests_ += count;
        }
    }
    [[nodiscard]] bool is_known() const { return !costs_.empty(); }
    /// Returns the median cost of a test in ns, weighted by the number of tests. Requires
    /// `is_known()`.
    [[nodiscard]] double median() {
        std::sort(costs_.begin(), costs_.end());
        double below = 0;
        for (const auto& [cost, tests] : costs_) {
            below += tests;
            if (2 * below >= tests_) {
                return cost;
            }
        }
        return costs_.back().first;
    }

  private:
    std::vector<std::pair<double, double>> costs_; ///< Cost of a test in ns, and number of tests.
    double tests_ = 0;
};

} // namespace

double SearchCost::seconds_of(const QueryStatistics& statistics) const {
    return 1e-9 * (static_cast<double>(statistics.box_tests) * box_test_ns +
                   static_cast<double>(statistics.triangle_tests) * triangle_test_ns);
}

std::optional<SearchCost> measure_search_cost(const TreeView& a,
                                              const TreeView& b,
                                              std::span<const PosePair> poses,
                                              const SearchCostOptions& options) {
    if (a.wide.nodes.empty() || b.wide.nodes.empty()) {
        return std::nullopt;
    }
    const auto start = Clock::now();
    TestCost box_tests;
    TestCost triangle_tests;
    for (const PosePair& pose : poses) {
        if (box_tests.is_known() && Clock::now() - start > options.time_max) {
            break;
        }
        const PoseCost cost = search(a.wide, b.wide, pose, options);
        box_tests.add(cost.boxes, cost.box_tests);
        triangle_tests.add(cost.triangles, cost.triangle_tests);
    }
    if (!triangle_tests.is_known()) {
        return std::nullopt;
    }
    return SearchCost{box_tests.median(), triangle_tests.median()};
}

} // namespace cd
