// The options of cdworker, from the command line, CDWORKER_* variables and a TOML file.
#pragma once

#include "common/core/host/log_style.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/worker.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/channel.hpp"
#include "worker/membership/leave_rule.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cd {

/// How long a worker waits before it ends.
struct WorkerTimes {
    std::chrono::seconds connect_for{30}; ///< For the first connection.
    std::chrono::seconds drain_timeout = timing::drain_timeout;
    LeaveLimits leave; ///< Before it leaves by itself.
};

struct WorkerConfig {
    Endpoint master{"127.0.0.1", 7600};
    unsigned threads = 0;          ///< 0: one per core that this process may use.
    std::uint64_t cache_bytes = 0; ///< Limit for geometry; default: half of `memory_limit`.
    double weight = 1;             ///< Speed factor in the master's time estimates.
    std::string name;              ///< Display name.
    std::string simd;              ///< SIMD target; empty: CD_SIMD, or else the best one.
    bool insecure = false;         ///< Allows plain TCP with other hosts.
    bool no_peers = false;         ///< Serves no geometry to other workers.
    std::uint16_t peer_port = 0;   ///< Port for other workers; 0: the system chooses.
    LogOptions log;
    WorkerTimes times;
    std::filesystem::path state;   ///< Folder of the credential file.
    std::optional<JoinToken> join; ///< If set: get a credential with this token, then end.
};

/// Either a configuration, or a text to print and an exit code. Help goes to stdout, errors to
/// stderr.
struct WorkerCommandLine {
    std::optional<WorkerConfig> config;
    std::string text;
    int exit_code = 0;
};

/// Parses all options. Precedence: command line, environment, file of --config.
[[nodiscard]] WorkerCommandLine parse_worker_command_line(int count, const char* const* arguments);

/// Parses a size in bytes: "4GiB", "512 MiB", "1.5TiB" or a plain number; kB, MB, GB and TB are
/// powers of 1000. Errors: BadInput.
[[nodiscard]] Result<std::uint64_t> parse_size(const std::string& text);

} // namespace cd
