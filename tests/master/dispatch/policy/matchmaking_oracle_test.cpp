// Proves that the dispatcher, which uses an index of roots, chooses as a slow reference that scores
// worker by worker: over random holdings, evictions, joins and losses, for each of the paper's
// strategies.
#include "master/dispatch/dispatcher.hpp"
#include "tests/master/slow_matchmaker.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace cd::tests {
namespace {

constexpr JobId job{1};
constexpr TreeId tree_a{1};
constexpr TreeId tree_b{2};
constexpr std::uint32_t q =
    5000; // Nothing is sent before the end, so the buffers show the choices.

/// Feeds both implementations identical events.
class Twins {
  public:
    Twins(std::uint64_t seed, const ClusterOptions& options)
        : random_(seed),
          slow_(options, options.seed),
          triangles_a_(random_triangles(40)),
          triangles_b_(random_triangles(23)) {
        keep(
            dispatcher_.job_opened(job, options, {{tree_a, triangles_a_}, {tree_b, triangles_b_}}));
        feed(); // More input follows, and no worker gets part of a buffer.
        for (int i = 0; i < 3; ++i) {
            join();
        }
    }

    void random_event() {
        const std::uint64_t dice = random_() % 100;
        if (dice < 75) {
            feed();
        } else if (dice < 90) {
            evict();
        } else if (dice < 96) {
            join();
        } else if (buffers_.size() > 1) {
            lose();
        }
    }

    /// Returns the content of each worker's buffer, as the dispatcher finally shows it.
    [[nodiscard]] std::map<WorkerId, PositionSet> sent() {
        keep(dispatcher_.input_paused());
        return sent_;
    }
    [[nodiscard]] std::map<WorkerId, PositionSet> expected() const {
        std::map<WorkerId, PositionSet> expected;
        for (const auto& [worker, buffer] : buffers_) {
            if (!buffer.empty()) {
                expected[worker] = PositionSet::of(buffer);
            }
        }
        return expected;
    }
    [[nodiscard]] std::uint64_t losses() const { return losses_; }

  private:
    struct Touched {
        std::vector<RootIndex> a;
        std::vector<RootIndex> b;
    };

    std::vector<std::uint32_t> random_triangles(std::size_t roots) {
        std::vector<std::uint32_t> triangles(roots);
        for (std::uint32_t& count : triangles) {
            // Few distinct counts cause ties; some need more than sixteen bits.
            count = random_() % 5 == 0 ? 70'000 : static_cast<std::uint32_t>(1 + random_() % 3);
        }
        return triangles;
    }

    std::vector<RootIndex> some_roots(std::size_t count) {
        std::vector<RootIndex> roots;
        for (RootIndex root = 0; root < count; ++root) {
            if (random_() % 6 == 0) {
                roots.push_back(root);
            }
        }
        return roots;
    }

    void feed() {
        const std::uint64_t index = scenarios_.size();
        scenarios_.push_back({some_roots(triangles_a_.size()), some_roots(triangles_b_.size())});
        const Touched& touched = scenarios_.back();
        keep(dispatcher_.scenario_analysed(job, {index, touched.a, touched.b, 1}));
        allocate(index);
    }

    void allocate(std::uint64_t index) {
        const Touched& touched = scenarios_[index];
        std::map<WorkerId, std::uint64_t> scores;
        for (const auto& [id, worker] : workers_) {
            scores[id] =
                SlowMatchmaker::score(worker, touched.a, touched.b, triangles_a_, triangles_b_);
        }
        const auto chosen = slow_.choose(workers_, scores);
        if (!chosen) {
            waiting_.push_back(index);
            return;
        }
        SlowWorker& worker = workers_.at(*chosen);
        ++worker.buffered;
        worker.held_a.insert(touched.a.begin(), touched.a.end());
        worker.held_b.insert(touched.b.begin(), touched.b.end());
        buffers_[*chosen].push_back(index);
    }

    void allocate_waiting() {
        for (const std::uint64_t index : std::exchange(waiting_, {})) {
            allocate(index);
        }
    }

    void join() {
        const WorkerId worker{++worker_last_};
        workers_[worker];
        buffers_[worker];
        keep(dispatcher_.worker_joined(worker, {"w", 1}));
        allocate_waiting();
    }

    void lose() {
        auto place = buffers_.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(random_() % buffers_.size()));
        const WorkerId worker = place->first;
        waiting_ = std::move(place->second);
        buffers_.erase(place);
        workers_.erase(worker);
        keep(dispatcher_.worker_lost(worker));
        allocate_waiting();
        ++losses_;
    }

    void evict() {
        auto place = workers_.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(random_() % workers_.size()));
        const bool is_a = random_() % 2 == 0;
        const auto roots = some_roots(is_a ? triangles_a_.size() : triangles_b_.size());
        for (const RootIndex root : roots) {
            (is_a ? place->second.held_a : place->second.held_b).erase(root);
        }
        keep(dispatcher_.roots_evicted(place->first, is_a ? tree_a : tree_b, roots));
    }

    void keep(const Actions& actions) {
        dispatcher_.check_invariants();
        for (const Action& action : actions) {
            const auto& batch = std::get<SendUnit>(action);
            sent_[batch.worker].add(batch.positions);
        }
    }

    std::mt19937_64 random_;
    SlowMatchmaker slow_;
    std::vector<std::uint32_t> triangles_a_;
    std::vector<std::uint32_t> triangles_b_;
    Dispatcher dispatcher_;
    std::vector<Touched> scenarios_;
    std::vector<std::uint64_t> waiting_;
    std::map<WorkerId, SlowWorker> workers_;
    std::map<WorkerId, std::vector<std::uint64_t>> buffers_;
    std::map<WorkerId, PositionSet> sent_;
    std::uint64_t worker_last_ = 0;
    std::uint64_t losses_ = 0;
};

TEST(MatchmakingOracle, TheIndexMakesTheChoicesOfTheSlowTwin) {
    std::uint64_t losses = 0;
    for (const std::string_view strategy : {"best-match", "best-match-load", "random", "lowest"}) {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            SCOPED_TRACE(testing::Message() << strategy << ", seed " << seed);
            ClusterOptions options;
            options.strategy = strategy;
            options.q = q;
            options.seed = seed;
            Twins twins(seed, options);
            for (int event = 0; event < 200; ++event) {
                twins.random_event();
            }
            ASSERT_EQ(twins.sent(), twins.expected());
            losses += twins.losses();
        }
    }
    EXPECT_GT(losses, 500u);
}

} // namespace
} // namespace cd::tests
