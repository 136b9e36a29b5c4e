// The simulated master: the real coordinator around sketches of all that it does not compute
// itself, without a network.
#pragma once

#include "bench/cluster/model/messages.hpp"
#include "bench/cluster/model/policies.hpp"
#include "bench/cluster/model/workload.hpp"
#include "master/jobs/feed/analysis_feed.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cd::bench {

/// A message to a worker.
struct Letter {
    WorkerId to;
    Message content;
    std::uint64_t bytes = 0;
};

struct MasterCounts {
    std::uint64_t batches = 0;
    std::uint64_t wants = 0;
    std::uint64_t blocks = 0;      ///< Blocks sent.
    std::uint64_t block_bytes = 0; ///< Bytes of the blocks alone.
    std::uint64_t uploads_max = 0; ///< Most times that one block was sent.
    std::uint64_t sent_bytes = 0;  ///< Bytes of all letters.
    std::uint64_t results = 0;     ///< Results received, repeated ones included.
    double seconds = 0;            ///< Real processor time of the coordinator.
};

struct MasterOptions {
    ClusterOptions dispatch;
    AnalysisMode analysis = AnalysisMode::Always; ///< Whatever `dispatch` says.
    Variation variation = Variation::None;
    FeedLimits feed = {};
    bool peers = false;            ///< Workers send each other blocks, as the master directs.
    std::uint64_t cache_bytes = 0; ///< Cache of each worker; 0: no limit.
    bool helps_at_end = true;
    std::uint32_t pool_threads = 1; ///< Threads that analyse and check results.
    double result_seconds = 0;      ///< Time that the master's thread is to take for each result.
};

/// Each call returns the letters that follow from it.
class SimulatedMaster {
  public:
    using Letters = std::vector<Letter>;
    /// Work of a pool thread. The simulation passes it to `take` when `seconds` have passed.
    struct PoolRun {
        double seconds = 0;
        std::uint64_t analysed = 0; ///< Number of analysed scenarios.
        std::deque<std::function<void()>> outcome;
    };

    /// The workload outlives the master.
    SimulatedMaster(const Workload& workload, const MasterOptions& options);
    SimulatedMaster(const SimulatedMaster&) = delete;
    SimulatedMaster& operator=(const SimulatedMaster&) = delete;
    ~SimulatedMaster();

    /// Opens the job and adds workers with so many threads, numbered from 1.
    Letters start(std::span<const std::uint32_t> worker_threads);
    /// Adds workers with so many threads, numbered on.
    Letters join(std::span<const std::uint32_t> worker_threads);
    /// Advances the time, in seconds. Call before every event; time never decreases.
    Letters time_is(double now);
    /// Time of the next event without a message, in seconds.
    [[nodiscard]] std::optional<double> next_timer() const;

    Letters take(WorkerId from, const Message& message);

    [[nodiscard]] bool has_pool_work() const;
    /// Starts the next work of a pool thread.
    [[nodiscard]] PoolRun start_pool_work();
    Letters take(PoolRun run);

    /// Number of results in each entry that the journal has not committed.
    [[nodiscard]] const std::deque<std::size_t>& uncommitted() const;
    /// Commits the first of these entries.
    Letters commit();

    /// True once the journal has committed the job's end.
    [[nodiscard]] bool is_done() const;
    [[nodiscard]] const MasterCounts& counts() const;
    [[nodiscard]] std::uint64_t answered() const; ///< Scenarios with a result.
    /// How much more workers would help, as clients are told.
    [[nodiscard]] std::optional<Growth> growth() const;
    [[nodiscard]] std::uint64_t recalled() const;
    [[nodiscard]] std::uint64_t copies() const;

  private:
    struct State;
    /// Runs an event and all that follows from it at once.
    template <class Event>
    Letters run(const Event& event);
    std::unique_ptr<State> state_;
};

} // namespace cd::bench
