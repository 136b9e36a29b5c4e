// The simulated master: the real dispatcher, and what the coordinator does around it, without a
// clock, a network or computation.
#pragma once

#include "bench/cluster/messages.hpp"
#include "bench/cluster/workload.hpp"
#include "master/dispatcher.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace cd::bench {

/// A message on its way to a worker.
struct Letter {
    WorkerId to;
    ToWorker content;
    std::uint64_t bytes = 0;
};

struct MasterCounts {
    std::uint64_t batches = 0;
    std::uint64_t wants = 0;
    std::uint64_t blocks = 0;         ///< Sent,
    std::uint64_t block_bytes = 0;    ///< and their bytes alone.
    std::uint64_t sent_bytes = 0;     ///< Of all letters.
    std::uint64_t answered = 0;       ///< Distinct scenarios.
    std::uint64_t answered_again = 0; ///< Results of scenarios that had one.
    std::uint64_t dispatcher_calls = 0;
    double dispatcher_seconds = 0; ///< Of processor time, really spent in them here.
};

class MasterModel {
  public:
    /// `ahead`: how many analysed scenarios may wait for a worker beside those in buffers; one at
    /// least.
    /// The workload outlives the model.
    MasterModel(const Workload& workload, const ClusterOptions& options, std::uint64_t ahead);

    /// The job is opened, and workers of so many threads are there, numbered from 1.
    std::vector<Letter> start(std::span<const std::uint32_t> worker_threads);

    /// The next scenario to be analysed; nothing when all have been given out, or while enough wait
    /// for workers.
    std::optional<std::uint64_t> next_to_analyse();
    std::vector<Letter> take(const Analysed& message);
    std::vector<Letter> take(const BlocksWanted& message);
    std::vector<Letter> take(const ResultsSent& message);

    [[nodiscard]] bool is_done() const { return counts_.answered == workload_.count(); }
    [[nodiscard]] const MasterCounts& counts() const { return counts_; }

  private:
    template <class Event>
    std::vector<Letter> dispatch(const Event& event);
    void perform(const Action& action, std::vector<Letter>& letters);
    void post(WorkerId to, ToWorker content, std::vector<Letter>& letters);
    /// Analysed, and in no buffer.
    [[nodiscard]] std::uint64_t waiting() const;
    /// As the coordinator does when nothing more is being analysed.
    void pause_at_end(std::vector<Letter>& letters);

    const Workload& workload_;
    ClusterOptions options_;
    Dispatcher dispatcher_;
    std::vector<WorkerId> workers_;
    MasterCounts counts_;
    std::uint64_t given_out_ = 0; ///< To be analysed.
    std::uint64_t analysed_ = 0;
    std::uint64_t ahead_;
    std::vector<bool> is_answered_;
    std::set<WorkerId> knows_trees_;
};

} // namespace cd::bench
