// One seed: a cluster, its jobs, and all that goes wrong with them.
//
// What always holds; where it is looked at; mutations that show there:
// - None is merged twice: CD_CHECK at the merge, Watcher::add_group. SecondAnswerMerged.
// - None is lost: Coordinator::check_job, the dispatcher's check_counts and check_job, check_kept
//   of what is acknowledged, inspect_job at the end. LostRangeForgotten, AnswerKeptTooEarly.
// - Who is taken for the holder of a block has it, or its word that it has not is under way:
//   check_cache; by what was said, Watcher::check_sources. EvictionNotTold, EvictionIgnored,
//   OthersSourceNamed.
// - No credit is below zero: check_counts (what is unsent), WorkerSession (results in hand).
//   RoomNotGivenBack, ReadsOn.
// - What is in flight is bounded: tasks at a worker by the dispatcher's check_flight, blocks and
//   all other bytes towards one peer by LinkEnd's check_flight and check_queue, results that are
//   not acknowledged by keeps_too_much. BatchesWithoutBound, TooMuchInFlight.
// - Every batch has a lease: Coordinator::check_leases, check_counts. LostLeaseForgotten.
// - There is progress after the last fault: stop_trouble. HeardAgainForgotten.
//
// What the dispatcher notes of a worker's roots promises no block: it holds for matching, and has
// in it what is planned or on its way.
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

/// What happened to a seed, or to several.
struct Outcome {
    std::vector<std::string> problems; ///< None: all is well.
    double seconds = 0;                ///< Simulated.
    std::uint64_t events = 0;
    std::uint64_t checks = 0;           ///< Of these, after which the master was looked at.
    std::uint64_t blocks_checked = 0;   ///< That the master believed a worker to hold.
    std::uint64_t scenarios = 0;        ///< Of all jobs;
    std::uint64_t scenarios_sent = 0;   ///< to workers, also again;
    std::uint64_t failed = 0;           ///< given up.
    std::uint64_t results_repeated = 0; ///< Messages.
    std::uint64_t masters = 0;          ///< Lives.
    std::uint64_t workers = 0;          ///< Lives;
    std::uint64_t answering = 0;        ///< of these who answered something.
    std::uint64_t cancelled = 0;        ///< Jobs.
    std::uint64_t recalled = 0;         ///< Scenarios that workers gave back;
    std::uint64_t copies = 0;           ///< that went to a second worker;
    std::uint64_t called_off = 0;       ///< of which another one need not answer any more.
    std::uint64_t late_messages = 0;    ///< Of a connection after its worker had greeted again.
    std::uint64_t late_results = 0;     ///< Messages, of a session before.
    std::uint64_t old_sessions = 0;     ///< With which workers wanted to go on, in vain.
    std::uint64_t lies = 0;             ///< Scenarios of which a worker told a wrong result;
    std::uint64_t found_out = 0;        ///< workers that were found wrong;
    std::uint64_t corrected = 0; ///< scenarios whose result was wrong on the disk for a time,
    std::uint64_t borne = 0;     ///< and those where it stays so: nobody could know.
    Troubles troubles;

    /// Of the counts and the problems.
    Outcome& operator+=(const Outcome& other);
    /// For people.
    [[nodiscard]] std::string counts() const;
};

struct SimulationOptions {
    bool logs = false;
    Mutation fault = Mutation::None;
    std::size_t workers = 0; ///< 0: as the seed says, a few; else there is a job for so many.
};

class Simulation {
  public:
    Simulation(std::uint64_t seed, const SimulationOptions& options);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    Outcome run();

  private:
    /// Of 1000 chances in a second each.
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
        unsigned blocks_lost = 0; ///< Of 1000 deaths of the master.
        unsigned disk_full = 0;
        unsigned disk_unreadable = 0;
        unsigned cancel = 0;
        unsigned liar = 0; ///< Of 1000 workers.
    };

    /// `workers`: 0, as the seed says.
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
    /// False: the message does not go out.
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
    std::set<std::uint64_t> clients_known_; ///< Their hosts.
    std::size_t clients_to_come_ = 0;
    /// By kind of job: what no worker survives.
    std::map<std::string, std::uint64_t> deadly_;
    unsigned liars_ = 0;
    std::set<std::uint64_t> found_out_; ///< Their hosts.
    std::uint64_t host_last_ = master_host;
    Outcome outcome_;
    std::uint64_t runs_ = 0; ///< Events in which the master ran,
    std::uint64_t runs_between_checks_ = 1;
};

/// With this fault switched on.
[[nodiscard]] Outcome simulate(std::uint64_t seed, const SimulationOptions& options = {});

} // namespace cd::tests
