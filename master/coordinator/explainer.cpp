#include "master/coordinator/explainer.hpp"

#include <utility>

namespace cd {

namespace {

AnalysedScenario analysed_scenario(Analysis analysis) {
    return {analysis.position,
            std::move(analysis.roots_a),
            std::move(analysis.roots_b),
            analysis.bytes,
            analysis.predicted_ns,
            {},
            analysis.scenario.body_a,
            analysis.scenario.body_b};
}

} // namespace

Result<AnalysisInput> Explainer::input(JobId id) const {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (job->work() == nullptr) {
        return Error{ErrorCode::Refused,
                     "the job does not give out scenarios: it is " +
                         std::string(job->is_running() ? "being prepared" : to_text(job->state()))};
    }
    return job->work()->analysis_input;
}

Result<std::optional<AnalysisInput>> Explainer::needed(JobId id, std::uint64_t scenario) const {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    const std::uint64_t scenarios = job->submit.scenarios;
    if (scenario >= scenarios) {
        return Error{ErrorCode::NotFound,
                     scenarios == 0
                         ? "the job has no scenarios"
                         : "the job has scenarios 0 to " + std::to_string(scenarios - 1)};
    }
    if (!job->is_running()) {
        return std::optional<AnalysisInput>();
    }
    const Result<AnalysisInput> found = input(id);
    if (!found) {
        return found.error();
    }
    return std::optional(found.value());
}

Result<Explained>
Explainer::explain(JobId id, std::uint64_t scenario, std::optional<Analysis> analysis) const {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (!job->is_running()) {
        return explain_ended(*job, scenario);
    }
    if (const Result<AnalysisInput> found = input(id); !found) {
        return found.error();
    }
    if (!analysis) {
        return Error{ErrorCode::Refused, "the job is running, and the scenario is not analysed"};
    }
    return score(*job, std::move(*analysis));
}

Explained Explainer::score(const MasterJob& job, Analysis analysis) const {
    const std::uint64_t scenario = analysis.scenario.index;
    Explained explained = dispatcher_.explain(job.id, analysed_scenario(std::move(analysis)));
    explained.scenario = scenario;
    if (job.merged.has(explained.scenario)) {
        explained.where = answered_by(job, explained.scenario, explained.roots_a != 0);
        explained.note = "it is answered: the scores are those that it would have now, not those "
                         "by which it was given out";
    }
    return explained;
}

Explained Explainer::explain_ended(const MasterJob& job, std::uint64_t scenario) const {
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
Explainer::answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const {
    const auto author = job.merged.author_of(scenario);
    if (author == nullptr) {
        return needs_worker ? "answered by the master, or by a worker that is no longer on record"
                            : "answered by the master";
    }
    return "answered by " + author->to_text() +
           (author->worker == WorkerId{} || is_here_(author->worker)
                ? ""
                : ", which is not here any more");
}

} // namespace cd
