#include "client/cli/cli_options.hpp"

#include "client/base/units.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

namespace cd {

namespace {

constexpr const char* results_group = "Results";
constexpr const char* loopback_master = "127.0.0.1:7600";

const std::vector<std::string> levels{"any", "count", "pairs", "contacts"};
std::vector<std::string> words_of(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}
std::string strategy_help() {
    std::string text =
        "The worker of a scenario (" + ClusterOptions().strategy + ") is the one that";
    for (const Strategy& strategy : strategies) {
        text += fmt::format("\n  {}: {}", strategy.name, strategy.worker);
    }
    return text;
}
const std::map<std::string, FailOn> fail_on_words{{"touch", FailOn::Touch},
                                                  {"cross", FailOn::Cross}};

std::string is_depth(const std::string& text) {
    const auto depth = parse_depth(text);
    return depth ? "" : depth.error().detail;
}

} // namespace

std::vector<std::string> units() {
    const auto names = unit_names();
    return {names.begin(), names.end()};
}

void add_job_options(CLI::App& verb, JobOptions& job) {
    verb.add_option("job", job.file, "A job file (job.toml)")->type_name("JOB");
    const std::string inputs = "Without a job file";
    verb.add_option("--a", job.a, "Mesh of body A")->type_name("MESH")->group(inputs);
    verb.add_option("--b", job.b, "Mesh of body B")->type_name("MESH")->group(inputs);
    verb.add_option("--unit", job.unit, "Unit of the job: poses, results (m)")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT")
        ->group(inputs);
    verb.add_option("--unit-a", job.unit_a, "Unit of A's file, where it differs")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT")
        ->group(inputs);
    verb.add_option("--unit-b", job.unit_b, "Unit of B's file, where it differs")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT")
        ->group(inputs);
    verb.add_option("--precision",
                    job.precision,
                    "For both meshes: auto (double if float loses digits) or float (rounded)")
        ->check(CLI::IsMember(std::vector<std::string>{"auto", "float"}))
        ->type_name("PRECISION");
    verb.add_option(
            "--poses", job.poses.file, "Poses of B in A's frame: .npy, .csv, TUM; - is stdin")
        ->type_name("FILE")
        ->group(inputs);
    verb.add_option("--poses-unit", job.poses.unit, "Unit of the poses' lengths, if not the job's")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT")
        ->group(inputs);
    verb.add_option("--quat-order", job.poses.quat_order, "Only for a bare (N,7): xyzw or wxyz")
        ->check(CLI::IsMember(std::vector<std::string>{"xyzw", "wxyz"}))
        ->type_name("ORDER")
        ->group(inputs);
    verb.add_flag("--both", job.poses.of_both, "The file has poses of both bodies")->group(inputs);
    verb.add_option(
            "--rigid-tolerance", job.poses.rigid_tolerance, "How far a matrix may be from rigid")
        ->check(CLI::NonNegativeNumber)
        ->type_name("X")
        ->group(inputs);
    verb.add_option("--random", job.poses.random, "N scenarios from random directions, pushed in")
        ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max))
        ->type_name("N")
        ->group(inputs);
    verb.add_option("--seed", job.poses.seed, "Seed of --random (1)")
        ->type_name("N")
        ->group(inputs);
    verb.add_option("--penetration",
                    job.poses.penetration,
                    "Least and most, of B's box diagonal (0.005 0.05)")
        ->expected(2)
        ->type_name("X")
        ->group(inputs);

    const std::string query = "What is asked";
    verb.add_option("--name", job.name, "The job's name")->type_name("NAME")->group(query);
    verb.add_option("--level", job.query.level, "any, count, pairs (default) or contacts")
        ->check(CLI::IsMember(levels))
        ->type_name("LEVEL")
        ->group(query);
    verb.add_option("--tolerance",
                    job.query.tolerance,
                    "Find near misses: boxes this small stay undecided; 0 is exact and faster")
        ->check(CLI::NonNegativeNumber)
        ->type_name("LENGTH")
        ->group(query);
    verb.add_option(
            "--limit-pairs", job.query.limit_pairs, "Keep so many pairs a scenario; 0 keeps all")
        ->type_name("N")
        ->group(query);
    verb.add_flag("--maps",
                  job.query.maps,
                  "Count the contacts of each triangle; needs level count or above")
        ->group(query);
    verb.add_option("--out", job.output.dir, "Folder for the results")
        ->type_name("DIR")
        ->group(results_group);
    add_formats(verb, job.output.formats, job.output.exact_points);

    const std::string cluster = "On the cluster";
    verb.add_option("--strategy", job.cluster.strategy, strategy_help())
        ->check(CLI::IsMember(words_of(strategy_names())))
        ->type_name("NAME")
        ->group(cluster);
    verb.add_option("--analysis",
                    job.cluster.analysis,
                    "By the master for each scenario, or by workers (auto)")
        ->check(CLI::IsMember(words_of(analysis_mode_names())))
        ->type_name("WHEN")
        ->group(cluster);
    verb.add_option(
            "--depth-a", job.cluster.depth_a, "Distribution depth of A: a number, or auto (auto)")
        ->check(is_depth)
        ->type_name("D")
        ->group(cluster);
    verb.add_option(
            "--depth-b", job.cluster.depth_b, "Distribution depth of B: a number, or auto (auto)")
        ->check(is_depth)
        ->type_name("D")
        ->group(cluster);
    verb.add_option("--q", job.cluster.q, "Not by time: a buffer is full at so many scenarios (20)")
        ->check(CLI::Range(1u, limits::q_max))
        ->type_name("N")
        ->group(cluster);
    verb.add_option("--v-kb", job.cluster.v_kb, "or at so many kB (4096)")
        ->check(CLI::Range(1u, limits::v_kb_max))
        ->type_name("N")
        ->group(cluster);
    verb.add_flag("--claim",
                  job.cluster.claim,
                  "Not by time: one task at a worker at a time, as in the paper")
        ->group(cluster);
}

void add_master_options(CLI::App& verb, MasterOptions& master, bool required_here) {
    auto* address = verb.add_option("--master", master.address, "The master's HOST:PORT");
    address->type_name("ADDRESS");
    if (required_here) {
        master.address = loopback_master;
        address->envname("CDCTL_MASTER")->capture_default_str();
    }
    verb.add_flag("--insecure", master.insecure, "Allow a master beyond loopback, unencrypted");
    verb.add_option("--credential", master.credential, "What is shown to it; else what `join` got")
        ->type_name("FILE|none")
        ->envname("CDCTL_CREDENTIAL");
}

void add_tree_cache(CLI::App& verb, std::string& folder) {
    folder = default_tree_cache();
    verb.add_option("--tree-cache",
                    folder,
                    "Folder that keeps built trees and fetched meshes for later runs, at most " +
                        std::to_string(limits::tree_cache_bytes_max >> 30) +
                        " GiB of each; off keeps none")
        ->type_name("DIR|off")
        ->envname("CDCTL_TREE_CACHE")
        ->capture_default_str();
}

void add_formats(CLI::App& verb, std::vector<std::string>& formats, bool& exact_points) {
    verb.add_option("--formats",
                    formats,
                    "csv, csv-pairs, npz, json, text (default csv,npz); csv has one row per "
                    "scenario, csv-pairs one per pair")
        ->delimiter(',')
        ->type_name("LIST")
        ->group(results_group);
    verb.add_flag("--exact-points",
                  exact_points,
                  "In npz also points at full precision, relative to point_origins")
        ->group(results_group);
}

void add_folder_options(CLI::App& verb, FolderFlags& flags) {
    verb.add_flag("--overwrite", flags.overwrite, "Replace another run in the folder")
        ->group(results_group);
    verb.add_flag("--fresh", flags.fresh, "Run everything again, also what the folder already has")
        ->group(results_group);
    verb.add_flag("--no-inputs",
                  flags.no_inputs,
                  "Keep no copies of meshes and poses; reopening needs their files")
        ->group(results_group);
}

void add_statistics(CLI::App& verb, bool& statistics) {
    verb.add_flag(
            "--stats", statistics, "Print search cost and network traffic (always in summary.json)")
        ->group(results_group);
}

void add_output(CLI::App& verb, std::string& output, const std::vector<std::string>& words) {
    verb.add_option("-o,--output", output, "What stdout carries")
        ->check(CLI::IsMember(words))
        ->type_name("FORMAT")
        ->capture_default_str();
}

void add_quiet(CLI::App& verb, bool& quiet) {
    verb.add_flag("-q,--quiet", quiet, "No progress and no header");
}

void add_fail_on(CLI::App& verb, FailOn& fail_on) {
    verb.add_option(
            "--fail-on", fail_on, "Exit with 1 on touch (or worse), or on cross or inside only")
        ->transform(CLI::CheckedTransformer(fail_on_words).description(""))
        ->type_name("touch|cross");
}

void add_first_stage(CLI::App& verb, std::optional<PairStage>& first_stage) {
    std::map<std::string, PairStage> words;
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        std::string word(to_text(static_cast<PairStage>(i)));
        std::replace(word.begin(), word.end(), ' ', '-');
        words.emplace(std::move(word), static_cast<PairStage>(i));
    }
    verb.add_option("--first-stage",
                    first_stage,
                    "Skip the cheaper stages of the triangle decision: float (default), double, "
                    "lattice, double-double, wide-integer, arbitrary; same answers, more slowly")
        ->transform(CLI::CheckedTransformer(words).description(""))
        ->type_name("STAGE");
}

} // namespace cd
