// Explains one scenario: how workers score for it while its job runs, and who answered it.
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"

namespace cd {

namespace {

Result<Analysis> analyse_again(const AnalysisInput& input, std::uint64_t scenario) {
    const Result<Scenario> read = read_one(*input.poses, scenario);
    if (!read) {
        return read.error();
    }
    return analyse(input, read.value());
}

AnalysedScenario analysed_scenario(Analysis analysis) {
    return {analysis.scenario.index,
            std::move(analysis.roots_a),
            std::move(analysis.roots_b),
            analysis.bytes,
            analysis.predicted_ns};
}

} // namespace

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
        job = jobs_.find(id);
        if (job == nullptr) {
            co_return no_job();
        }
        if (job->is_running()) {
            co_return explain(id, std::move(analysis.value()));
        }
    }
    co_return explain_ended(*job, scenario);
}

Result<Explained> Coordinator::explain(JobId id, Analysis analysis) {
    if (const Result<AnalysisInput> input = analysis_input(id); !input) {
        return input.error();
    }
    Explained explained = dispatcher().explain(id, analysed_scenario(std::move(analysis)));
    const MasterJob& job = jobs_.at(id);
    if (job.merged.has(explained.scenario)) {
        explained.where = answered_by(job, explained.scenario, explained.roots_a != 0);
        explained.note = "it is answered: the scores are those that it would have now, not those "
                         "by which it was given out";
    }
    return explained;
}

Explained Coordinator::explain_ended(const MasterJob& job, std::uint64_t scenario) const {
    Explained explained;
    explained.job = job.id;
    explained.scenario = scenario;
    explained.strategy = job.submit.cluster.strategy;
    explained.where = job.merged.has(scenario)
                          ? answered_by(job, scenario, true)
                          : "never answered: the job is " + std::string(to_text(job.end->state));
    explained.note = "the job has ended, so no worker is scored";
    return explained;
}

std::string
Coordinator::answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const {
    const auto author = job.merged.author_of(scenario);
    if (author == nullptr) {
        return needs_worker ? "answered by the master, or by a worker that is no longer on record"
                            : "answered by the master";
    }
    return "answered by " + author->to_text() +
           (author->worker == WorkerId{} || workers_.contains(author->worker)
                ? ""
                : ", which is not here any more");
}

} // namespace cd
