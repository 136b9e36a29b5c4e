// How much of the master one client may have at a time. A state machine: no clock, no sockets.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits.hpp"
#include "common/core/limits_clients.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace cd {

/// Counts by client: the name in its certificate, or, without TLS, the host that it comes from. So
/// that one client, gone wrong or hostile, leaves room for the others.
class Quotas {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using IsRunning = std::function<bool(JobId)>;

    struct Limits {
        std::size_t connections = limits::client_connections_max;
        std::size_t jobs = limits::client_jobs_max; ///< Running.
        /// Of meshes, poses and grids, that it may send at once, and again in each `period`.
        std::uint64_t bytes = limits::client_bytes_max;
        std::chrono::seconds period = limits::client_bytes_period;
        std::uint64_t queued = limits::client_queued_bytes_max; ///< Poses of what is not done.
        std::size_t uploads = limits::client_uploads_max;       ///< Of meshes, begun.
    };

    /// `is_running` tells of jobs that were added.
    Quotas(const Limits& limits, IsRunning is_running)
        : limits_(limits), is_running_(std::move(is_running)) {}

    /// Errors, of all: Refused, saying what there is too much of, and when to try again.
    [[nodiscard]] Status connect(const std::string& client);
    void disconnect(const std::string& client);

    [[nodiscard]] Status take_bytes(const std::string& client, std::uint64_t bytes, Time now);

    [[nodiscard]] Status begin_upload(const std::string& client);
    void end_upload(const std::string& client);

    /// Of a job that is being submitted; they count until `unqueue`, or as long as its job runs.
    [[nodiscard]] Status queue(const std::string& client, std::uint64_t bytes);
    void unqueue(const std::string& client, std::uint64_t bytes);

    /// Before a job is opened: its place is taken, until it is added or given up.
    [[nodiscard]] Status begin_job(const std::string& client);
    /// The last step of one that was begun. `bytes`, which were queued, are its own from now on.
    void add_job(const std::string& client, JobId job, std::uint64_t bytes);
    void give_up_job(const std::string& client);

    /// Which jobs are whose, as text; and back, after a restart. Lines that are none are passed
    /// over.
    [[nodiscard]] std::string jobs_text();
    void restore_jobs(std::string_view text);

    /// Of whom anything is remembered.
    [[nodiscard]] std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        std::size_t connections = 0;
        std::size_t uploads = 0;
        std::size_t jobs_begun = 0;
        std::map<JobId, std::uint64_t> jobs; ///< With their bytes.
        std::uint64_t queued = 0;            ///< Of these, and of what is being submitted.
        double bytes = 0;                    ///< At `since`; they leak away with time.
        Time since;
    };

    [[nodiscard]] double bytes_now(const Client& client, Time now) const;
    void forget_ended(Client& client) const;

    Limits limits_;
    IsRunning is_running_;
    std::map<std::string, Client> clients_;
};

} // namespace cd
