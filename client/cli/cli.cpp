#include "client/cli/cli.hpp"

#include "client/base/exit_code.hpp"
#include "client/cli/cli_help.hpp"
#include "client/cli/cli_mistakes.hpp"
#include "client/cli/cli_options.hpp"
#include "common/core/build_info.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/wire.hpp"
#include "common/geometry/simd_target.hpp"

#include <CLI/CLI.hpp>

#include <sstream>

namespace cd {

namespace {

/// Formats help with the examples first. A description's first line says what the verb does; the
/// rest are its examples.
class ExamplesFirst final : public CLI::Formatter {
  public:
    std::string make_description(const CLI::App* app) const override {
        const std::string text = app->get_description();
        const auto end = text.find('\n');
        if (end == std::string::npos) {
            return text + "\n\n";
        }
        return text.substr(end + 1) + "\n\n" + text.substr(0, end) + "\n\n";
    }

    std::string make_subcommand(const CLI::App* verb) const override {
        const std::string text = verb->get_description();
        std::ostringstream out;
        CLI::detail::format_help(
            out, verb->get_name(), text.substr(0, text.find('\n')), get_column_width());
        return out.str();
    }
};

/// Owns the variables to which the verbs' options are written.
struct Verbs {
    RunCommand run;
    DemoCommand demo;
    SubmitCommand submit;
    WatchCommand watch;
    WatchCommand wait;
    ResultsCommand results;
    VerifyCommand verify;
    ExtractCommand extract;
    GetCommand get;
    StatusCommand status;
    CancelCommand cancel;
    RemoveCommand remove;
    DrainCommand drain;
    ExplainCommand explain;
    JoinCommand join;
    TokenCommand token;
    InspectCommand inspect;
    VersionCommand version;
    std::optional<Command> chosen;
};

template <class T>
CLI::App* add_verb(CLI::App& app, Verbs& verbs, const char* name, const char* help, T& command) {
    CLI::App* verb = app.add_subcommand(name, help);
    verb->callback([&verbs, &command] { verbs.chosen = command; });
    return verb;
}

void add_local_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* run = add_verb(app, verbs, "run", run_help, verbs.run);
    add_job_options(*run, verbs.run.job);
    add_folder_options(*run, verbs.run.folder);
    add_statistics(*run, verbs.run.statistics);
    add_master_options(*run, verbs.run.master, false);
    run->add_option("--threads", verbs.run.host.threads, "Threads here; 0 is one for each core")
        ->check(CLI::Range(0u, 4096u))
        ->type_name("N")
        ->capture_default_str();
    run->add_option("--simd",
                    verbs.run.host.simd,
                    "Instructions used here: avx512, avx2, sse4, neon, "
                    "scalar, auto (default); same answers. Also CD_SIMD")
        ->type_name("TARGET");
    add_first_stage(*run, verbs.run.host.first_stage);
    add_tree_cache(*run, verbs.run.host.tree_cache);
    add_fail_on(*run, verbs.run.fail_on);
    run->add_flag(
        "--dry-run", verbs.run.dry_run, "Check all inputs, estimate time and size, then stop");
    run->add_flag(
        "--yes", verbs.run.yes, "Write results even if they exceed 1 GB or half of the free disk");
    add_quiet(*run, verbs.run.quiet);
    add_output(*run, verbs.run.output, {"text", "json", "csv"});

    CLI::App* demo = add_verb(app,
                              verbs,
                              "demo",
                              "Starts a local cluster, runs a job on a real vehicle, stops it.\n"
                              "Examples:\n"
                              "  cdctl demo\n"
                              "  cdctl demo --scenarios 5000 --out results\n"
                              "  cdctl demo --a car.obj --b tram.obj",
                              verbs.demo);
    demo->add_option("--scenarios", verbs.demo.scenarios, "How many")
        ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max))
        ->type_name("N")
        ->capture_default_str();
    CLI::Option* a = demo->add_option("--a", verbs.demo.a, "Mesh of body A")->type_name("MESH");
    CLI::Option* b = demo->add_option("--b", verbs.demo.b, "Mesh of body B")->type_name("MESH");
    a->needs(b);
    b->needs(a);
    demo->add_option("--out", verbs.demo.out, "Folder for the results")->type_name("DIR");
    add_quiet(*demo, verbs.demo.quiet);

    CLI::App* inspect = add_verb(app,
                                 verbs,
                                 "inspect",
                                 "Shows what a mesh file holds.\n"
                                 "Examples:\n"
                                 "  cdctl inspect car.obj\n"
                                 "  cdctl inspect post.stl --unit mm\n"
                                 "  cdctl inspect car.obj --png car.png",
                                 verbs.inspect);
    inspect->add_option("mesh", verbs.inspect.meshes, "Mesh files")->required()->type_name("MESH");
    inspect->add_option("--unit", verbs.inspect.unit, "Unit of the file; shown in --job-unit")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT");
    inspect->add_option("--job-unit", verbs.inspect.job_unit, "Unit of the job (m)")
        ->check(CLI::IsMember(units()))
        ->type_name("UNIT");
    inspect->add_option("--png", verbs.inspect.png, "Also draw the mesh, parts in colours")
        ->type_name("FILE");
    add_output(*inspect, verbs.inspect.output, {"text", "json"});
}

void add_job_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* submit = add_verb(app,
                                verbs,
                                "submit",
                                "Hands a job to the master and prints its id.\n"
                                "Examples:\n"
                                "  cdctl submit job.toml\n"
                                "  job=$(cdctl submit job.toml -o name) && cdctl watch \"$job\"",
                                verbs.submit);
    add_job_options(*submit, verbs.submit.job);
    add_master_options(*submit, verbs.submit.master, true);
    submit->add_option("--threads", verbs.submit.threads, "Threads that make poses here")
        ->check(CLI::Range(0u, 4096u))
        ->type_name("N");
    add_tree_cache(*submit, verbs.submit.tree_cache);
    add_quiet(*submit, verbs.submit.quiet);
    add_output(*submit, verbs.submit.output, {"text", "json", "name"});

    const auto add_watch = [&](const char* name, const char* help, WatchCommand& command) {
        CLI::App* watch = add_verb(app, verbs, name, help, command);
        watch->add_option("job", command.job, "A job's id, its beginning, or last: your newest job")
            ->required()
            ->type_name("JOB");
        add_master_options(*watch, command.master, true);
        add_fail_on(*watch, command.fail_on);
        add_quiet(*watch, command.quiet);
        add_statistics(*watch, command.statistics);
        add_output(*watch, command.output, {"text", "json"});
    };
    verbs.wait.only_wait = true;
    add_watch("watch", "Follows a job to its end.\nExamples:\n  cdctl watch j-5692", verbs.watch);
    add_watch("wait",
              "Waits for a job's end. Prints no progress, only why the job is "
              "waiting.\nExamples:\n  cdctl wait j-5692 --fail-on cross",
              verbs.wait);

    CLI::App* results = add_verb(app, verbs, "results", results_help, verbs.results);
    results
        ->add_option("job",
                     verbs.results.job,
                     "A results folder; or a job's id, its beginning, or last: your newest")
        ->required()
        ->type_name("JOB");
    add_master_options(*results, verbs.results.master, true);
    results->add_option("--out", verbs.results.out, "Folder for the results of a job")
        ->type_name("DIR");
    add_formats(*results, verbs.results.formats, verbs.results.exact_points);
    add_folder_options(*results, verbs.results.folder);
    add_tree_cache(*results, verbs.results.tree_cache);
    add_statistics(*results, verbs.results.statistics);
    add_quiet(*results, verbs.results.quiet);
    add_output(*results, verbs.results.output, {"text", "json", "csv"});

    CLI::App* cancel = add_verb(
        app,
        verbs,
        "cancel",
        "Ends a job early, or one of its scenarios, which fails then.\nExamples:\n  cdctl cancel "
        "j-5692\n"
        "  cdctl cancel j-5692 --scenario 17     it takes too long; the job goes on without it",
        verbs.cancel);
    cancel->add_option("--scenario", verbs.cancel.scenario, "Its number in the job, from 0")
        ->type_name("N");
    cancel
        ->add_option("job", verbs.cancel.job, "A job's id, its beginning, or last: your newest job")
        ->required()
        ->type_name("JOB");
    add_master_options(*cancel, verbs.cancel.master, true);

    CLI::App* explain = add_verb(
        app,
        verbs,
        "explain",
        "Shows who answered a scenario and, while its job runs, how each worker\nscores for it.\n"
        "Examples:\n"
        "  cdctl explain j-5692 17\n"
        "  cdctl explain j-5692 17 -o json",
        verbs.explain);
    explain
        ->add_option(
            "job", verbs.explain.job, "A job's id, its beginning, or last: your newest job")
        ->required()
        ->type_name("JOB");
    explain->add_option("scenario", verbs.explain.scenario, "Its number in the job, from 0")
        ->required()
        ->type_name("N");
    add_master_options(*explain, verbs.explain.master, true);
    add_output(*explain, verbs.explain.output, {"text", "json"});
}

void add_cluster_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* get = add_verb(app,
                             verbs,
                             "get",
                             "Lists jobs, workers or meshes.\n"
                             "Examples:\n"
                             "  cdctl get jobs\n"
                             "  cdctl get workers -o wide",
                             verbs.get);
    get->add_option("what", verbs.get.what, "jobs, workers or meshes")
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>{"jobs", "workers", "meshes"}))
        ->type_name("WHAT");
    add_master_options(*get, verbs.get.master, true);
    add_output(*get, verbs.get.output, {"text", "wide", "json", "csv", "name"});

    CLI::App* status = add_verb(app,
                                verbs,
                                "status",
                                "Shows the cluster; the last line names the bottleneck.\n"
                                "Examples:\n"
                                "  cdctl status",
                                verbs.status);
    add_master_options(*status, verbs.status.master, true);
    add_output(*status, verbs.status.output, {"text", "json"});
    CLI::App* version = add_verb(app,
                                 verbs,
                                 "version",
                                 "Prints version, commit, compiler, SIMD target and libraries.\n"
                                 "Examples:\n"
                                 "  cdctl version -o json",
                                 verbs.version);
    add_output(*version, verbs.version.output, {"text", "json"});
}

void add_upkeep_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* remove = add_verb(
        app,
        verbs,
        "rm",
        "Removes jobs, with results, poses and meshes that no other job uses, or single meshes.\n"
        "Examples:\n"
        "  cdctl rm j-5692 j-a01c --yes\n"
        "  cdctl rm j-5692 --cancel --yes      also while it runs\n"
        "  cdctl rm 3f9c27a1 --yes             a mesh, for admins",
        verbs.remove);
    remove
        ->add_option("what",
                     verbs.remove.what,
                     "A job's id, its beginning, or last; or a mesh, by the beginning of its hash")
        ->required()
        ->type_name("JOB|MESH...");
    remove->add_flag("--yes", verbs.remove.yes, "Confirm; without it nothing is removed");
    remove->add_flag("--cancel", verbs.remove.cancel, "Cancel a running job first");
    add_master_options(*remove, verbs.remove.master, true);

    CLI::App* drain =
        add_verb(app,
                 verbs,
                 "drain",
                 "Drains workers: each finishes its running scenarios, returns the "
                 "rest, and exits with code 0.\n"
                 "Examples:\n"
                 "  cdctl drain w-3\n"
                 "  cdctl drain --all\n"
                 "  cdctl drain w-3 --now               does not wait for running scenarios",
                 verbs.drain);
    CLI::Option* workers =
        drain->add_option("worker", verbs.drain.workers, "A worker's id, or its name")
            ->type_name("WORKER...");
    drain->add_flag("--all", verbs.drain.all, "All connected workers")->excludes(workers);
    drain->add_flag("--now", verbs.drain.now, "Exit at once, without finishing running scenarios");
    add_master_options(*drain, verbs.drain.master, true);
}

void add_identity_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* join = add_verb(app,
                              verbs,
                              "join",
                              "Gets a credential for a master with a token.\n"
                              "Examples:\n"
                              "  cdctl join node-1:7600 --token T\n"
                              "  cdctl join node-1:7600 --token-file token --credential me.pem",
                              verbs.join);
    join->add_option("master", verbs.join.master.address, "The master's HOST:PORT")
        ->required()
        ->type_name("ADDRESS");
    CLI::Option* token =
        join->add_option("--token", verbs.join.token, "What `cdctl token create` printed")
            ->type_name("TOKEN")
            ->envname("CDCTL_TOKEN");
    join->add_option("--token-file", verbs.join.token_file, "Its first line is the token")
        ->excludes(token)
        ->type_name("FILE");
    join->add_option("--name", verbs.join.name, "For people; by default user and host")
        ->type_name("TEXT");
    join->add_option("--credential", verbs.join.master.credential, "Where to keep it")
        ->type_name("FILE")
        ->envname("CDCTL_CREDENTIAL");

    CLI::App* tokens = app.add_subcommand("token",
                                          "Tokens with which others join.\n"
                                          "Examples:\n"
                                          "  cdctl token create --ttl 1h --uses 50\n"
                                          "  cdctl token create --role submitter");
    tokens->require_subcommand(1);
    CLI::App* create = add_verb(*tokens,
                                verbs,
                                "create",
                                "Prints a token. Needs the credential of an admin.\n"
                                "Examples:\n"
                                "  cdctl token create --ttl 1h --uses 50\n"
                                "  cdctl token create --role submitter --credential admin.pem",
                                verbs.token);
    create->add_option("--role", verbs.token.role, "What the joining may be")
        ->check(CLI::IsMember(std::vector<std::string>{"worker", "submitter", "admin", "metrics"}))
        ->type_name("worker|submitter|admin|metrics")
        ->capture_default_str();
    create->add_option("--ttl", verbs.token.ttl, "Lifetime of the token")
        ->type_name("DURATION")
        ->capture_default_str();
    create->add_option("--uses", verbs.token.uses, "How many may join with it")
        ->check(CLI::Range(1u, limits::token_uses_max))
        ->type_name("N")
        ->capture_default_str();
    add_master_options(*create, verbs.token.master, true);
}

void add_check_verbs(CLI::App& app, Verbs& verbs) {
    CLI::App* verify = add_verb(app,
                                verbs,
                                "verify",
                                "Runs a sample of a run's scenarios again here and compares.\n"
                                "Examples:\n"
                                "  cdctl verify out\n"
                                "  cdctl verify out --sample 100000 --seed 7\n"
                                "  cdctl verify j-5692\n"
                                "\n"
                                "Exit codes: 0 all records are the same; 1 one differs; 3 some "
                                "scenario could not be run.",
                                verbs.verify);
    verify
        ->add_option("run",
                     verbs.verify.run,
                     "A results folder; or a job's id, its beginning, or last: your newest")
        ->required()
        ->type_name("FOLDER|JOB");
    add_master_options(*verify, verbs.verify.master, true);
    verify->add_option("--sample", verbs.verify.sample, "Number of scenarios, chosen by the seed")
        ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max))
        ->type_name("N")
        ->capture_default_str();
    verify->add_option("--seed", verbs.verify.seed, "Selects the scenarios")
        ->type_name("N")
        ->capture_default_str();
    verify->add_option("--threads", verbs.verify.threads, "Threads here; 0 is one for each core")
        ->check(CLI::Range(0u, 4096u))
        ->type_name("N");
    add_tree_cache(*verify, verbs.verify.tree_cache);
    add_quiet(*verify, verbs.verify.quiet);

    CLI::App* extract =
        add_verb(app,
                 verbs,
                 "extract",
                 "Writes scenarios of a run as a job of their own, or as pictures.\n"
                 "Examples:\n"
                 "  cdctl extract out 41230 --out case && cdctl run case/job.toml\n"
                 "  cdctl extract out 100-199 --out case\n"
                 "  cdctl extract j-5692 41230 --out case\n"
                 "  cdctl extract out 41230 --out case --minimal\n"
                 "  cdctl extract out 41230 --as png\n"
                 "\n"
                 "A case has a.npz and b.npz (all triangles), poses.csv in the "
                 "form that was\n"
                 "tested, job.toml, and expected.json with the class and the "
                 "digest that `cdctl run`\n"
                 "must give. A picture shows the bodies, and in red the triangles "
                 "in contact that the\n"
                 "run listed (levels pairs and contacts).",
                 verbs.extract);
    extract
        ->add_option("run",
                     verbs.extract.run,
                     "A results folder; or a job's id, its beginning, or last: your newest")
        ->required()
        ->type_name("FOLDER|JOB");
    extract->add_option("scenarios", verbs.extract.scenarios, "N, or N-M (inclusive)")
        ->required()
        ->type_name("N[-M]");
    add_master_options(*extract, verbs.extract.master, true);
    extract->add_option("--out", verbs.extract.out, "Folder for the case or pictures (scenario-N)")
        ->type_name("DIR");
    extract->add_option("--as", verbs.extract.as, "What is written")
        ->check(CLI::IsMember(std::vector<std::string>{"case", "png"}))
        ->type_name("KIND")
        ->capture_default_str();
    extract->add_flag("--minimal",
                      verbs.extract.minimal,
                      "Only triangles whose boxes meet the other body's; ids.csv has their "
                      "numbers in the run");
    extract->add_option("--threads", verbs.extract.threads, "Threads here; 0 is one for each core")
        ->check(CLI::Range(0u, 4096u))
        ->type_name("N");
    add_tree_cache(*extract, verbs.extract.tree_cache);
}

/// Turns an error of CLI11, which has an exit code for each error, into cdctl's one code for wrong
/// usage. A request for help is not an error here.
CommandLine refused(const CLI::App& app,
                    const CLI::ParseError& error,
                    const std::vector<std::string>& arguments) {
    std::ostringstream out;
    std::ostringstream problem;
    const int code = app.exit(error, out, problem);
    if (code == 0) {
        return {std::nullopt, out.str(), exit_done};
    }
    if (const auto word = unknown_word(app, arguments)) {
        return {std::nullopt, "cdctl: " + *word + "\n", exit_usage};
    }
    return {std::nullopt, "cdctl: " + problem.str(), exit_usage};
}

} // namespace

CommandLine parse_command_line(std::vector<std::string> arguments) {
    if (arguments.empty()) {
        return {std::nullopt, first_steps(), exit_usage};
    }
    if (const auto answer = version_answer("cdctl", to_text(simd_target()), arguments)) {
        return {std::nullopt, *answer, exit_done};
    }
    Verbs verbs;
    CLI::App app(main_help, "cdctl");
    app.formatter(std::make_shared<ExamplesFirst>());
    app.get_formatter()->column_width(34);
    app.set_version_flag("--version",
                         version_text("cdctl", to_text(simd_target()), false),
                         "Version, commit, compiler, libraries; with -o json for programs");
    app.set_help_flag("-h,--help", "This text");
    app.require_subcommand(1);
    add_local_verbs(app, verbs);
    add_job_verbs(app, verbs);
    add_check_verbs(app, verbs);
    add_cluster_verbs(app, verbs);
    add_upkeep_verbs(app, verbs);
    add_identity_verbs(app, verbs);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        return refused(app, error, arguments);
    }
    return {std::move(verbs.chosen), "", exit_done};
}

} // namespace cd
