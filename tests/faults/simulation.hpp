// One seed: a cluster, its jobs, and its faults.
//
// Invariants; where they are checked; mutations that violate them:
// - No result is merged twice: CD_CHECK at the merge, Watcher::add_group. SecondAnswerMerged.
// - No result is lost: check_job (master/coordinator/invariants), the dispatcher's check_positions
//   and check_job, check_kept (acknowledged results), inspect_job at the end. LostRangeForgotten,
//   AnswerKeptTooEarly.
// - Every supposed holder of a block has it, or its report to the contrary is under way:
//   check_cache; by messages, Watcher::check_sources. EvictionNotTold, EvictionIgnored,
//   OthersSourceNamed.
// - No credit is negative: check_unsent, WorkerSession (results in flight).
//   RoomNotGivenBack, ReadsOn.
// - Work in flight is bounded: a worker's tasks by the dispatcher's check_flight, blocks and all
//   other bytes towards a peer by LinkEnd's check_flight and check_queue, unacknowledged results
//   by keeps_too_much. BatchesWithoutBound, TooMuchInFlight.
// - Every task has a lease: check_leases, check_positions. LostLeaseForgotten.
// - A position is in one place, and an answered one in none: check_positions, check_job.
//   IndexTakenForPosition, SplitRunLosesEnd.
// - Work progresses after the last fault: stop_trouble. HeardAgainForgotten.
//
// The dispatcher's record of a worker's roots is no promise of blocks: it serves matching and
// includes blocks that are planned or on their way.
#pragma once

#include "master/base/mutation.hpp"
#include "tests/faults/processes.hpp"
#include "tests/faults/world.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace cd::tests {

/// The counts of one seed, or of several.
struct Outcome {
    std::vector<std::string> problems; ///< Empty if all is well.
    double seconds = 0;                ///< Simulated time.
    std::uint64_t events = 0;
    std::uint64_t checks = 0;           ///< Events after which the master was checked.
    std::uint64_t blocks_checked = 0;   ///< Blocks the master believed a worker to hold.
    std::uint64_t scenarios = 0;        ///< Scenarios of all jobs.
    std::uint64_t scenarios_sent = 0;   ///< Scenarios sent to workers, repeats included.
    std::uint64_t failed = 0;           ///< Scenarios given up.
    std::uint64_t results_repeated = 0; ///< Repeated result messages.
    std::uint64_t masters = 0;          ///< Master processes.
    std::uint64_t workers = 0;          ///< Worker processes.
    std::uint64_t answering = 0;        ///< Worker processes that answered something.
    std::uint64_t cancelled = 0;        ///< Cancelled jobs.
    std::uint64_t recalled = 0;         ///< Scenarios that workers returned.
    std::uint64_t copies = 0;           ///< Scenarios sent to a second worker.
    std::uint64_t called_off = 0;       ///< Scenarios recalled because another worker answered.
    std::uint64_t late_messages = 0;    ///< Messages of a connection after its worker greeted
                                        ///< again.
    std::uint64_t late_results = 0;     ///< Result messages of an earlier session.
    std::uint64_t old_sessions = 0;     ///< Unknown sessions that workers tried to resume.
    std::uint64_t lies = 0;             ///< Scenarios with a wrong result from a worker.
    std::uint64_t found_out = 0;        ///< Workers found wrong.
    std::uint64_t corrected = 0;        ///< Scenarios whose result on disk was wrong for a time.
    std::uint64_t borne = 0;            ///< Scenarios whose result stays wrong, undetectably.
    Troubles troubles;

    /// Adds the counts, and appends the problems.
    Outcome& operator+=(const Outcome& other);
    /// Formats the counts for people.
    [[nodiscard]] std::string counts() const;
};

struct SimulationOptions {
    bool logs = false;
    Mutation fault = Mutation::None;
    std::size_t workers = 0; ///< 0: a few, chosen by the seed; else adds a job sized for so many.
};

class Simulation {
  public:
    Simulation(std::uint64_t seed, const SimulationOptions& options);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    Outcome run();

  private:
    /// Chances in per mille per second.
    struct Dangers {
        unsigned worker_killed = 0;
        unsigned worker_stopped = 0;
        unsigned worker_cut_off = 0;
        unsigned worker_drained = 0;
        unsigned worker_slowed = 0;
        unsigned worker_mute = 0;
        unsigned worker_deaf = 0;
        unsigned worker_apart = 0;
        unsigned cache_shrunk = 0;
        unsigned master_killed = 0;
        unsigned power_cut = 0;
        unsigned master_stopped = 0;
        unsigned master_cut_off = 0;
        unsigned blocks_lost = 0; ///< Per mille of the master's deaths.
        unsigned disk_full = 0;
        unsigned disk_unreadable = 0;
        unsigned cancel = 0;
        unsigned liar = 0; ///< Per mille of workers.
    };

    /// `workers` 0: the seed chooses.
    void plan(std::size_t workers);
    void plan_liars();
    void plan_jobs();
    void plan_job(const KnownJob& job, ClusterOptions options);
    [[nodiscard]] ClusterOptions any_options();
    void tick();
    void cause_trouble();
    void cause_worker_trouble(WorkerProcess& worker);
    void cut_ways(Host& host);
    void stop_trouble();
    void start_worker();
    void end_worker(std::uint64_t id, bool silently);
    void end_master(bool by_power);
    void start_master();
    /// Returns false if the message must not be sent.
    bool observe(const Route& route, const Message& message);
    [[nodiscard]] bool is_deadly(const Message& message) const;
    [[nodiscard]] std::string check_client_hears(const Message& message) const;
    [[nodiscard]] std::string what_stands_still();
    void check();
    void check_caches();
    void check_cache(WorkerProcess& worker);
    void check_quarantine();
    [[nodiscard]] bool is_done() const;
    void inspect();
    void inspect_job(const ClientProcess& client);

    World world_;
    Dangers dangers_;
    NetworkFaults network_;
    std::size_t workers_wanted_ = 1;
    Time trouble_ends_;
    bool is_trouble_ = true;
    std::unique_ptr<MasterProcess> master_;
    std::map<std::uint64_t, std::unique_ptr<WorkerProcess>> workers_;
    std::vector<std::unique_ptr<ClientProcess>> clients_;
    std::set<std::uint64_t> clients_known_; ///< Hosts of known clients.
    std::size_t clients_to_come_ = 0;
    /// The scenario that kills every worker, by kind of job.
    std::map<std::string, std::uint64_t> deadly_;
    unsigned liars_ = 0;
    std::set<std::uint64_t> found_out_; ///< Hosts of exposed workers.
    std::uint64_t host_last_ = master_host;
    Outcome outcome_;
    std::uint64_t runs_ = 0; ///< Events in which the master ran.
    std::uint64_t runs_between_checks_ = 1;
};

[[nodiscard]] Outcome simulate(std::uint64_t seed, const SimulationOptions& options = {});

} // namespace cd::tests
