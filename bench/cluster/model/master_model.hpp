// The simulated master: the real dispatcher and the coordinator's work around it, without a clock,
// a network or computation.
#pragma once

#include "bench/cluster/model/messages.hpp"
#include "bench/cluster/model/workload.hpp"
#include "master/blocks/block_director.hpp"
#include "master/blocks/transfer_meter.hpp"
#include "master/dispatch/dispatcher.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace cd::bench {

/// A message to a worker.
struct Letter {
    WorkerId to;
    ToWorker content;
    std::uint64_t bytes = 0;
};

struct MasterCounts {
    std::uint64_t batches = 0;
    std::uint64_t wants = 0;
    std::uint64_t blocks = 0;         ///< Blocks sent.
    std::uint64_t block_bytes = 0;    ///< Bytes of the blocks alone.
    std::uint64_t sent_bytes = 0;     ///< Bytes of all letters.
    std::uint64_t answered = 0;       ///< Distinct scenarios answered.
    std::uint64_t answered_again = 0; ///< Repeated results of scenarios.
    std::uint64_t recalled = 0;
    std::uint64_t copies = 0;
    std::uint64_t dispatcher_calls = 0;
    double dispatcher_seconds = 0; ///< Real processor time in the dispatcher and the director.
};

class MasterModel {
  public:
    /// `peers`: workers send each other blocks, as the master directs. `ahead`: analysed scenarios
    /// that may wait outside buffers; 0: the coordinator's number. `cache_bytes`: cache of each
    /// worker; 0: no limit. The workload must outlive the model.
    MasterModel(const Workload& workload,
                const ClusterOptions& options,
                std::uint64_t ahead,
                bool peers,
                std::uint64_t cache_bytes = 0,
                bool helps_at_end = true);

    /// Advances the time, in seconds. Call before every event; time never decreases.
    std::vector<Letter> time_is(double now);

    /// Opens the job and adds workers with so many threads, numbered from 1.
    std::vector<Letter> start(std::span<const std::uint32_t> worker_threads);

    /// Returns the next scenario to analyse; nothing when all are handed out, or while enough wait
    /// for workers.
    std::optional<std::uint64_t> next_to_analyse();
    /// Returns the first and the number of up to `count_max` consecutive scenarios to analyse.
    std::pair<std::uint64_t, std::uint64_t> next_block_to_analyse(std::uint64_t count_max);
    std::vector<Letter> take(const Analysed& message);
    std::vector<Letter> take(const BlocksWanted& message);
    std::vector<Letter> take(const BlocksHeld& message);
    std::vector<Letter> take(const BlocksEvicted& message);
    std::vector<Letter> take(const PeerFailed& message);
    std::vector<Letter> take(const ResultsSent& message);
    std::vector<Letter> take(const GaveBack& message);

    [[nodiscard]] bool is_done() const { return counts_.answered == workload_.count(); }
    [[nodiscard]] const MasterCounts& counts() const { return counts_; }

  private:
    template <class Event>
    std::vector<Letter> dispatch(const Event& event);
    /// Reports an event that causes no actions.
    template <class Event>
    void report(const Event& event);
    void perform(const Action& action, std::vector<Letter>& letters);
    template <class Event>
    std::vector<Letter> direct(const Event& event);
    /// Carries out the director's decisions. Gathers blocks of one tree into messages of sufficient
    /// size, as the real master does.
    std::vector<Letter> deliver(const BlockActions& actions);
    void post(WorkerId to, ToWorker content, std::vector<Letter>& letters);
    /// Number of analysed scenarios that are in no buffer.
    [[nodiscard]] std::uint64_t waiting() const;
    [[nodiscard]] bool has_enough() const;
    /// Pauses as the coordinator does when nothing more is being analysed.
    void pause_at_end(std::vector<Letter>& letters);

    const Workload& workload_;
    ClusterOptions options_;
    Dispatcher dispatcher_;
    std::vector<WorkerId> workers_;
    MasterCounts counts_;
    std::uint64_t given_out_ = 0; ///< Scenarios handed out for analysis.
    std::uint64_t analysed_ = 0;
    std::uint64_t ahead_;
    std::vector<bool> is_answered_;
    std::set<WorkerId> knows_trees_;
    double now_ = 0;
    std::map<WorkerId, TransferMeter> transfers_;
    bool peers_;
    std::uint64_t cache_bytes_; ///< Cache of one worker.
    BlockDirector director_;
    double director_told_ = 0; ///< Time last reported to the director.
};

} // namespace cd::bench
