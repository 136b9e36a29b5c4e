// Options of cdmaster: from the command line, CDMASTER_* in the environment, and a TOML file.
#pragma once

#include "common/core/host/log_style.hpp"
#include "common/core/timing/master.hpp"
#include "master/jobs/job_retention.hpp"
#include "master/workers/worker_watch.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd {

struct HttpConfig {
    std::optional<Endpoint> listen; ///< Address of the page, health and metrics. Empty: none.
    std::vector<std::string> names; ///< Further names of this server in the header Host.
};

struct MasterConfig {
    Endpoint listen{"127.0.0.1", 7600}; ///< With port 0, the system chooses one.
    std::filesystem::path state;        ///< State directory.
    unsigned threads = 0;               ///< 0: one thread per core.
    bool insecure = false;              ///< Allow to listen beyond loopback without TLS.
    bool check = false;                 ///< `cdmaster check`: check the state, then exit.
    bool no_sync = false; ///< Do not sync; for a state that need not survive a power loss.
    LogOptions log;
    std::string port_file; ///< File that receives the port, for scripts. Empty: none.
    HttpConfig http;
    bool init = false; ///< `cdmaster init`: create an identity, then exit.
    std::chrono::seconds certificate_life = timing::certificate_life;
    FailureTimes times;
    JobRetention retention; ///< Retention of ended jobs.
};

/// Holds a configuration, or text to print instead.
struct MasterCommandLine {
    std::optional<MasterConfig> config; ///< Empty: print `text` and exit with `exit_code`.
    std::string text;                   ///< For stdout if `exit_code` is 0, else for stderr.
    int exit_code = 0;
};

/// Reads all options. The command line overrides the environment, which overrides the file of
/// --config.
[[nodiscard]] MasterCommandLine parse_master_command_line(int count, const char* const* arguments);

/// Returns the command with which a worker joins a master listening at this endpoint.
[[nodiscard]] std::string join_line(const Endpoint& listening, bool secured = false);

} // namespace cd
