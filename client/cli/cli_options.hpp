// Options shared by several verbs of cdctl. Each option writes its value to the given variable,
// which must outlive the parsing.
#pragma once

#include "client/cli/cli.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cd {

/// The default of --master.
inline constexpr const char* loopback_master = "127.0.0.1:7600";
/// The value of --master with which `run` uses no master, whatever the configuration file says.
inline constexpr const char* this_machine = "here";

/// Returns a function that adds an option to a verb; the help calls its value `type`.
[[nodiscard]] inline auto option_adder(CLI::App& verb) {
    return [&verb](const char* names, auto& value, const char* type, const std::string& help) {
        return verb.add_option(names, value, help)->type_name(type);
    };
}

/// Returns the check that a value is one of `words`.
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& words);
/// Returns the check that a value is the name of a unit of length.
[[nodiscard]] CLI::Validator is_unit();

void add_job_options(CLI::App& verb, JobOptions& job);
/// Adds the required argument that names a job on the master.
void add_job(CLI::App& verb, std::string& job);
/// Adds the required argument `name` that names a results folder or a job on the master.
void add_run(CLI::App& verb, const char* name, std::string& run, const char* type);
/// Adds `--master`, `--insecure` and `--credential`. `required_here` says that the verb needs a
/// master; then the address has a default. Otherwise the word `this_machine` gives an empty one.
void add_master_options(CLI::App& verb, MasterOptions& master, bool required_here = true);
/// Returns the check that a value is a priority.
[[nodiscard]] CLI::Validator is_priority();
/// Adds `--priority`, of a job on a master.
void add_priority(CLI::App& verb, MasterOptions& master);
/// Adds `--threads`.
CLI::Option* add_threads(CLI::App& verb, unsigned& threads, const char* help);
void add_tree_cache(CLI::App& verb, std::string& folder);
/// Adds `--output`; `words` are the available formats.
void add_output(CLI::App& verb, std::string& output, const std::vector<std::string>& words);
void add_quiet(CLI::App& verb, bool& quiet);
/// Adds `--fail-on`, with the word `new` for verbs that have a baseline.
void add_fail_on(CLI::App& verb, FailOn& fail_on, bool has_baseline);
/// Adds `--baseline` and `--statuses`.
void add_judge(CLI::App& verb, JudgeOptions& judge);
void add_diff_fail_on(CLI::App& verb, DiffFailOn& fail_on);
/// Adds `--formats` and `--exact-points`.
void add_formats(CLI::App& verb, std::vector<std::string>& formats, bool& exact_points);
/// Adds `--overwrite`, `--fresh` and `--no-inputs`.
void add_folder_options(CLI::App& verb, FolderFlags& flags);
void add_statistics(CLI::App& verb, bool& statistics);
/// Adds `--first-stage`, whose values are the names of the stages in the statistics.
void add_first_stage(CLI::App& verb, std::optional<PairStage>& first_stage);

} // namespace cd
