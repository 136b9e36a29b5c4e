// The simulated master: the real dispatcher, and what the coordinator does around it, without a
// clock, a network or computation.
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
    std::uint64_t recalled = 0;
    std::uint64_t copies = 0;
    std::uint64_t dispatcher_calls = 0;
    double dispatcher_seconds = 0; ///< Of processor time, really spent in it and in the director.
};

class MasterModel {
  public:
    /// `peers`: workers give each other blocks, as the master directs.
    /// `ahead`: how many analysed scenarios may wait for a worker beside those in buffers; 0: as
    /// many as the coordinator lets. `cache_bytes`: of each worker; 0: no limit. The workload
    /// outlives the model.
    MasterModel(const Workload& workload,
                const ClusterOptions& options,
                std::uint64_t ahead,
                bool peers,
                std::uint64_t cache_bytes = 0,
                bool helps_at_end = true);

    /// To be called before whatever happens then. In seconds; never less than before.
    std::vector<Letter> time_is(double now);

    /// The job is opened, and workers of so many threads are there, numbered from 1.
    std::vector<Letter> start(std::span<const std::uint32_t> worker_threads);

    /// The next scenario to be analysed; nothing when all have been given out, or while enough wait
    /// for workers.
    std::optional<std::uint64_t> next_to_analyse();
    /// The same of neighbours at once, at most so many: the first, and how many.
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
    /// Of an event without actions.
    template <class Event>
    void report(const Event& event);
    void perform(const Action& action, std::vector<Letter>& letters);
    template <class Event>
    std::vector<Letter> direct(const Event& event);
    /// The director's decisions. Blocks are gathered into messages as the real master does: of one
    /// tree, until they are large enough.
    std::vector<Letter> deliver(const BlockActions& actions);
    void post(WorkerId to, ToWorker content, std::vector<Letter>& letters);
    /// As the coordinator reports what a worker did.
    void report_work(const ResultsSent& message);
    /// Analysed, and in no buffer.
    [[nodiscard]] std::uint64_t waiting() const;
    [[nodiscard]] bool has_enough() const;
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
    double now_ = 0;
    std::map<WorkerId, TransferMeter> transfers_;
    bool peers_;
    std::uint64_t cache_bytes_; ///< Of a worker.
    BlockDirector director_;
    double director_told_ = 0; ///< The time.
};

} // namespace cd::bench
