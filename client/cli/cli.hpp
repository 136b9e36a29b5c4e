// The command line of cdctl: verbs and their options, as plain values.
#pragma once

#include "client/spec/job_options.hpp"
#include "common/core/limits/client.hpp"
#include "common/pair/triangle_pair.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cd {

/// How to reach the master, for verbs that need one, and how a job goes to it.
struct MasterOptions {
    std::string address; ///< HOST:PORT
    bool insecure = false;
    std::string credential; ///< A file, or "none"; empty: the file that `cdctl join` wrote, if any.
    std::optional<std::int32_t> priority = {}; ///< Of a job that the verb submits.
};

/// What gives exit code 1.
struct FailOn {
    bool near = false;  ///< Near, or contact of any kind.
    bool touch = false; ///< Contact of any kind.
    bool cross = false; ///< Cross or inside.
    bool undecided = false;
    bool news = false; ///< A group that the baseline does not have and nobody approved.

    [[nodiscard]] bool any() const { return near || touch || cross || undecided || news; }
    friend bool operator==(const FailOn&, const FailOn&) = default;
};

/// What a run's groups are judged by.
struct JudgeOptions {
    std::string baseline; ///< An earlier run: a results folder, or a job's id; empty: none.
    std::string statuses; ///< A file of statuses; empty: none.

    [[nodiscard]] bool is_empty() const { return baseline.empty() && statuses.empty(); }
};

/// Options for results folders.
struct FolderFlags {
    bool overwrite = false;
    bool fresh = false;
    bool no_inputs = false;
};

/// How scenarios are run on this machine.
struct HostOptions {
    unsigned threads = 0; ///< 0: one per core.
    std::string simd;     ///< A SIMD target's name; empty: CD_SIMD, or else the best.
    std::optional<PairStage> first_stage; ///< First stage that decides pairs; nothing: the default.
    std::string tree_cache = "off";       ///< A folder, or off.
};

/// How large the results on disk may become.
struct RoomOptions {
    bool yes = false; ///< Write results even if larger than `results_bytes_max`.
    std::uint64_t results_bytes_max = limits::folder_bytes_unasked_max;
};

struct RunCommand {
    JobOptions job; ///< `job.file` may be a results folder.
    FolderFlags folder;
    MasterOptions master; ///< Without an address, the job runs on this machine.
    HostOptions host;
    FailOn fail_on;
    JudgeOptions judge; ///< Needs a results folder.
    bool dry_run = false;
    std::string reuse; ///< An earlier run whose results are reused; empty: none.
    RoomOptions room;
    bool quiet = false;
    bool statistics = false;
    std::string output = "text"; ///< Format for stdout: text, json or csv.
};

/// The verb `job check`.
struct CheckCommand {
    std::string file; ///< A job file with [bodies].
    bool quiet = false;
    std::string output = "text"; ///< text, csv
};

struct DemoCommand {
    std::uint64_t scenarios = 1000;
    std::string vehicles = "generated"; ///< generated, debian
    std::string a;                      ///< Mesh of A instead of a vehicle. Empty: none.
    std::string b;
    std::string out;
    bool no_wait = false; ///< End after the job, also on a terminal.
    bool quiet = false;
};

struct SubmitCommand {
    JobOptions job;
    MasterOptions master;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
    bool quiet = false;
    std::string output = "text"; ///< text, json, name
};

struct WatchCommand {
    std::string job;
    MasterOptions master;
    bool quiet = false;
    bool only_wait = false; ///< The verb `wait`: prints notes, but no progress.
    bool statistics = false;
    FailOn fail_on;
    std::string output = "text"; ///< text, json
};

struct ResultsCommand {
    std::string job; ///< A job's id, or a results folder.
    MasterOptions master;
    std::string out;
    FolderFlags folder;
    std::vector<std::string> formats; ///< Empty if the option is missing.
    bool exact_points = false;
    std::string tree_cache = "off"; ///< A folder, or off.
    bool quiet = false;
    bool statistics = false;
    std::string output = "text"; ///< Format for stdout if `out` is empty: text, json or csv.
    /// Formats of a job's results if `formats` is empty; empty: the job's own.
    std::vector<std::string> usual_formats;
};

struct VerifyCommand {
    std::string run; ///< A results folder, or a job's id.
    MasterOptions master;
    std::uint64_t sample = 1000;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
    bool quiet = false;
};

struct ExtractCommand {
    std::string run; ///< A results folder, or a job's id.
    MasterOptions master;
    std::string scenarios; ///< N or N-M
    std::string out;
    std::string as = "case";
    bool minimal = false;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
};

/// The verb `report`.
struct ReportCommand {
    std::string run; ///< A results folder, or a job's id.
    MasterOptions master;
    std::string out = "report.html";
    std::string pictures;            ///< Folder for large pictures; empty: none.
    std::vector<std::string> bodies; ///< Names of the only bodies that it is about; empty: all.
    bool has_viewer = false;
    /// Size of a report with a viewer; a larger one is refused.
    std::uint64_t bytes_max = limits::report_with_viewer_bytes_max;
    JudgeOptions judge;
    FailOn fail_on;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
};

struct ViewCommand {
    std::string run; ///< A results folder, or a job's id; empty: the cluster.
    MasterOptions master;
    std::uint16_t port = 0; ///< 0: the system chooses.
    bool no_browser = false;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
};

/// The differences that give exit code 1: none; all; groups that only the later run has.
enum class DiffFailOn : std::uint8_t { Never, Any, New };

/// The verb `diff`.
struct DiffCommand {
    std::string earlier; ///< A results folder, or a job's id.
    std::string later;
    MasterOptions master;
    std::string out; ///< Folder for the CSV files; empty: none.
    DiffFailOn fail_on = DiffFailOn::Never;
    unsigned threads = 0;
    std::string tree_cache = "off"; ///< A folder, or off.
    std::string output = "text";    ///< text, json, csv
};

struct GetCommand {
    std::string what; ///< jobs, workers or meshes
    MasterOptions master;
    std::string output = "text"; ///< text, wide, json, csv, name
};

struct StatusCommand {
    MasterOptions master;
    std::string output = "text"; ///< text, json
};

/// The verb `priority`.
struct PriorityCommand {
    std::string job;
    std::int32_t priority = 0;
    MasterOptions master;
};

struct CancelCommand {
    std::string job;
    std::optional<std::uint64_t> scenario; ///< Without one, the whole job is cancelled.
    MasterOptions master;
};

/// The verb `rm`.
struct RemoveCommand {
    std::vector<std::string> what; ///< Ids of jobs, or hashes of meshes.
    bool yes = false;
    bool cancel = false; ///< Cancel a running job first.
    MasterOptions master;
};

struct DrainCommand {
    std::vector<std::string> workers;
    bool all = false;
    bool now = false;
    MasterOptions master;
};

struct ExplainCommand {
    std::string job;
    std::uint64_t scenario = 0;
    MasterOptions master;
    std::string output = "text"; ///< text, json
};

/// The verb `join`, which obtains a credential.
struct JoinCommand {
    MasterOptions master;
    std::string token;
    std::string token_file; ///< A file with the token in its first line.
    std::string name;       ///< Name in the certificate; empty: user and host.
};

/// The verb `token create`.
struct TokenCommand {
    MasterOptions master;
    std::string role = "worker";
    std::string ttl = "1h";
    std::uint32_t uses = 1;
};

struct InspectCommand {
    std::vector<std::string> meshes;
    std::string unit;
    std::string job_unit;
    std::string output = "text"; ///< text, json
    std::string png;             ///< File for a picture of a single mesh; empty: none.
};

struct VersionCommand {
    std::string output = "text"; ///< text, json
};

/// Where the value of a setting comes from.
enum class SettingOrigin : std::uint8_t { Default, File, Environment, Option };

struct ChosenSetting {
    std::string key;
    std::string value;
    SettingOrigin origin = SettingOrigin::Default;
    std::string place; ///< FILE:LINE, the variable or the option; empty for a default.
};

/// The verb `config`, which shows the user's settings.
struct ConfigCommand {
    std::map<std::string, std::string> given; ///< Values of options by key; empty: not given.
    std::vector<ChosenSetting> settings;
    std::string file; ///< Path of the configuration file; empty: none is read.
    bool file_exists = false;
    std::string output = "text"; ///< text, json
};

/// The verb `doctor`, which looks for what is wrong here and with a cluster.
struct DoctorCommand {
    MasterOptions master;
    std::string http;               ///< HOST:PORT, or "none"; empty: the master's host, port 7680.
    std::string tree_cache = "off"; ///< A folder, or off.
    std::string output = "text";    ///< text, json
};

struct CompletionCommand {
    std::string shell; ///< bash, zsh, fish
};

/// Prints words with which a command line can go on; a shell asks for them.
struct CompleteCommand {
    std::vector<std::string> words;
    bool has_files = false;               ///< The word may also be a file or folder.
    std::optional<std::string> job_begin; ///< Set: the word may also be a job that begins so.
    MasterOptions master;                 ///< That a verb on this line would use.
};

using Command = std::variant<RunCommand,
                             CheckCommand,
                             DemoCommand,
                             SubmitCommand,
                             WatchCommand,
                             ResultsCommand,
                             VerifyCommand,
                             ExtractCommand,
                             ViewCommand,
                             DiffCommand,
                             ReportCommand,
                             GetCommand,
                             StatusCommand,
                             PriorityCommand,
                             CancelCommand,
                             RemoveCommand,
                             DrainCommand,
                             ExplainCommand,
                             JoinCommand,
                             TokenCommand,
                             InspectCommand,
                             VersionCommand,
                             ConfigCommand,
                             DoctorCommand,
                             CompletionCommand,
                             CompleteCommand>;

/// What to do: run `command`. Without a command, print `text` (help on stdout, a usage error on
/// stderr) and exit with `exit_code`.
struct CommandLine {
    std::optional<Command> command;
    std::string text;
    int exit_code = 0;
};

/// Parses the arguments that follow the program's name.
[[nodiscard]] CommandLine parse_command_line(std::vector<std::string> arguments);

} // namespace cd
