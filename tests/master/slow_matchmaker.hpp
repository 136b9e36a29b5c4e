// A slow reference for the paper's matchmaker: each worker has the set of roots it holds of each
// tree (6.4.5), and a score is a sum over a scenario's roots, worker by worker (6.5).
#pragma once

#include "common/core/id.hpp"
#include "common/tree/cut.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>

namespace cd::tests {

struct SlowWorker {
    std::set<RootIndex> held_a;
    std::set<RootIndex> held_b;
    std::uint64_t buffered = 0;
};

class SlowMatchmaker {
  public:
    SlowMatchmaker(const ClusterOptions& options, std::uint64_t seed)
        : options_(options), random_(seed) {}

    [[nodiscard]] static std::uint64_t score(const SlowWorker& worker,
                                             std::span<const RootIndex> roots_a,
                                             std::span<const RootIndex> roots_b,
                                             std::span<const std::uint32_t> triangles_a,
                                             std::span<const std::uint32_t> triangles_b) {
        std::uint64_t sum = 0;
        for (const RootIndex root : roots_a) {
            sum += worker.held_a.contains(root) ? triangles_a[root] : 0;
        }
        for (const RootIndex root : roots_b) {
            sum += worker.held_b.contains(root) ? triangles_b[root] : 0;
        }
        return sum;
    }

    /// `scores` gets the score of each worker.
    [[nodiscard]] std::optional<WorkerId> choose(const std::map<WorkerId, SlowWorker>& workers,
                                                 const std::map<WorkerId, std::uint64_t>& scores) {
        std::optional<WorkerId> best;
        if (workers.empty()) {
            return best;
        }
        if (options_.strategy == "random") {
            auto place = workers.begin();
            std::advance(place, static_cast<std::ptrdiff_t>(random_() % workers.size()));
            return place->first;
        }
        double best_worth = 0;
        for (const auto& [id, worker] : workers) {
            const double value = worth(scores.at(id), worker);
            if (!best || value > best_worth ||
                (value == best_worth && worker.buffered < workers.at(*best).buffered)) {
                best = id;
                best_worth = value;
            }
        }
        return best;
    }

  private:
    [[nodiscard]] double worth(std::uint64_t score, const SlowWorker& worker) const {
        const auto triangles = static_cast<double>(score);
        if (options_.strategy == "best-match-load") {
            return triangles * (1.0 - static_cast<double>(worker.buffered) / options_.q);
        }
        return options_.strategy == "lowest" ? -triangles : triangles;
    }

    ClusterOptions options_;
    std::mt19937_64 random_;
};

} // namespace cd::tests
