// One seed: a cluster, its jobs, and all that goes wrong with them.
#pragma once

#include "master/mutation.hpp"
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
    std::uint64_t scenarios = 0;        ///< Of all jobs;
    std::uint64_t scenarios_sent = 0;   ///< to workers, also again;
    std::uint64_t failed = 0;           ///< given up.
    std::uint64_t results_repeated = 0; ///< Messages.
    std::uint64_t masters = 0;          ///< Lives.
    std::uint64_t workers = 0;          ///< Lives.
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
    std::size_t workers = 0; ///< 0: as the seed says, a few.
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
        unsigned master_killed = 0;
        unsigned power_cut = 0;
        unsigned master_stopped = 0;
        unsigned disk_full = 0;
        unsigned cancel = 0;
        unsigned liar = 0; ///< Of 1000 workers.
    };

    /// `workers`: 0, as the seed says.
    void plan(std::size_t workers);
    void plan_liars();
    void plan_jobs();
    void tick();
    void cause_trouble();
    void cause_worker_trouble(WorkerProcess& worker);
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
};

/// With this fault switched on.
[[nodiscard]] Outcome simulate(std::uint64_t seed, const SimulationOptions& options = {});

} // namespace cd::tests
