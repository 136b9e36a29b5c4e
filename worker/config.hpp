// The options of cdworker: from its command line, CDWORKER_* in the environment, and a TOML file.
#pragma once

#include "common/core/limits/worker.hpp"
#include "common/core/result.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cd {

struct WorkerConfig {
    Endpoint master{"127.0.0.1", 7600};
    unsigned threads = 0;          ///< 0: one for each core that this process may use.
    std::uint64_t cache_bytes = 0; ///< Of geometry; by default half of `memory_limit`.
    double weight = 1;             ///< Factor of its speed in the master's estimates of time.
    std::string name;              ///< Shown to people.
    std::string simd;              ///< Name of a SIMD target; empty: CD_SIMD, or else the best.
    bool insecure = false;
    bool no_peers = false;       ///< Gives no geometry to other workers.
    std::uint16_t peer_port = 0; ///< Port for other workers; 0 lets the system choose.
    std::string log_level = "info";
    std::chrono::seconds connect_for{30}; ///< How long the first connection is tried.
    std::chrono::seconds drain_timeout = limits::drain_timeout;
    std::filesystem::path state;   ///< Folder of the credential.
    std::optional<JoinToken> join; ///< Use it to get a credential, then end.
};

/// A configuration; or none, with what to print instead (help on stdout, an error on stderr) and
/// the exit code.
struct WorkerCommandLine {
    std::optional<WorkerConfig> config;
    std::string text;
    int exit_code = 0;
};

/// The command line takes precedence over the environment, and that over the file of --config.
[[nodiscard]] WorkerCommandLine parse_worker_command_line(int count, const char* const* arguments);

/// "4GiB", "512 MiB", "1.5TiB" or a plain number of bytes; kB, MB, GB, TB are powers of 1000.
/// Errors: BadInput.
[[nodiscard]] Result<std::uint64_t> parse_size(const std::string& text);

} // namespace cd
