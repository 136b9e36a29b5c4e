#include "client/cli/cli_options.hpp"

#include "client/base/units.hpp"
#include "client/spec/query_spec.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace cd {

namespace {

constexpr const char* results_group = "Results";

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

std::string is_depth(const std::string& text) {
    const auto depth = parse_depth(text);
    return depth ? "" : depth.error().detail;
}

void add_inputs(CLI::App& verb, JobOptions& job) {
    const auto add = option_adder(verb);
    verb.option_defaults()->group("Without a job file");
    PoseOptions& poses = job.poses;
    add("--a", job.a, "MESH", "Mesh of body A");
    add("--b", job.b, "MESH", "Mesh of body B");
    add("--unit", job.unit, "UNIT", "Unit of the job: poses, results (m)")->check(is_unit());
    add("--unit-a", job.unit_a, "UNIT", "Unit of A's file, where it differs")->check(is_unit());
    add("--unit-b", job.unit_b, "UNIT", "Unit of B's file, where it differs")->check(is_unit());
    add("--precision",
        job.precision,
        "PRECISION",
        "For both meshes: auto (double if float loses digits) or float (rounded)")
        ->check(one_of({"auto", "float"}))
        ->group("Options");
    add("--poses", poses.file, "FILE", "Poses of B in A's frame: .npy, .csv, TUM; - is stdin");
    add("--poses-unit", poses.unit, "UNIT", "Unit of the poses' lengths, if not the job's")
        ->check(is_unit());
    add("--quat-order", poses.quat_order, "ORDER", "Only for a bare (N,7): xyzw or wxyz")
        ->check(one_of({"xyzw", "wxyz"}));
    verb.add_flag("--both", poses.of_both, "The file has poses of both bodies");
    add("--rigid-tolerance", poses.rigid_tolerance, "X", "How far a matrix may be from rigid")
        ->check(CLI::NonNegativeNumber);
    add("--random", poses.random, "N", "N scenarios from random directions, pushed in")
        ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max));
    add("--seed", poses.seed, "N", "Seed of --random (1)");
    add("--penetration", poses.penetration, "X", "Least and most, of B's box diagonal (0.005 0.05)")
        ->expected(2);
}

void add_query(CLI::App& verb, JobOptions& job) {
    const auto add = option_adder(verb);
    verb.option_defaults()->group("What is asked");
    QueryOptions& query = job.query;
    add("--name", job.name, "NAME", "The job's name");
    add("--level", query.level, "LEVEL", "any, count, pairs (default), contacts or distance")
        ->check(one_of(words_of(asked_levels)));
    add("--clearance",
        query.clearance,
        "X",
        "Also find what is at most this far apart, in the job's unit");
    add("--up-to", query.up_to, "X", "With level distance: tell no distance above this");
    add("--limit-pairs", query.limit_pairs, "N", "Keep so many pairs a scenario; 0 keeps all");
    verb.add_flag(
        "--maps", query.maps, "Count the contacts of each triangle; needs level count or above");
}

void add_matching(CLI::App& verb, MatchingOptions& cluster) {
    const auto add = option_adder(verb);
    verb.option_defaults()->group("On the cluster");
    add("--strategy", cluster.strategy, "NAME", strategy_help())
        ->check(one_of(words_of(strategy_names())));
    add("--analysis",
        cluster.analysis,
        "WHEN",
        "By the master for each scenario, or by workers (auto)")
        ->check(one_of(words_of(analysis_mode_names())));
    add("--depth-a", cluster.depth_a, "D", "Distribution depth of A: a number, or auto (auto)")
        ->check(is_depth);
    add("--depth-b", cluster.depth_b, "D", "Distribution depth of B: a number, or auto (auto)")
        ->check(is_depth);
    add("--q", cluster.q, "N", "Not by time: a buffer is full at so many scenarios (20)")
        ->check(CLI::Range(1u, limits::q_max));
    add("--v-kb", cluster.v_kb, "N", "or at so many kB (4096)")
        ->check(CLI::Range(1u, limits::v_kb_max));
    verb.add_flag(
        "--claim", cluster.claim, "Not by time: one task at a worker at a time, as in the paper");
}

} // namespace

CLI::Validator one_of(const std::vector<std::string>& words) {
    return CLI::IsMember(words);
}

CLI::Validator is_unit() {
    return one_of(words_of(unit_names()));
}

void add_job_options(CLI::App& verb, JobOptions& job) {
    const auto add = option_adder(verb);
    add("job", job.file, "FILE", "A job file (job.toml), or a results folder");
    add_inputs(verb, job);
    add_query(verb, job);
    verb.option_defaults()->group(results_group);
    add("--out", job.output.dir, "DIR", "Folder for the results");
    add_formats(verb, job.output.formats, job.output.exact_points);
    add_matching(verb, job.cluster);
    verb.option_defaults()->group("Options");
}

void add_job(CLI::App& verb, std::string& job) {
    const auto add = option_adder(verb);
    add("job", job, "JOB", "A job's id, its beginning, or last: your newest job")->required();
}

void add_run(CLI::App& verb, const char* name, std::string& run, const char* type) {
    const auto add = option_adder(verb);
    add(name, run, type, "A results folder; or a job's id, its beginning, or last: your newest")
        ->required();
}

void add_master_options(CLI::App& verb, MasterOptions& master, bool required_here) {
    const auto add = option_adder(verb);
    master.address = required_here ? loopback_master : "";
    auto* address = add("--master",
                        master.address,
                        "ADDRESS",
                        required_here ? "The master's HOST:PORT"
                                      : "The master's HOST:PORT; here: this machine alone");
    if (required_here) {
        address->envname("CDCTL_MASTER")->capture_default_str();
    } else {
        address->transform(
            [](const std::string& text) { return text == this_machine ? std::string() : text; });
    }
    verb.add_flag("--insecure", master.insecure, "Allow a master beyond loopback, unencrypted");
    add("--credential", master.credential, "FILE|none", "What is shown to it; else what `join` got")
        ->envname("CDCTL_CREDENTIAL");
}

CLI::Validator is_priority() {
    return CLI::Range(-limits::priority_max, limits::priority_max);
}

void add_priority(CLI::App& verb, MasterOptions& master) {
    const auto add = option_adder(verb);
    add("--priority",
        master.priority,
        "N",
        "On a master: -10 to 10 (0), higher first; above 0 needs the role admin")
        ->check(is_priority());
}

CLI::Option* add_threads(CLI::App& verb, unsigned& threads, const char* help) {
    const auto add = option_adder(verb);
    return add("--threads", threads, "N", help)->check(CLI::Range(0u, 4096u));
}

void add_tree_cache(CLI::App& verb, std::string& folder) {
    const auto add = option_adder(verb);
    folder = default_tree_cache();
    add("--tree-cache",
        folder,
        "DIR|off",
        fmt::format("Folder that keeps built trees and fetched meshes for later runs, at "
                    "most {} GiB of each; off keeps none",
                    limits::tree_cache_bytes_max >> 30))
        ->envname("CDCTL_TREE_CACHE")
        ->capture_default_str();
}

void add_formats(CLI::App& verb, std::vector<std::string>& formats, bool& exact_points) {
    const auto add = option_adder(verb);
    add("--formats",
        formats,
        "LIST",
        "csv, csv-pairs, npz, h5, json, text, vtp, glb (default csv,npz); csv has one row per "
        "scenario, and one per pair of parts, csv-pairs one per pair; vtp (ParaView) and glb "
        "(Blender) have heat maps")
        ->delimiter(',')
        ->group(results_group);
    verb.add_flag("--exact-points",
                  exact_points,
                  "In npz and h5 also points at full precision, relative to point_origins")
        ->group(results_group);
}

void add_folder_options(CLI::App& verb, FolderFlags& flags) {
    verb.option_defaults()->group(results_group);
    verb.add_flag("--overwrite", flags.overwrite, "Replace another run in the folder");
    verb.add_flag("--fresh", flags.fresh, "Run everything again, also what the folder already has");
    verb.add_flag("--no-inputs",
                  flags.no_inputs,
                  "Keep no copies of meshes and poses; reopening needs their files");
    verb.option_defaults()->group("Options");
}

void add_statistics(CLI::App& verb, bool& statistics) {
    verb.add_flag(
            "--stats", statistics, "Print search cost and network traffic (always in summary.json)")
        ->group(results_group);
}

void add_output(CLI::App& verb, std::string& output, const std::vector<std::string>& words) {
    const auto add = option_adder(verb);
    add("-o,--output", output, "FORMAT", "What stdout carries")
        ->check(one_of(words))
        ->capture_default_str();
}

void add_quiet(CLI::App& verb, bool& quiet) {
    verb.add_flag("-q,--quiet", quiet, "No progress and no header");
}

void add_fail_on(CLI::App& verb, FailOn& fail_on, bool has_baseline) {
    const auto set = [&fail_on](const std::vector<std::string>& words) {
        for (const std::string& word : words) {
            bool& flag = word == "near"        ? fail_on.near
                         : word == "touch"     ? fail_on.touch
                         : word == "cross"     ? fail_on.cross
                         : word == "undecided" ? fail_on.undecided
                                               : fail_on.news;
            flag = true;
        }
    };
    std::vector<std::string> words{"near", "touch", "cross", "undecided"};
    std::string help = "Exit with 1 on near (or worse; needs a clearance), touch (or worse), cross "
                       "(or inside), undecided; commas join several";
    if (has_baseline) {
        words.emplace_back("new");
        help += "; new: a group that --baseline lacks and nobody approved";
    }
    verb.add_option_function<std::vector<std::string>>("--fail-on", set, help)
        ->type_name("LIST")
        ->delimiter(',')
        ->check(one_of(words));
}

void add_diff_fail_on(CLI::App& verb, DiffFailOn& fail_on) {
    const auto set = [&fail_on](const std::string& word) {
        fail_on = word == "new" ? DiffFailOn::New : DiffFailOn::Any;
    };
    verb.add_option_function<std::string>(
            "--fail-on", set, "Exit with 1 on any difference in contacts, or only on new groups")
        ->type_name("WHAT")
        ->check(one_of({"any", "new"}));
}

void add_judge(CLI::App& verb, JudgeOptions& judge) {
    const auto add = option_adder(verb);
    add("--baseline", judge.baseline, "FOLDER|JOB", "Compare the groups with this earlier run");
    add("--statuses", judge.statuses, "FILE", "What people reviewed or approved (docs/report.md)");
}

void add_first_stage(CLI::App& verb, std::optional<PairStage>& first_stage) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        words.emplace_back(to_text(static_cast<PairStage>(i)));
        std::replace(words.back().begin(), words.back().end(), ' ', '-');
    }
    const auto set = [&first_stage, words](const std::string& word) {
        first_stage = static_cast<PairStage>(std::ranges::find(words, word) - words.begin());
    };
    verb.add_option_function<std::string>(
            "--first-stage",
            set,
            "Skip the cheaper stages of the triangle decision; same answers, more slowly")
        ->type_name("STAGE")
        ->check(one_of(words));
}

} // namespace cd
