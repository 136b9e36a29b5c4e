// Options that several verbs of cdctl have. Each is written into the value that is given, which
// outlives the parsing.
#pragma once

#include "client/cli/cli.hpp"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Names of units of length, as --unit takes them.
[[nodiscard]] std::vector<std::string> units();

void add_job_options(CLI::App& verb, JobOptions& job);
/// `required_here`: the verb means nothing without a master, so it has a default.
void add_master_options(CLI::App& verb, MasterOptions& master, bool required_here);
void add_tree_cache(CLI::App& verb, std::string& folder);
/// `words`: the formats that there are.
void add_output(CLI::App& verb, std::string& output, const std::vector<std::string>& words);
void add_quiet(CLI::App& verb, bool& quiet);
void add_fail_on(CLI::App& verb, FailOn& fail_on);
/// `--formats` and `--exact-points`.
void add_formats(CLI::App& verb, std::vector<std::string>& formats, bool& exact_points);
/// `--overwrite`, `--fresh` and `--no-inputs`.
void add_folder_options(CLI::App& verb, FolderFlags& flags);
void add_statistics(CLI::App& verb, bool& statistics);
/// The stages by the names that the statistics give them.
void add_first_stage(CLI::App& verb, std::optional<PairStage>& first_stage);

} // namespace cd
