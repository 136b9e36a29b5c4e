// Limits the master's resources that one client may use at a time. A state machine: no clock, no
// sockets.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/master.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Counts resources by client: by the name in its certificate or, without TLS, by its host. A
/// faulty or hostile client thus leaves room for the others.
class Quotas {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using ScenariosOf = std::function<std::optional<std::uint64_t>(JobId)>;

    struct JobSize {
        std::uint64_t scenarios = 0;
        std::uint64_t bytes = 0; ///< Bytes of the job's poses.
    };

    struct Limits {
        std::size_t connections = limits::client_connections_max;
        std::size_t all_connections = limits::connections_max;
        std::size_t jobs = limits::client_jobs_max;             ///< Running jobs.
        std::uint64_t scenarios = limits::client_scenarios_max; ///< Unfinished scenarios.
        /// Bytes of meshes, poses and grids that a client may send at once: a leaky bucket, which
        /// drains in `period`.
        std::uint64_t bytes = limits::client_bytes_max;
        std::chrono::seconds period = timing::client_bytes_period;
        /// Bytes of poses of unfinished jobs.
        std::uint64_t queued = limits::client_queued_bytes_max;
        std::size_t uploads = limits::client_uploads_max; ///< Mesh uploads in progress.
    };

    /// `scenarios_of` returns the number of scenarios of a running job; empty if the job does not
    /// run.
    Quotas(const Limits& limits, ScenariosOf scenarios_of)
        : limits_(limits), scenarios_of_(std::move(scenarios_of)) {}

    // Errors of all members: Refused, naming the exceeded limit and the time until a retry.
    [[nodiscard]] Status connect(const std::string& client);
    void disconnect(const std::string& client);

    /// Counts received bytes, which `Limits::bytes` bounds.
    [[nodiscard]] Status take_bytes(const std::string& client, std::uint64_t bytes, Time now);

    [[nodiscard]] Status begin_upload(const std::string& client);
    void end_upload(const std::string& client);

    /// Counts bytes of a submission until `unqueue` or until its job ends.
    [[nodiscard]] Status queue(const std::string& client, std::uint64_t bytes);
    void unqueue(const std::string& client, std::uint64_t bytes);

    /// Reserves room for a job that is to be opened, until `add_job` or `give_up_job`.
    [[nodiscard]] Status begin_job(const std::string& client, std::uint64_t scenarios);
    /// Adds a job after `begin_job`. Its queued bytes count until the job ends.
    void add_job(const std::string& client, JobId job, const JobSize& size);
    void give_up_job(const std::string& client, std::uint64_t scenarios);

    /// Returns the running jobs and their clients as text.
    [[nodiscard]] std::string jobs_text();
    /// Adds the jobs of `jobs_text` after a restart. Ignores malformed lines and jobs not running.
    void restore_jobs(std::string_view text);

    /// Number of clients that have an entry.
    [[nodiscard]] std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        std::size_t connections = 0;
        std::size_t uploads = 0;
        std::size_t jobs_begun = 0;
        std::map<JobId, JobSize> jobs;
        std::uint64_t scenarios = 0; ///< Scenarios of running and begun jobs.
        std::uint64_t queued = 0;    ///< Bytes of running jobs and of submissions.
        double bytes = 0;            ///< Content of the leaky bucket at time `since`.
        Time since;
    };

    [[nodiscard]] double bytes_now(const Client& client, Time now) const;
    void forget_ended(Client& client) const;

    Limits limits_;
    ScenariosOf scenarios_of_;
    std::map<std::string, Client> clients_;
    std::size_t connections_ = 0; ///< Connections of all clients.
};

} // namespace cd
