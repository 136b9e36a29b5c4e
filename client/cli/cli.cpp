#include "client/cli/cli.hpp"

#include "client/base/exit_code.hpp"
#include "client/cli/cli_help.hpp"
#include "client/cli/cli_mistakes.hpp"
#include "client/cli/cli_options.hpp"
#include "client/cli/completion.hpp"
#include "client/cli/help_formatter.hpp"
#include "client/cli/settings.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/build_info.hpp"
#include "common/core/host/man_page.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/geometry/simd_target.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <span>
#include <sstream>
#include <utility>

namespace cd {

namespace {

/// Parses verbs into commands.
class Verbs {
  public:
    explicit Verbs(CLI::App& app) : app_(app) {}

    void add_local_verbs() {
        auto run = add<RunCommand>("run", run_help);
        add_job_options(*run, run->job);
        add_folder_options(*run, run->folder);
        add_statistics(*run, run->statistics);
        add_master_options(*run, run->master, false);
        add_priority(*run, run->master);
        add_threads(*run, run->host.threads, "Threads here; 0 is one for each core")
            ->capture_default_str();
        run.add("--simd",
                run->host.simd,
                "TARGET",
                "Instructions used here: avx512, avx2, sse4, neon, scalar, auto (default); same "
                "answers. Also CD_SIMD");
        add_first_stage(*run, run->host.first_stage);
        add_tree_cache(*run, run->host.tree_cache);
        add_judge(*run, run->judge);
        add_fail_on(*run, run->fail_on, true);
        run.add("--reuse",
                run->reuse,
                "FOLDER|JOB",
                "Run only the scenarios that this earlier run lacks, and take its other results")
            ->group("Results");
        run.flag("--dry-run", run->dry_run, "Check all inputs, estimate time and size, then stop");
        run.flag("--yes",
                 run->room.yes,
                 "Write results even if they exceed 1 GB or half of the free disk");
        add_quiet(*run, run->quiet);
        add_output(*run, run->output, {"text", "json", "csv"});

        CLI::App* jobs = app_.add_subcommand("job", job_help);
        jobs->require_subcommand(1);
        auto check = add<CheckCommand>("check", check_help, jobs);
        check.add("file", check->file, "FILE", "A job file with [bodies]")->required();
        add_quiet(*check, check->quiet);
        add_output(*check, check->output, {"text", "csv"});

        auto demo = add<DemoCommand>("demo", demo_help);
        demo.add("--scenarios", demo->scenarios, "N", "How many")
            ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max))
            ->capture_default_str();
        CLI::Option* a = demo.add("--a", demo->a, "MESH", "Mesh of body A");
        CLI::Option* b = demo.add("--b", demo->b, "MESH", "Mesh of body B");
        a->needs(b);
        b->needs(a);
        demo.add("--vehicles",
                 demo->vehicles,
                 "SET",
                 "generated: a truck and a car; debian: a motorcycle and a tram, from packages")
            ->check(CLI::IsMember({"generated", "debian"}))
            ->excludes(a)
            ->capture_default_str();
        demo.add("--out", demo->out, "DIR", "Folder for the results");
        demo.flag("--no-wait", demo->no_wait, "End after the job; show no page");
        add_quiet(*demo, demo->quiet);

        auto inspect = add<InspectCommand>("inspect", inspect_help);
        inspect.add("mesh", inspect->meshes, "MESH", "Mesh files")->required();
        inspect.add("--unit", inspect->unit, "UNIT", "Unit of the file; shown in --job-unit")
            ->check(is_unit());
        inspect.add("--job-unit", inspect->job_unit, "UNIT", "Unit of the job (m)")
            ->check(is_unit());
        inspect.add("--png", inspect->png, "FILE", "Also draw the mesh, parts in colours");
        add_output(*inspect, inspect->output, {"text", "json"});
    }

    void add_job_verbs() {
        auto submit = add<SubmitCommand>("submit", submit_help);
        add_job_options(*submit, submit->job);
        add_master_options(*submit, submit->master);
        add_threads(*submit, submit->threads, "Threads that make poses here");
        add_tree_cache(*submit, submit->tree_cache);
        add_priority(*submit, submit->master);
        add_quiet(*submit, submit->quiet);
        add_output(*submit, submit->output, {"text", "json", "name"});

        add_watch("watch", watch_help, false);
        add_watch("wait", wait_help, true);

        auto results = add<ResultsCommand>("results", results_help);
        add_run(*results, "job", results->job, "JOB");
        add_master_options(*results, results->master);
        results.add("--out", results->out, "DIR", "Folder for the results of a job");
        add_formats(*results, results->formats, results->exact_points);
        add_folder_options(*results, results->folder);
        add_tree_cache(*results, results->tree_cache);
        add_statistics(*results, results->statistics);
        add_quiet(*results, results->quiet);
        add_output(*results, results->output, {"text", "json", "csv"});

        auto priority = add<PriorityCommand>("priority", priority_help);
        add_job(*priority, priority->job);
        priority
            .add("priority",
                 priority->priority,
                 "N",
                 "-10 to 10, higher first; above 0 needs the role admin")
            ->required()
            ->check(is_priority());
        add_master_options(*priority, priority->master);

        auto cancel = add<CancelCommand>("cancel", cancel_help);
        cancel.add("--scenario", cancel->scenario, "N", "Its number in the job, from 0");
        add_job(*cancel, cancel->job);
        add_master_options(*cancel, cancel->master);

        auto explain = add<ExplainCommand>("explain", explain_help);
        add_job(*explain, explain->job);
        explain.add("scenario", explain->scenario, "N", "Its number in the job, from 0")
            ->required();
        add_master_options(*explain, explain->master);
        add_output(*explain, explain->output, {"text", "json"});
    }

    void add_check_verbs() {
        auto verify = add<VerifyCommand>("verify", verify_help);
        add_run(*verify, "run", verify->run, "FOLDER|JOB");
        add_master_options(*verify, verify->master);
        verify.add("--sample", verify->sample, "N", "Number of scenarios, chosen by the seed")
            ->check(CLI::Range(std::uint64_t{1}, limits::scenarios_max))
            ->capture_default_str();
        verify.add("--seed", verify->seed, "N", "Selects the scenarios")->capture_default_str();
        add_threads(*verify, verify->threads, "Threads here; 0 is one for each core");
        add_tree_cache(*verify, verify->tree_cache);
        add_quiet(*verify, verify->quiet);

        auto extract = add<ExtractCommand>("extract", extract_help);
        add_run(*extract, "run", extract->run, "FOLDER|JOB");
        extract.add("scenarios", extract->scenarios, "N[-M]", "N, or N-M (inclusive)")->required();
        add_master_options(*extract, extract->master);
        extract.add("--out", extract->out, "DIR", "Folder for what is written (scenario-N)");
        extract.add("--as", extract->as, "KIND", "What is written")
            ->check(one_of({"case", "png", "vtp", "glb"}))
            ->capture_default_str();
        extract.flag("--minimal",
                     extract->minimal,
                     "Only triangles whose boxes meet the other body's; ids.csv has their "
                     "numbers in the run");
        add_threads(*extract, extract->threads, "Threads here; 0 is one for each core");
        add_tree_cache(*extract, extract->tree_cache);

        auto report = add<ReportCommand>("report", report_help);
        add_run(*report, "run", report->run, "FOLDER|JOB");
        add_master_options(*report, report->master);
        report.add("-o,--output", report->out, "FILE", "The report; groups.csv is put beside it")
            ->capture_default_str();
        report.add("--pictures", report->pictures, "DIR", "Folder for large pictures: PNG files");
        report
            .add("--body",
                 report->bodies,
                 "NAME",
                 "Only scenarios of this body; repeat it for more bodies")
            ->allow_extra_args(false);
        report.flag("--3d",
                    report->has_viewer,
                    "Add the viewer of the worst 20 scenarios; refused above 25 MB");
        add_judge(*report, report->judge);
        add_fail_on(*report, report->fail_on, true);
        add_threads(*report, report->threads, "Threads here; 0 is one for each core");
        add_tree_cache(*report, report->tree_cache);

        auto diff = add<DiffCommand>("diff", diff_help);
        add_run(*diff, "old", diff->earlier, "OLD");
        add_run(*diff, "new", diff->later, "NEW");
        add_master_options(*diff, diff->master);
        diff.add("--out", diff->out, "DIR", "Folder for the CSV files; by default none is written");
        add_diff_fail_on(*diff, diff->fail_on);
        add_threads(*diff, diff->threads, "Threads here; 0 is one for each core");
        add_tree_cache(*diff, diff->tree_cache);
        add_output(*diff, diff->output, {"text", "json", "csv"});
    }

    void add_view_verb() {
        auto view = add<ViewCommand>("view", view_help);
        view.add("run",
                 view->run,
                 "FOLDER|JOB",
                 "A results folder; or a job's id, its beginning, or last; without it the cluster");
        add_master_options(*view, view->master);
        view.add("--port", view->port, "N", "Port on 127.0.0.1; 0: any free one")
            ->capture_default_str();
        view.flag("--no-browser", view->no_browser, "Only print the address");
        add_threads(*view, view->threads, "Threads that read the run; 0 is one for each core");
        add_tree_cache(*view, view->tree_cache);
    }

    void add_cluster_verbs() {
        auto get = add<GetCommand>("get", get_help);
        get.add("what", get->what, "WHAT", "jobs, workers or meshes")
            ->required()
            ->check(one_of({"jobs", "workers", "meshes"}));
        add_master_options(*get, get->master);
        add_output(*get, get->output, {"text", "wide", "json", "csv", "name"});

        auto status = add<StatusCommand>("status", status_help);
        add_master_options(*status, status->master);
        add_output(*status, status->output, {"text", "json"});

        auto version = add<VersionCommand>("version", version_help);
        add_output(*version, version->output, {"text", "json"});

        auto config = add<ConfigCommand>("config", config_help);
        config.add("--master", config->given["master"], "ADDRESS", "As in other verbs");
        config.add("--credential", config->given["credential"], "FILE|none", "As in other verbs");
        config.add("--formats", config->given["formats"], "LIST", "As in other verbs");
        config.add("--level", config->given["level"], "LEVEL", "As in other verbs")
            ->check(one_of({asked_levels.begin(), asked_levels.end()}));
        config.add("--tree-cache", config->given["tree-cache"], "DIR|off", "As in other verbs");
        add_output(*config, config->output, {"text", "json"});

        auto doctor = add<DoctorCommand>("doctor", doctor_help);
        add_master_options(*doctor, doctor->master);
        doctor.add("--http",
                   doctor->http,
                   "ADDRESS|none",
                   "The master's --http HOST:PORT (port 7680 on its host)");
        add_tree_cache(*doctor, doctor->tree_cache);
        add_output(*doctor, doctor->output, {"text", "json"});

        auto completion = add<CompletionCommand>("completion", completion_help);
        completion.add("shell", completion->shell, "SHELL", "The shell")
            ->required()
            ->check(one_of({"bash", "zsh", "fish"}));

        auto remove = add<RemoveCommand>("rm", remove_help);
        remove
            .add("what",
                 remove->what,
                 "JOB|MESH...",
                 "A job's id, its beginning, or last; or a mesh, by the beginning of its hash")
            ->required();
        remove.flag("--yes", remove->yes, "Confirm; without it nothing is removed");
        remove.flag("--cancel", remove->cancel, "Cancel a running job first");
        add_master_options(*remove, remove->master);

        auto drain = add<DrainCommand>("drain", drain_help);
        CLI::Option* workers =
            drain.add("worker", drain->workers, "WORKER...", "A worker's id, or its name");
        drain.flag("--all", drain->all, "All connected workers")->excludes(workers);
        drain.flag("--now", drain->now, "Exit at once, without finishing running scenarios");
        add_master_options(*drain, drain->master);
    }

    void add_identity_verbs() {
        auto join = add<JoinCommand>("join", join_help);
        join.add("master", join->master.address, "ADDRESS", "The master's HOST:PORT")->required();
        CLI::Option* token =
            join.add("--token", join->token, "TOKEN", "What `cdctl token create` printed");
        token->envname("CDCTL_TOKEN");
        join.add("--token-file", join->token_file, "FILE", "Its first line is the token")
            ->excludes(token);
        join.add("--name", join->name, "TEXT", "For people; by default user and host");
        join.add("--credential", join->master.credential, "FILE", "Where to keep it")
            ->envname("CDCTL_CREDENTIAL");

        CLI::App* tokens = app_.add_subcommand("token", token_help);
        tokens->require_subcommand(1);
        auto create = add<TokenCommand>("create", create_help, tokens);
        create
            .add(
                "--role", create->role, "worker|submitter|admin|metrics", "What the joining may be")
            ->check(one_of({"worker", "submitter", "admin", "metrics"}))
            ->capture_default_str();
        create.add("--ttl", create->ttl, "DURATION", "Lifetime of the token")
            ->capture_default_str();
        create.add("--uses", create->uses, "N", "How many may join with it")
            ->check(CLI::Range(1u, limits::token_uses_max))
            ->capture_default_str();
        add_master_options(*create, create->master);
    }

    /// Returns the command of the verb that was parsed.
    [[nodiscard]] std::optional<Command> take() { return std::move(chosen_); }

  private:
    /// A verb, and the command to which its options are written.
    template <class T>
    class Verb {
      public:
        Verb(CLI::App& app, T& command) : app_(app), command_(command) {}

        CLI::App& operator*() { return app_; }
        T* operator->() { return &command_; }
        template <class Value>
        CLI::Option* add(const char* names, Value& value, const char* type, const char* help) {
            return option_adder(app_)(names, value, type, help);
        }
        CLI::Option* flag(const char* name, bool& value, const char* help) {
            return app_.add_flag(name, value, help);
        }

      private:
        CLI::App& app_;
        T& command_;
    };

    template <class T>
    Verb<T> add(const char* name, const char* help, CLI::App* parent = nullptr) {
        const auto command = std::make_shared<T>();
        CLI::App* verb = (parent != nullptr ? parent : &app_)->add_subcommand(name, help);
        verb->callback([this, command] { chosen_ = *command; });
        return {*verb, *command};
    }

    void add_watch(const char* name, const char* help, bool only_wait) {
        auto watch = add<WatchCommand>(name, help);
        watch->only_wait = only_wait;
        add_job(*watch, watch->job);
        add_master_options(*watch, watch->master);
        add_fail_on(*watch, watch->fail_on, false);
        add_quiet(*watch, watch->quiet);
        add_statistics(*watch, watch->statistics);
        add_output(*watch, watch->output, {"text", "json"});
    }

    CLI::App& app_;
    std::optional<Command> chosen_;
};

/// Turns an error of CLI11, whose exit codes differ by error, into cdctl's one code for wrong
/// usage. CLI11 reports a request for help as an error too; its exit code is 0.
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
    CLI::App app(main_help, "cdctl");
    app.formatter(make_help_formatter());
    app.get_formatter()->column_width(34);
    app.set_version_flag("--version",
                         version_text("cdctl", to_text(simd_target()), false),
                         "Version, commit, compiler, libraries; with -o json for programs");
    app.set_help_flag("-h,--help", "This text");
    app.require_subcommand(1);
    Verbs verbs(app);
    verbs.add_local_verbs();
    verbs.add_job_verbs();
    verbs.add_check_verbs();
    verbs.add_view_verb();
    verbs.add_cluster_verbs();
    verbs.add_identity_verbs();
    if (arguments.front() == "--man") {
        return {std::nullopt,
                man_page(app, 1, "finds every contact of two triangle meshes"),
                exit_done};
    }
    const Result<Settings> settings = read_settings();
    if (arguments.front() == "complete") {
        Command complete = complete_words(app, std::span(arguments).subspan(1));
        give_usual_values(settings ? settings.value() : Settings(), complete);
        return {std::move(complete), "", exit_done};
    }
    try {
        if (settings) {
            set_defaults(app, settings.value());
        }
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        return refused(app, error, arguments);
    }
    if (!settings) { // Help and wrong usage have been told above.
        return {std::nullopt, "cdctl: " + settings.error().detail + "\n", exit_usage};
    }
    CommandLine line{verbs.take(), "", exit_done};
    if (line.command) {
        give_usual_values(settings.value(), *line.command);
    }
    return line;
}

} // namespace cd
