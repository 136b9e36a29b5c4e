// How much of the master one client may have at a time. A state machine: no clock, no sockets.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cd {

/// Counts by client: the name in its certificate, or, without TLS, the host that it comes from. So
/// that one client, gone wrong or hostile, leaves room for the others.
class Quotas {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Limits {
        std::size_t connections = limits::client_connections_max;
        std::size_t jobs = limits::client_jobs_max; ///< Running.
        /// Of meshes and poses, that it may send at once, and again in each `period`.
        std::uint64_t bytes = limits::client_bytes_max;
        std::chrono::seconds period = limits::client_bytes_period;
    };

    Quotas() = default;
    explicit Quotas(const Limits& limits) : limits_(limits) {}

    /// Errors, of all: Refused, saying what there is too much of.
    [[nodiscard]] Status connect(const std::string& client);
    void disconnect(const std::string& client);

    /// Before a job is opened. `is_running` tells of the client's earlier ones.
    [[nodiscard]] Status check_jobs(const std::string& client,
                                    const std::function<bool(JobId)>& is_running);
    void add_job(const std::string& client, JobId job);

    [[nodiscard]] Status take_bytes(const std::string& client, std::uint64_t bytes, Time now);

    /// Of whom anything is remembered.
    [[nodiscard]] std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        std::size_t connections = 0;
        std::vector<JobId> jobs;
        double bytes = 0; ///< At `since`; they leak away with time.
        Time since;
    };

    [[nodiscard]] double bytes_now(const Client& client, Time now) const;

    Limits limits_;
    std::map<std::string, Client> clients_;
};

} // namespace cd
