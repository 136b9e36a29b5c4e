// How workers score for one scenario, of a job that runs or has ended.
#include "master/coordinator.hpp"
#include "master/job_geometry.hpp"
#include "master/run_on.hpp"

namespace cd {

namespace {

Result<Analysis> analyse_again(const AnalysisInput& input, std::uint64_t scenario) {
    const Result<std::vector<Scenario>> read = input.poses->read(scenario, 1);
    if (!read) {
        return read.error();
    }
    return analyse(input, read.value().front());
}

AnalysedScenario analysed_scenario(Analysis analysis) {
    return {analysis.scenario.index,
            std::move(analysis.roots_a),
            std::move(analysis.roots_b),
            analysis.bytes,
            analysis.predicted_ns};
}

} // namespace

/// One scenario of a job that has ended, as it was when the job ran.
struct Coordinator::EndedScenario {
    JobGeometry geometry;
    Analysis analysis;

    /// May take seconds. Errors: NotFound, telling what is gone.
    [[nodiscard]] static Result<EndedScenario> look_up(GeometryStore& store,
                                                       const Submit& submit,
                                                       const std::filesystem::path& poses_path,
                                                       std::uint64_t scenario) {
        const auto gone = [](const Error& error) {
            return Error{ErrorCode::NotFound,
                         "the job has ended, and what explains its scenarios is gone: " +
                             error.detail};
        };
        if (submit.grid && submit.grid->empty()) {
            return gone({ErrorCode::NotFound, "its grid was too large to be kept"});
        }
        Result<JobGeometry> geometry = make_job_geometry(store, submit);
        if (!geometry) {
            return gone(geometry.error());
        }
        const Result<std::shared_ptr<PoseSource>> poses = open_poses(submit, poses_path);
        if (!poses) {
            return gone(poses.error());
        }
        const AnalysisInput input =
            make_analysis_input(geometry.value(), submit.query, poses.value());
        Result<Analysis> analysis = analyse_again(input, scenario);
        if (!analysis) {
            return gone(analysis.error());
        }
        return EndedScenario{std::move(geometry.value()), std::move(analysis.value())};
    }
};

Result<AnalysisInput> Coordinator::analysis_input(JobId id) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (!job->analysis_input) {
        return Error{ErrorCode::Refused,
                     "the job does not give out scenarios: it is " +
                         std::string(job->is_running() ? "being prepared" : to_text(job->state))};
    }
    return *job->analysis_input;
}

asio::awaitable<Result<Explained>> Coordinator::explain(JobId id, std::uint64_t scenario) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        co_return no_job();
    }
    const std::uint64_t scenarios = job->submit.scenarios;
    if (scenario >= scenarios) {
        co_return Error{ErrorCode::NotFound,
                        scenarios == 0
                            ? "the job has no scenarios"
                            : "the job has scenarios 0 to " + std::to_string(scenarios - 1)};
    }
    if (job->is_running()) {
        const Result<AnalysisInput> input = analysis_input(id);
        if (!input) {
            co_return input.error();
        }
        auto run = [&input, scenario] { return analyse_again(input.value(), scenario); };
        Result<Analysis> analysis = co_await run_on(parts_.blocking, run);
        if (!analysis) {
            co_return analysis.error();
        }
        if (jobs_.find_running(id) != nullptr) {
            co_return explain(id, std::move(analysis.value()));
        }
    }
    co_return co_await explain_ended(id, scenario);
}

Result<Explained> Coordinator::explain(JobId id, Analysis analysis) {
    if (const Result<AnalysisInput> input = analysis_input(id); !input) {
        return input.error();
    }
    Explained explained = dispatcher().explain(id, analysed_scenario(std::move(analysis)));
    add_answer(jobs_.at(id), explained);
    return explained;
}

asio::awaitable<Result<Explained>> Coordinator::explain_ended(JobId id, std::uint64_t scenario) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        co_return no_job();
    }
    Submit submit = job->submit;
    for (std::size_t body = 0; body < job->depths.size(); ++body) {
        submit.cluster.set_depth(body, job->depths[body]);
    }
    auto look_up =
        [&store = parts_.geometry, &submit, path = parts_.journal.poses_path(id), scenario] {
            return EndedScenario::look_up(store, submit, path, scenario);
        };
    Result<EndedScenario> found = co_await run_on(parts_.blocking, look_up);
    job = jobs_.find(id);
    if (!found || job == nullptr) {
        co_return found ? no_job() : found.error();
    }
    // The dispatcher scores for jobs that it has: it has this one for as long as the question
    // takes.
    const JobGeometry& geometry = found.value().geometry;
    const TreeId tree_a = trees_.acquire(submit.bodies[0].mesh, geometry.cut_a);
    const TreeId tree_b = trees_.acquire(submit.bodies[1].mesh, geometry.cut_b);
    act(dispatcher().job_opened(id,
                                submit.cluster,
                                dispatch_tree(tree_a, *geometry.cut_a),
                                dispatch_tree(tree_b, *geometry.cut_b)));
    Explained explained =
        dispatcher().explain(id, analysed_scenario(std::move(found.value().analysis)));
    act(dispatcher().job_closed(id));
    release_tree(tree_a);
    release_tree(tree_b);
    add_answer(*job, explained);
    co_return explained;
}

void Coordinator::add_answer(const MasterJob& job, Explained& explained) const {
    const bool is_answered = job.merger.has(explained.scenario);
    if (is_answered) {
        explained.where = answered_by(job, explained.scenario, explained.roots_a != 0);
    } else if (!job.is_running()) {
        explained.where = "never answered: the job is " + std::string(to_text(job.end->state));
    }
    if (is_answered || !job.is_running()) {
        explained.note = std::string(job.is_running() ? "it is answered" : "the job has ended") +
                         ": the scores are those that it would have now, not those by which it "
                         "was given out";
    }
}

std::string
Coordinator::answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const {
    const WorkerId author{scenario < job.authors.size() ? job.authors[scenario] : 0};
    if (author == WorkerId{}) {
        return needs_worker ? "answered; by whom is not known any more" : "answered by the master";
    }
    const auto link = workers_.find(author);
    const auto lost = lost_.find(author);
    const std::string number = "w-" + std::to_string(author.value);
    if (sessions_.is_earlier(author)) {
        return "answered by " + name_of(author) + ", before the master was started again";
    }
    if (link != workers_.end()) {
        return "answered by " + link->second.name + " (" + number + ")";
    }
    return "answered by " +
           (lost == lost_.end() ? number : lost->second.status.name + " (" + number + ")") +
           ", which is not here any more";
}

} // namespace cd
