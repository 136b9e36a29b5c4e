// Options shared by several verbs of cdctl. Each option writes its value to the given variable,
// which must outlive the parsing.
#pragma once

#include "client/cli/cli.hpp"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Names of units of length that --unit accepts.
[[nodiscard]] std::vector<std::string> units();

void add_job_options(CLI::App& verb, JobOptions& job);
/// Adds `--master`, `--insecure` and `--credential`. If `required_here`, the verb needs a master,
/// so the address has a default.
void add_master_options(CLI::App& verb, MasterOptions& master, bool required_here);
void add_tree_cache(CLI::App& verb, std::string& folder);
/// Adds `--output`; `words` are the available formats.
void add_output(CLI::App& verb, std::string& output, const std::vector<std::string>& words);
void add_quiet(CLI::App& verb, bool& quiet);
void add_fail_on(CLI::App& verb, FailOn& fail_on);
/// Adds `--formats` and `--exact-points`.
void add_formats(CLI::App& verb, std::vector<std::string>& formats, bool& exact_points);
/// Adds `--overwrite`, `--fresh` and `--no-inputs`.
void add_folder_options(CLI::App& verb, FolderFlags& flags);
void add_statistics(CLI::App& verb, bool& statistics);
/// Adds `--first-stage`, with the stages' names as in the statistics.
void add_first_stage(CLI::App& verb, std::optional<PairStage>& first_stage);

} // namespace cd
