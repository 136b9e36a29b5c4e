#include "bench/cluster/model/baselines.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

struct Share {
    double work_seconds = 0;
    std::uint64_t bytes = 0; ///< Bytes of the distinct blocks that it touches.
    std::uint64_t memory_bytes = 0;
};

Share share_of(const Workload& workload, std::uint64_t begin, std::uint64_t end) {
    Share share;
    std::array<std::vector<bool>, 2> is_touched{std::vector<bool>(workload.trees[0].size(), false),
                                                std::vector<bool>(workload.trees[1].size(), false)};
    for (std::uint64_t index = begin; index < end; ++index) {
        const ScenarioCost& scenario = workload.scenario(index);
        share.work_seconds += scenario.work_seconds;
        for (const BlockId& block : scenario.blocks) {
            if (!is_touched[block.tree][block.root]) {
                is_touched[block.tree][block.root] = true;
                share.bytes += workload.block(block).bytes;
                share.memory_bytes += workload.block(block).memory_bytes;
            }
        }
    }
    return share;
}

double sum_of(std::span<const double> speeds) {
    return std::accumulate(speeds.begin(), speeds.end(), 0.0);
}

std::uint64_t memory_of_all(const Workload& workload) {
    std::uint64_t bytes = 0;
    for (const auto& tree : workload.trees) {
        for (const BlockCost& block : tree) {
            bytes += block.memory_bytes;
        }
    }
    return bytes;
}

/// Returns when each host has its bytes, if all receiving hosts share the link equally.
std::vector<double> received_at(const std::vector<Share>& shares, double bytes_per_second) {
    std::vector<std::size_t> order(shares.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t host) { return shares[host].bytes; });
    std::vector<double> at(shares.size());
    double now = 0;
    std::uint64_t before = 0;
    for (std::size_t place = 0; place < order.size(); ++place) {
        const std::uint64_t bytes = shares[order[place]].bytes;
        const auto receiving = static_cast<double>(order.size() - place);
        now += static_cast<double>(bytes - before) * receiving / bytes_per_second;
        before = bytes;
        at[order[place]] = now;
    }
    return at;
}

} // namespace

BaselineOutcome
static_split(const Workload& workload, std::span<const double> speeds, double bytes_per_second) {
    BaselineOutcome outcome;
    std::vector<Share> shares;
    for (std::size_t host = 0; host < speeds.size(); ++host) {
        shares.push_back(share_of(workload,
                                  workload.count() * host / speeds.size(),
                                  workload.count() * (host + 1) / speeds.size()));
        outcome.sent_bytes += shares.back().bytes;
        outcome.memory_bytes_max = std::max(outcome.memory_bytes_max, shares.back().memory_bytes);
    }
    const std::vector<double> at = received_at(shares, bytes_per_second);
    for (std::size_t host = 0; host < speeds.size(); ++host) {
        outcome.seconds =
            std::max({outcome.seconds, at[host], shares[host].work_seconds / speeds[host]});
    }
    return outcome;
}

BaselineOutcome whole_everywhere(const Workload& workload,
                                 std::span<const double> speeds,
                                 double bytes_per_second) {
    const double work = share_of(workload, 0, workload.count()).work_seconds;
    BaselineOutcome outcome;
    outcome.sent_bytes = workload.geometry_bytes * speeds.size();
    outcome.memory_bytes_max = memory_of_all(workload);
    // Hosts are served in sequence: the first ones work while the last ones wait.
    const double each = static_cast<double>(workload.geometry_bytes) / bytes_per_second;
    double done = 0; // Work done when the previous host was served.
    double power = 0;
    double now = 0;
    for (const double speed : speeds) {
        if (done + power * each >= work) {
            break;
        }
        done += power * each;
        now += each;
        power += speed;
    }
    outcome.seconds = now + (work - done) / power;
    return outcome;
}

BaselineOutcome
offline_optimum(const Workload& workload, std::span<const double> speeds, double bytes_per_second) {
    const Share all = share_of(workload, 0, workload.count());
    BaselineOutcome outcome;
    outcome.sent_bytes = all.bytes;
    outcome.seconds = std::max(all.work_seconds / sum_of(speeds),
                               static_cast<double>(all.bytes) / bytes_per_second);
    return outcome;
}

} // namespace cd::bench
