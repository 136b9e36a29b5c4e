#include "master/config.hpp"

#include "common/core/build_info.hpp"
#include "common/core/duration.hpp"
#include "common/core/files/state_folder.hpp"
#include "common/core/host/daemon_options.hpp"
#include "common/core/host/man_page.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/wire.hpp"
#include "common/geometry/simd_target.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace cd {

namespace {

constexpr const char* help =
    "Examples:\n"
    "  cdmaster                                   this machine only, port 7600\n"
    "  cdmaster --listen 127.0.0.1:0 --port-file port   the system chooses the port\n"
    "  cdmaster init                              makes an identity; connections then need TLS\n"
    "  cdmaster --listen 0.0.0.0:7600             all interfaces, with an identity\n"
    "  cdmaster --listen 0.0.0.0:7600 --insecure  without TLS, on a trusted network\n"
    "  cdmaster check --state DIR                 reports damage in a state directory\n"
    "  cdmaster --config /etc/cdcluster/cdmaster.toml\n"
    "\n"
    "Takes jobs from cdctl and distributes them to cdworkers. Prints the command that starts a\n"
    "worker. Options may also be set in the file of --config, as in\n"
    "`listen = \"127.0.0.1:7600\"`, and in the environment, as in CDMASTER_LISTEN.\n"
    "\n"
    "With an identity, everyone needs a certificate. `cdctl token create` prints a token;\n"
    "`cdworker join` and `cdctl join` exchange it for a certificate, which they renew.\n"
    "\n"
    "Exit codes: 0 ended by SIGINT or SIGTERM; 2 wrong usage, cannot start, or a damaged state; 5\n"
    "refused to listen beyond loopback without an identity or --insecure.";

constexpr const char* environment_prefix = "CDMASTER_";

std::string this_host() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "HOST";
}

double seconds(FailureTimes::Duration time) {
    return std::chrono::duration<double>(time).count();
}

/// Option values as CLI11 reads them; the functions below parse and check them.
struct Texts {
    std::string listen = "127.0.0.1:7600";
    std::string http;
    std::string state = state_folder().string();
    std::string certificate_life = "7d";
    std::string keep_jobs = std::to_string(limits::jobs_ended_kept_max);
    double heartbeat_seconds = seconds(FailureTimes().heartbeat);
    double lost_after_seconds = seconds(FailureTimes().lost_after);
    double return_within_seconds = seconds(FailureTimes().return_within);
};

/// Converts the times of the options. Errors: BadInput for times that are too short.
Result<FailureTimes> failure_times(const Texts& texts) {
    const auto milliseconds = [](double value) {
        return FailureTimes::Duration(std::llround(1000 * value));
    };
    FailureTimes times;
    times.heartbeat = milliseconds(texts.heartbeat_seconds);
    times.lost_after = milliseconds(texts.lost_after_seconds);
    times.return_within = milliseconds(texts.return_within_seconds);
    times.forgotten_after = std::max(times.forgotten_after, times.lost_after);
    if (std::isnan(texts.return_within_seconds)) {
        return Error{ErrorCode::BadInput, "--return-within: not a number"};
    }
    if (times.heartbeat < timing::heartbeat_period_min) {
        return Error{ErrorCode::BadInput, "--heartbeat: less than 0.01"};
    }
    if (times.lost_after < times.silent_after()) {
        return Error{ErrorCode::BadInput,
                     "--lost-after: less than " + std::to_string(limits::heartbeats_missed_max) +
                         " heartbeats"};
    }
    return times;
}

void add_options(CLI::App& app, MasterConfig& config, Texts& texts) {
    const auto option = [](CLI::Option* added, const char* type) {
        added->envname(environment_name(environment_prefix, added->get_lnames().front()))
            ->type_name(type);
        return added;
    };
    option(app.add_option("--listen", texts.listen, "Address for workers and clients"), "HOST:PORT")
        ->capture_default_str();
    option(app.add_option("--http",
                          texts.http,
                          "Address that serves the page, /healthz, /readyz and /metrics"),
           "HOST:PORT");
    option(app.add_option("--http-name",
                          config.http.names,
                          "A further name of this server in browsers' addresses, besides loopback "
                          "and master; may be repeated")
               ->delimiter(','),
           "HOST");
    option(
        app.add_option("--state",
                       texts.state,
                       "State directory: meshes, jobs, results; without XDG_STATE_HOME and HOME, "
                       "cdcluster-state in the current folder"),
        "DIR")
        ->capture_default_str();
    option(app.add_option(
               "--threads", config.threads, "Threads for trees and analysis; 0: one per core"),
           "N")
        ->check(CLI::Range(0u, 4096u))
        ->capture_default_str();
    option(app.add_flag(
               "--insecure", config.insecure, "Allow connections beyond loopback without TLS"),
           "");
    option(app.add_flag("--no-sync",
                        config.no_sync,
                        "Do not sync to disk: a power loss may destroy the state"),
           "");
    option(app.add_option("--certificate-ttl",
                          texts.certificate_life,
                          "Lifetime of certificates; holders renew them after half of it"),
           "DURATION")
        ->capture_default_str();
    option(app.add_option("--keep-jobs",
                          texts.keep_jobs,
                          "Keep this many ended jobs (1000), or each for this long (30d)"),
           "N|DURATION")
        ->capture_default_str();
    const CLI::Range times(
        0.0, std::chrono::duration<double>(timing::peer_lost_after_max).count(), "SECONDS");
    option(
        app.add_option("--heartbeat",
                       texts.heartbeat_seconds,
                       "Period of heartbeats; after three missed ones a worker gets no new work"),
        "SECONDS")
        ->check(times)
        ->capture_default_str();
    option(app.add_option("--lost-after",
                          texts.lost_after_seconds,
                          "Silence after which a worker is lost and its work goes to others"),
           "SECONDS")
        ->check(times)
        ->capture_default_str();
    option(app.add_option("--return-within",
                          texts.return_within_seconds,
                          "Time that a worker has to reconnect, after its connection broke or the "
                          "master restarted, before its work goes to others"),
           "SECONDS")
        ->check(times)
        ->capture_default_str();
    option(app.add_option("--log-level", config.log.level, "Least severe level that is logged"),
           "LEVEL")
        ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}))
        ->capture_default_str();
    option(app.add_option("--log-format", config.log.format, "Form of log lines"), "FORMAT")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    option(app.add_option("--port-file", config.port_file, "Write the port into this file"),
           "FILE");
    app.set_config("--config", "", "A TOML file with these options")
        ->envname("CDMASTER_CONFIG")
        ->type_name("FILE");
    app.config_formatter(make_toml_config(app, environment_prefix));
}

MasterCommandLine refused(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream errors;
    const bool is_failure = app.exit(error, out, errors) != 0;
    return {std::nullopt, is_failure ? "cdmaster: " + errors.str() : out.str(), is_failure ? 2 : 0};
}

} // namespace

MasterCommandLine parse_master_command_line(int count, const char* const* arguments) {
    const std::vector<std::string> words(arguments + std::min(count, 1), arguments + count);
    if (auto answer = version_answer("cdmaster", to_text(simd_target()), words)) {
        return {std::nullopt, *std::move(answer), 0};
    }
    MasterConfig config;
    Texts texts;
    CLI::App app(help, "cdmaster");
    app.formatter(make_examples_first());
    app.set_version_flag("--version",
                         version_text("cdmaster", to_text(simd_target()), false),
                         "Version, commit, compiler, libraries; with -o json for programs");
    app.set_help_flag("-h,--help", "This text");
    add_options(app, config, texts);
    app.fallthrough(); // Lets --state follow the subcommand.
    const CLI::App* const check =
        app.add_subcommand("check", "Check the state directory for damage; change nothing");
    const CLI::App* const init =
        app.add_subcommand("init", "Make an identity in the state directory");
    app.require_subcommand(0, 1);
    if (words == std::vector<std::string>{"--man"}) {
        return {std::nullopt,
                man_page(app, 8, "takes jobs from cdctl and distributes them to workers"),
                0};
    }
    try {
        app.parse(count, arguments);
    } catch (const CLI::ParseError& error) {
        return refused(app, error);
    }
    config.check = check->parsed();
    const Result<Endpoint> endpoint = parse_endpoint(texts.listen);
    if (!endpoint) {
        return {std::nullopt, "cdmaster: --listen: " + endpoint.error().detail + "\n", 2};
    }
    if (!texts.http.empty()) {
        const Result<Endpoint> http = parse_endpoint(texts.http);
        if (!http) {
            return {std::nullopt, "cdmaster: --http: " + http.error().detail + "\n", 2};
        }
        config.http.listen = http.value();
    }
    const Result<std::chrono::seconds> life = parse_duration(texts.certificate_life);
    if (!life || life.value() < timing::certificate_life_min) {
        return {std::nullopt,
                "cdmaster: --certificate-ttl: " +
                    (life ? "too short for a renewal" : life.error().detail) + "\n",
                2};
    }
    const Result<JobRetention> retention = parse_retention(texts.keep_jobs);
    if (!retention) {
        return {std::nullopt, "cdmaster: --keep-jobs: " + retention.error().detail + "\n", 2};
    }
    config.retention = retention.value();
    const Result<FailureTimes> times = failure_times(texts);
    if (!times) {
        return {std::nullopt, "cdmaster: " + times.error().detail + "\n", 2};
    }
    config.times = times.value();
    config.init = init->parsed();
    config.certificate_life = life.value();
    config.listen = endpoint.value();
    config.state = texts.state;
    return {std::move(config), "", 0};
}

std::string join_line(const Endpoint& listening, bool secured) {
    std::string host = listening.host;
    if (host == "0.0.0.0" || host == "::") {
        host = this_host();
    } else if (host.find(':') != std::string::npos) {
        host = "[" + host + "]";
    }
    const std::string master = host + ":" + std::to_string(listening.port);
    if (secured) {
        return "cdworker join " + master + " --token TOKEN && cdworker --master " + master;
    }
    return "cdworker --master " + master + (is_loopback(listening) ? "" : " --insecure");
}

} // namespace cd
