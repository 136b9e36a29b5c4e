#include "bench/cluster/model/workload.hpp"

#include "common/core/check.hpp"
#include "master/dispatch/cost_model.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

namespace cd::bench {

const PaperTable paper_table_heavy{
    {749, 1498, 2246, 2995, 3744}, {281, 597, 1313, 1961, 2679}, {452, 953, 2091, 3127, 4268}};
const PaperTable paper_table_cars{
    {545, 1089, 1634, 2178, 2723}, {326, 642, 969, 1308, 1618}, {532, 1045, 1580, 2132, 2636}};

namespace {

constexpr std::uint64_t equal_ns = 1'000'000;

/// Fisher-Yates shuffle; std::shuffle differs between libraries.
std::vector<std::size_t> order_of(std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    if (seed != 1) {
        std::mt19937_64 random(seed);
        for (std::size_t i = count; i > 1; --i) {
            std::swap(order[i - 1], order[random() % i]);
        }
    }
    return order;
}

/// Factors from measured seconds in binary trees to the paper's.
class PaperScale {
  public:
    PaperScale(const Trace& trace, const PaperTable& table, const std::vector<std::size_t>& order) {
        double measured_all = 0;
        double paper_before = 0;
        std::size_t begin = 0;
        for (std::size_t fifth = 0; fifth < ends_.size(); ++fifth) {
            ends_[fifth] = order.size() * table.scenarios[fifth] / table.scenarios.back();
            double measured = 0;
            for (; begin < ends_[fifth]; ++begin) {
                measured += trace.whole[order[begin]].binary_seconds;
            }
            measured_all += measured;
            factors_[fifth] =
                measured > 0 ? (table.fast_seconds[fifth] - paper_before) / measured : 0;
            paper_before = table.fast_seconds[fifth];
        }
        all_ = paper_before / measured_all;
    }

    /// Returns the factor of the scenario at this position in the order.
    [[nodiscard]] double work(std::size_t place) const {
        const auto fifth = std::ranges::upper_bound(ends_, place) - ends_.begin();
        return factors_[static_cast<std::size_t>(fifth)];
    }
    [[nodiscard]] double analysis() const { return all_; }

  private:
    std::array<std::size_t, 5> ends_{};
    std::array<double, 5> factors_{};
    double all_ = 0;
};

std::vector<BlockCost> block_costs(const CutTrace& cut, Costs costs) {
    std::vector<BlockCost> blocks;
    blocks.reserve(cut.roots.size());
    for (const RootTrace& root : cut.roots) {
        const std::uint64_t paper_bytes = paper_bytes_per_triangle * root.triangles;
        blocks.push_back(
            costs == Costs::Paper
                ? BlockCost{root.triangles, paper_bytes, paper_bytes, 0}
                : BlockCost{
                      root.triangles, root.compressed_bytes, root.memory_bytes, root.open_seconds});
    }
    return blocks;
}

std::vector<BlockId> blocks_of(const ScenarioTrace& scenario) {
    std::vector<BlockId> blocks;
    blocks.reserve(scenario.roots_a.size() + scenario.roots_b.size());
    for (const RootIndex root : scenario.roots_a) {
        blocks.push_back({0, root});
    }
    for (const RootIndex root : scenario.roots_b) {
        blocks.push_back({1, root});
    }
    return blocks;
}

/// `master_factor` scales the master's analysis and predictions.
ScenarioCost
scenario_cost(const ScenarioTrace& from, Costs costs, double master_factor, double work_factor) {
    const double work = costs == Costs::Paper ? from.binary_seconds : from.work_seconds;
    const double predicted_ns =
        master_factor * static_cast<double>(cd::predicted_ns(from.meeting_size));
    return {master_factor * from.analysis_seconds,
            work_factor * work,
            from.batch_bytes,
            from.result_bytes,
            static_cast<std::uint64_t>(predicted_ns),
            blocks_of(from)};
}

/// Changes what the options ask to change of the trace.
void change(Workload& workload, const WorkloadOptions& options) {
    if (options.longest_first) {
        std::ranges::stable_sort(workload.scenarios, std::greater(), [&](std::uint32_t cost) {
            return workload.costs[cost].predicted_ns;
        });
    }
    for (ScenarioCost& cost : workload.costs) {
        cost.analysis_seconds =
            options.analysis_seconds > 0 ? options.analysis_seconds : cost.analysis_seconds;
        cost.predicted_ns = options.equal_predictions ? equal_ns : cost.predicted_ns;
    }
}

} // namespace

Workload
make_workload(const Trace& trace, const PaperTable& table, const WorkloadOptions& options) {
    const DepthTrace* depth = trace.at(options.depth_a);
    CD_CHECK(depth != nullptr);
    const bool is_paper = options.costs == Costs::Paper;
    const std::size_t all = trace.whole.size();
    const std::size_t count = options.count == 0 ? all : options.count;
    CD_CHECK(!is_paper || count <= all);
    const std::vector<std::size_t> order = order_of(all, options.seed);
    const PaperScale scale(trace, table, order);

    Workload workload;
    workload.trees = {block_costs(depth->a, options.costs), block_costs(trace.b, options.costs)};
    for (const auto& tree : workload.trees) {
        for (const BlockCost& block : tree) {
            workload.geometry_bytes += block.bytes;
        }
    }
    if (!is_paper) {
        workload.results = trace.results;
    }
    workload.slow_ratio = table.slow_seconds.back() / table.fast_seconds.back();
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t from = order[place % all];
        const double work = is_paper ? scale.work(place) : 1;
        if (place < all) {
            workload.costs.push_back(scenario_cost(
                depth->scenarios[from], options.costs, is_paper ? scale.analysis() : 1, work));
        }
        workload.scenarios.push_back(static_cast<std::uint32_t>(place % all));
        const WholeTrace& whole = trace.whole[from];
        workload.serial_seconds += work * (is_paper ? whole.binary_seconds : whole.seconds);
    }
    change(workload, options);
    return workload;
}

} // namespace cd::bench
