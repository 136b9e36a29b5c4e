// How much of the master one client may have at a time. A state machine: no clock, no sockets.
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

/// Counts by client: the name in its certificate, or, without TLS, the host that it comes from. So
/// that one client, gone wrong or hostile, leaves room for the others.
class Quotas {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using ScenariosOf = std::function<std::optional<std::uint64_t>(JobId)>;

    struct JobSize {
        std::uint64_t scenarios = 0;
        std::uint64_t bytes = 0; ///< Of its poses.
    };

    struct Limits {
        std::size_t connections = limits::client_connections_max;
        std::size_t all_connections = limits::connections_max;
        std::size_t jobs = limits::client_jobs_max;             ///< Running.
        std::uint64_t scenarios = limits::client_scenarios_max; ///< Of these.
        /// Of meshes, poses and grids, that it may send at once, and again in each `period`.
        std::uint64_t bytes = limits::client_bytes_max;
        std::chrono::seconds period = limits::client_bytes_period;
        std::uint64_t queued = limits::client_queued_bytes_max; ///< Poses of what is not done.
        std::size_t uploads = limits::client_uploads_max;       ///< Of meshes, begun.
    };

    /// `scenarios_of` tells of jobs that were added: nothing when they do not run any more.
    Quotas(const Limits& limits, ScenariosOf scenarios_of)
        : limits_(limits), scenarios_of_(std::move(scenarios_of)) {}

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
    [[nodiscard]] Status begin_job(const std::string& client, std::uint64_t scenarios);
    /// The last step of one that was begun. Its bytes, which were queued, are its own from now on.
    void add_job(const std::string& client, JobId job, const JobSize& size);
    void give_up_job(const std::string& client, std::uint64_t scenarios);

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
        std::map<JobId, JobSize> jobs;
        std::uint64_t scenarios = 0; ///< Of these, and of those that are begun.
        std::uint64_t queued = 0;    ///< Bytes of these, and of what is being submitted.
        double bytes = 0;            ///< At `since`; they leak away with time.
        Time since;
    };

    [[nodiscard]] double bytes_now(const Client& client, Time now) const;
    void forget_ended(Client& client) const;

    Limits limits_;
    ScenariosOf scenarios_of_;
    std::map<std::string, Client> clients_;
    std::size_t connections_ = 0; ///< Of all.
};

} // namespace cd
