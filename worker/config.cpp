#include "worker/config.hpp"

#include "common/core/build_info.hpp"
#include "common/core/files/state_folder.hpp"
#include "common/core/host/daemon_options.hpp"
#include "common/core/host/man_page.hpp"
#include "common/core/host/memory_limit.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/worker.hpp"
#include "common/geometry/simd_target.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

namespace cd {
namespace {

constexpr const char* help =
    "Examples:\n"
    "  cdworker                                          a master on this machine, all cores\n"
    "  cdworker join node-1:7600 --token T               once; `cdctl token create` prints T\n"
    "  cdworker --master node-1:7600                     after that, with TLS\n"
    "  cdworker --master node-1:7600 --insecure          without TLS, on a trusted network\n"
    "  cdworker --threads 8 --cache 16GiB --name blade-3\n"
    "  CDWORKER_MASTER=127.0.0.1:7600 cdworker --config /etc/cdcluster/cdworker.toml\n"
    "\n"
    "Runs collision tests for a cdmaster. Start one on each host: its threads share one cache\n"
    "of geometry. Options may also stand in the file of --config, as in `cache = \"4GiB\"`, and\n"
    "in the environment, as in CDWORKER_CACHE.\n"
    "\n"
    "SIGINT or SIGTERM: the worker returns the scenarios that it has not begun, finishes the\n"
    "others and ends. After --drain-timeout it returns those that still run, too. A second\n"
    "signal ends it at once.\n"
    "\n"
    "A worker stays until it is told to end, whatever happens to the master. With --idle-exit\n"
    "and --orphan-exit it leaves by itself, for hosts that are paid by the hour.\n"
    "\n"
    "Exit codes: 0 ended as asked, or idle for --idle-exit; 2 wrong usage; 4 no master within\n"
    "--connect-for, or for --orphan-exit; 5 refused by the master, or no credential; 130 ended\n"
    "at once by a second signal. If TLS refuses the certificate of a worker that was accepted\n"
    "before, the worker retries for an hour, since a clock may be wrong.";

constexpr const char* environment_prefix = "CDWORKER_";

std::string default_name() {
    boost::system::error_code error;
    const std::string host = asio::ip::host_name(error);
    return (error ? "worker" : host) + "-" + std::to_string(::getpid());
}

/// Options that CLI11 reads as text and `parse_worker_command_line` converts.
struct Texts {
    std::string master = "127.0.0.1:7600";
    std::string cache = "auto";
    std::int64_t connect_for = 30;
    std::int64_t drain_timeout = timing::drain_timeout.count();
    std::optional<std::int64_t> idle_exit;
    std::optional<std::int64_t> orphan_exit;
    std::string state = (state_folder() / "worker").string();
    std::string token;
    std::string token_file;
};

void add_options(CLI::App& app, WorkerConfig& config, Texts& texts) {
    const auto option = [](CLI::Option* added, const char* type) {
        added->envname(environment_name(environment_prefix, added->get_lnames().front()))
            ->type_name(type);
        return added;
    };
    option(app.add_option("--master", texts.master, "The master to work for"), "HOST:PORT")
        ->capture_default_str();
    option(app.add_option(
               "--threads", config.threads, "Number of threads that compute; 0: one per core"),
           "N")
        ->check(CLI::Range(0u, limits::worker_threads_max))
        ->capture_default_str();
    option(app.add_option(
               "--cache",
               texts.cache,
               "Memory limit for geometry; auto: half of the memory that this process may use"),
           "SIZE")
        ->capture_default_str();
    option(app.add_option(
               "--weight", config.weight, "Factor of this host's share of the work; 0.5 halves it"),
           "FACTOR")
        ->check(CLI::Range(0.001, limits::worker_weight_max))
        ->capture_default_str();
    option(
        app.add_option("--name",
                       config.name,
                       "Name of this worker in logs and reports; default: host and process number"),
        "TEXT");
    option(app.add_option("--simd",
                          config.simd,
                          "SIMD instructions: avx512, avx2, sse4, neon, scalar or auto; the "
                          "results are the same"),
           "TARGET");
    option(
        app.add_option("--state", texts.state, "Folder of the credential file that `join` writes"),
        "DIR")
        ->capture_default_str();
    option(
        app.add_flag("--insecure", config.insecure, "Allow a master on another host without TLS"),
        "");
    option(app.add_flag("--no-peers",
                        config.no_peers,
                        "Send no geometry to other workers; they get it from the master"),
           "");
    option(app.add_option("--peer-port",
                          config.peer_port,
                          "Port on which other workers fetch geometry; 0: the system chooses one"),
           "PORT")
        ->capture_default_str();
    option(app.add_option("--log-level", config.log.level, "Least severe level that is logged"),
           "LEVEL")
        ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}))
        ->capture_default_str();
    option(app.add_option("--log-format", config.log.format, "Form of log lines"), "FORMAT")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    option(app.add_option("--connect-for",
                          texts.connect_for,
                          "Time limit of the attempts to connect for the first time"),
           "SECONDS")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000}))
        ->capture_default_str();
    option(
        app.add_option("--drain-timeout",
                       texts.drain_timeout,
                       "Time limit for running scenarios after a signal; then they are returned"),
        "SECONDS")
        ->check(CLI::Range(std::int64_t{0},
                           std::int64_t{std::chrono::seconds(timing::drain_timeout_max).count()}))
        ->capture_default_str();
    const CLI::Range leave_after(std::int64_t{1}, std::int64_t{1'000'000'000});
    option(app.add_option("--idle-exit",
                          texts.idle_exit,
                          "Leave after this time without work while the master is there: drain, "
                          "exit with 0; default: never"),
           "SECONDS")
        ->check(leave_after);
    option(app.add_option("--orphan-exit",
                          texts.orphan_exit,
                          "Leave after this time without the master, which was there before: log "
                          "what it did not take, exit with 4; default: never"),
           "SECONDS")
        ->check(leave_after);
    app.set_config("--config", "", "A TOML file with these options")
        ->envname("CDWORKER_CONFIG")
        ->type_name("FILE");
    app.config_formatter(make_toml_config(app, environment_prefix));
}

std::optional<std::chrono::seconds> seconds_of(const std::optional<std::int64_t>& count) {
    return count ? std::optional(std::chrono::seconds(*count)) : std::nullopt;
}

CLI::App* add_join(CLI::App& app, Texts& texts) {
    CLI::App* join =
        app.add_subcommand("join", "Get a certificate from a master with a token, and end");
    join->fallthrough();
    join->add_option("master", texts.master, "The master to join")
        ->required()
        ->type_name("HOST:PORT");
    CLI::Option* token =
        join->add_option("--token", texts.token, "Token that `cdctl token create` printed")
            ->envname("CDWORKER_TOKEN")
            ->type_name("TOKEN");
    join->add_option("--token-file", texts.token_file, "File with the token in its first line")
        ->excludes(token)
        ->envname("CDWORKER_TOKEN_FILE")
        ->type_name("FILE");
    return join;
}

Result<JoinToken> token_of(const Texts& texts) {
    if (texts.token_file.empty()) {
        return parse_join_token(texts.token);
    }
    std::ifstream file(texts.token_file);
    std::string line;
    if (!std::getline(file, line)) {
        return Error{ErrorCode::BadInput, "cannot read a token from '" + texts.token_file + "'"};
    }
    return parse_join_token(line);
}

WorkerCommandLine refused(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream errors;
    const bool is_failure = app.exit(error, out, errors) != 0;
    return {std::nullopt, is_failure ? "cdworker: " + errors.str() : out.str(), is_failure ? 2 : 0};
}

WorkerCommandLine wrong(const std::string& option, const Error& error) {
    return {std::nullopt, "cdworker: " + option + ": " + error.detail + "\n", 2};
}

Status check_name(const std::string& name) {
    if (name.size() > limits::hello_text_bytes_max || !is_printable(name)) {
        return Error{ErrorCode::BadInput,
                     "expected at most " + std::to_string(limits::hello_text_bytes_max) +
                         " printable characters"};
    }
    return Done{};
}

} // namespace

WorkerCommandLine parse_worker_command_line(int count, const char* const* arguments) {
    const std::vector<std::string> words(arguments + std::min(count, 1), arguments + count);
    if (auto answer = version_answer("cdworker", to_text(simd_target()), words)) {
        return {std::nullopt, *std::move(answer), 0};
    }
    WorkerConfig config;
    config.name = default_name();
    Texts texts;
    CLI::App app(help, "cdworker");
    app.formatter(make_examples_first());
    app.set_version_flag(
        "--version",
        version_text("cdworker", to_text(simd_target()), false),
        "Print version, commit, compiler and libraries; with -o json for programs");
    app.set_help_flag("-h,--help", "Print this text");
    add_options(app, config, texts);
    const CLI::App* join = add_join(app, texts);
    if (words == std::vector<std::string>{"--man"}) {
        return {
            std::nullopt, man_page(app, 8, "runs the collision tests that a master assigns"), 0};
    }
    try {
        app.parse(count, arguments);
    } catch (const CLI::ParseError& error) {
        return refused(app, error);
    }
    const Result<Endpoint> master = parse_endpoint(texts.master);
    if (!master) {
        return wrong("--master", master.error());
    }
    const Result<std::uint64_t> cache =
        texts.cache == "auto" ? Result<std::uint64_t>(memory_limit() / 2) : parse_size(texts.cache);
    if (!cache) {
        return wrong("--cache", cache.error());
    }
    if (const Status name = check_name(config.name); !name) {
        return wrong("--name", name.error());
    }
    if (join->parsed()) {
        const Result<JoinToken> token = token_of(texts);
        if (!token) {
            return wrong("--token", token.error());
        }
        config.join = token.value();
    }
    config.state = texts.state;
    config.master = master.value();
    config.cache_bytes = cache.value();
    config.times.connect_for = std::chrono::seconds(texts.connect_for);
    config.times.drain_timeout = std::chrono::seconds(texts.drain_timeout);
    config.times.leave = {seconds_of(texts.idle_exit), seconds_of(texts.orphan_exit)};
    return {std::move(config), "", 0};
}

Result<std::uint64_t> parse_size(const std::string& text) {
    static constexpr std::array<std::pair<std::string_view, double>, 10> units{{
        {"", 1},
        {"B", 1},
        {"KiB", 1024.0},
        {"MiB", 1048576.0},
        {"GiB", 1073741824.0},
        {"TiB", 1099511627776.0},
        {"kB", 1e3},
        {"MB", 1e6},
        {"GB", 1e9},
        {"TB", 1e12},
    }};
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    std::string_view unit(rest, static_cast<std::size_t>(end - rest));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const auto* const found =
        std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.first == unit; });
    if (error != std::errc() || found == units.end() || !(number >= 0) ||
        number * found->second > 1e18) {
        return Error{ErrorCode::BadInput,
                     "'" + text + "' is no size: expected a number and a unit, such as 4GiB"};
    }
    return static_cast<std::uint64_t>(number * found->second);
}

} // namespace cd
