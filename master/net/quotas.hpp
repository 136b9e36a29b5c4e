// Limits what one client may use of the master at a time. A state machine: no clock, no sockets.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Counts by client: the name in its certificate or, without TLS, its host. A faulty or hostile
/// client thus leaves room for the others.
class Quotas {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using ScenariosOf = std::function<std::optional<std::uint64_t>(JobId)>;

    struct JobSize {
        std::uint64_t scenarios = 0;
        std::uint64_t bytes = 0; ///< Bytes of its poses.
    };

    struct Limits {
        std::size_t connections = limits::client_connections_max;
        std::size_t all_connections = limits::connections_max;
        std::size_t jobs = limits::client_jobs_max;             ///< Running jobs.
        std::uint64_t scenarios = limits::client_scenarios_max; ///< Unfinished scenarios.
        /// Bytes of meshes, poses and grids that a client may send at once, and again in each
        /// `period`.
        std::uint64_t bytes = limits::client_bytes_max;
        std::chrono::seconds period = limits::client_bytes_period;
        /// Bytes of poses of unfinished jobs.
        std::uint64_t queued = limits::client_queued_bytes_max;
        std::size_t uploads = limits::client_uploads_max; ///< Mesh uploads in progress.
    };

    /// `scenarios_of` returns the open scenarios of an added job, or nothing if it no longer runs.
    Quotas(const Limits& limits, ScenariosOf scenarios_of)
        : limits_(limits), scenarios_of_(std::move(scenarios_of)) {}

    /// Errors of all members: Refused, saying which limit is exceeded and when to try again.
    [[nodiscard]] Status connect(const std::string& client);
    void disconnect(const std::string& client);

    [[nodiscard]] Status take_bytes(const std::string& client, std::uint64_t bytes, Time now);

    [[nodiscard]] Status begin_upload(const std::string& client);
    void end_upload(const std::string& client);

    /// Counts bytes of a submission until `unqueue`, or as long as its job runs.
    [[nodiscard]] Status queue(const std::string& client, std::uint64_t bytes);
    void unqueue(const std::string& client, std::uint64_t bytes);

    /// Reserves room for a job before it is opened, until it is added or abandoned.
    [[nodiscard]] Status begin_job(const std::string& client, std::uint64_t scenarios);
    /// Adds a job begun by `begin_job`. Its queued bytes now count for the job.
    void add_job(const std::string& client, JobId job, const JobSize& size);
    void give_up_job(const std::string& client, std::uint64_t scenarios);

    /// Writes the owners of jobs as text, and reads them after a restart. Malformed lines are
    /// ignored.
    [[nodiscard]] std::string jobs_text();
    void restore_jobs(std::string_view text);

    /// Number of remembered clients.
    [[nodiscard]] std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        std::size_t connections = 0;
        std::size_t uploads = 0;
        std::size_t jobs_begun = 0;
        std::map<JobId, JobSize> jobs;
        std::uint64_t scenarios = 0; ///< Scenarios of running and begun jobs.
        std::uint64_t queued = 0;    ///< Bytes of running jobs and of submissions.
        double bytes = 0;            ///< Level of the rate limit at `since`; it drains with time.
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
