// The life of a job in the coordinator: prepared, fed, merged, ended.
#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/job/tolerance.hpp"
#include "master/coordinator.hpp"
#include "master/run_on.hpp"

#include <algorithm>

namespace cd {

/// The geometry of a job.
struct Coordinator::Preparation {
    std::shared_ptr<const ObbTree> tree_a;
    std::shared_ptr<const ObbTree> tree_b;
    std::shared_ptr<const CutGeometry> cut_a;
    std::shared_ptr<const CutGeometry> cut_b;

    /// May take seconds. Errors: those of the store.
    [[nodiscard]] static Result<Preparation> make(GeometryStore& store, const Submit& submit) {
        const auto tree_a = store.tree(submit.bodies[0]);
        const auto tree_b = store.tree(submit.bodies[1]);
        for (const auto* tree : {&tree_a, &tree_b}) {
            if (!*tree) {
                return tree->error();
            }
        }
        const bool is_exact = submit.query.tolerance == 0;
        const auto depth_a = is_exact ? submit.cluster.depth_a : tolerance_depth(*tree_a.value());
        const auto depth_b = is_exact ? submit.cluster.depth_b : tolerance_depth(*tree_b.value());
        const bool is_wide = is_exact && suits_wide_tree(tree_a.value()->view()) &&
                             suits_wide_tree(tree_b.value()->view());
        const SubtreeForm form = is_wide ? SubtreeForm::Wide : SubtreeForm::Binary;
        const auto cut_a = store.cut(submit.bodies[0], depth_a, form);
        const auto cut_b = store.cut(submit.bodies[1], depth_b, form);
        for (const auto* cut : {&cut_a, &cut_b}) {
            if (!*cut) {
                return cut->error();
            }
        }
        return Preparation{tree_a.value(), tree_b.value(), cut_a.value(), cut_b.value()};
    }
};

namespace {

Error no_job(JobId job) {
    return {ErrorCode::NotFound, "no job " + std::to_string(job.value) + " is known here"};
}

DispatchTree dispatch_tree(TreeId id, const CutGeometry& cut) {
    DispatchTree tree{id, {}, {}};
    for (RootIndex root = 0; root < cut.root_count(); ++root) {
        tree.root_triangles.push_back(cut.top().triangles_under(root));
        tree.root_bytes.push_back(cut.compressed_bytes(root));
    }
    return tree;
}

std::shared_ptr<const TreeTop> top_of(const std::shared_ptr<const CutGeometry>& cut) {
    return {cut, &cut->top()};
}

} // namespace

Result<JobId> Coordinator::open_job(Submit submit, std::shared_ptr<PoseSource> poses) {
    submit.grid.reset(); // The source has it.
    Result<std::unique_ptr<ResultStore>> results =
        ResultStore::create(parts_.directory, submit.scenarios);
    if (!results) {
        return results.error();
    }
    const Result<MasterJob*> job =
        jobs_.add(std::move(submit), std::move(results.value()), Clock::now());
    if (!job) {
        return job.error();
    }
    const JobId id = job.value()->id;
    spdlog::info("job accepted: job={} name=\"{}\" scenarios={} strategy={}",
                 id.value,
                 job.value()->submit.name,
                 job.value()->submit.scenarios,
                 to_text(job.value()->submit.cluster.strategy));
    spawn(parts_.executor, "prepare job", prepare_job(id, std::move(poses)));
    return id;
}

asio::awaitable<void> Coordinator::prepare_job(JobId id, std::shared_ptr<PoseSource> poses) {
    const Submit submit = jobs_.find(id)->submit;
    auto make = [&store = parts_.geometry, &submit] { return Preparation::make(store, submit); };
    const Result<Preparation> made = co_await run_on(parts_.blocking, make);
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        co_return; // Cancelled meanwhile.
    }
    if (!made) {
        end_job(*job, JobState::Failed, made.error().detail);
        co_return;
    }
    start_job(*job, made.value(), std::move(poses));
}

void Coordinator::start_job(MasterJob& job,
                            const Preparation& made,
                            std::shared_ptr<PoseSource> poses) {
    const Submit& submit = job.submit;
    job.material =
        std::make_shared<const JobMaterial>(JobMaterial{made.tree_a, made.tree_b, submit.query});
    job.tree_a = trees_.acquire(submit.bodies[0], made.cut_a);
    job.tree_b = trees_.acquire(submit.bodies[1], made.cut_b);
    AnalysisInput input{made.tree_a,
                        made.tree_b,
                        top_of(made.cut_a),
                        top_of(made.cut_b),
                        submit.query,
                        std::move(poses)};
    // On a thread of the pool; the records are made there, too.
    auto deliver = [this, executor = parts_.executor, id = job.id](AnalysedBlock came) {
        auto finished = std::make_shared<std::vector<TakenResult>>();
        for (Analysis& analysis : came.scenarios) {
            if (analysis.finished) {
                finished->push_back(take_result(std::move(*analysis.finished), analysis.cost));
            }
        }
        auto block = std::make_shared<AnalysedBlock>(std::move(came));
        asio::post(executor,
                   [this, id, block, finished] { block_came(id, std::move(*block), *finished); });
    };
    job.analysis_input = input;
    job.order = std::make_shared<OrderedPoses>(std::move(input.poses));
    job.todo = PlaceQueue(job.order->count());
    input.poses = job.order;
    job.submitter =
        std::make_unique<Submitter>(parts_.compute, std::move(input), std::move(deliver));
    act(dispatcher().job_opened(job.id,
                                submit.cluster,
                                dispatch_tree(job.tree_a, *made.cut_a),
                                dispatch_tree(job.tree_b, *made.cut_b)));
    if (job.merger.summary().is_complete()) {
        end_job(job, JobState::Done, ""); // A job without scenarios.
    }
    feed();
}

void Coordinator::block_came(JobId id,
                             AnalysedBlock block,
                             const std::vector<TakenResult>& finished) {
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        return;
    }
    if (block.error) {
        end_job(*job, JobState::Failed, block.error->detail);
        return feed();
    }
    const auto begin = Clock::now();
    std::uint64_t handed_out = 0;
    for (Analysis& analysis : block.scenarios) {
        // Of what came back, the answer may have come meanwhile.
        if (analysis.finished || job->merger.has(analysis.scenario.index)) {
            continue;
        }
        AnalysedScenario scenario{analysis.scenario.index,
                                  std::move(analysis.roots_a),
                                  std::move(analysis.roots_b),
                                  analysis.bytes,
                                  analysis.predicted_ns,
                                  block.losses};
        open_bytes_ += analysis.bytes;
        job->open.emplace(scenario.index, std::make_shared<const Analysis>(std::move(analysis)));
        act(dispatcher().scenario_analysed(id, std::move(scenario)));
        ++handed_out;
    }
    job->analysis_seconds.add(block.seconds, static_cast<double>(block.places.count));
    if (handed_out != 0) {
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        job->matching_seconds.add(seconds, static_cast<double>(handed_out));
    }
    for (const TakenResult& taken : finished) {
        ++job->answered_by_master;
        job->statistics += taken.cost;
        merge(*job, taken, WorkerId{});
        if (!job->is_running()) {
            break;
        }
    }
    feed();
}

void Coordinator::merge(MasterJob& job, const TakenResult& taken, WorkerId worker) {
    const std::uint64_t index = taken.result.index;
    switch (job.merger.add(taken.result, taken.digest)) {
    case ResultMerger::Outcome::Added:
        break;
    case ResultMerger::Outcome::Repeated:
        return;
    case ResultMerger::Outcome::Differs:
        spdlog::error("results differ, the first one stays: job={} scenario={} worker={}",
                      job.id.value,
                      index,
                      worker.value);
        return;
    case ResultMerger::Outcome::Foreign:
        spdlog::error("result of no scenario: job={} scenario={} worker={}",
                      job.id.value,
                      index,
                      worker.value);
        return;
    }
    if (const auto open = job.open.find(index); open != job.open.end()) {
        open_bytes_ -= open->second->bytes;
        job.open.erase(open);
    }
    ++job.changes;
    if (const Status stored = job.results->add(index, taken.record); !stored) {
        return end_job(job, JobState::Failed, stored.error().detail);
    }
    if (job.merger.summary().is_complete()) {
        end_job(job, JobState::Done, "");
    }
}

void Coordinator::end_job(MasterJob& job, JobState state, const std::string& failure) {
    for (const auto& [index, analysis] : job.open) {
        open_bytes_ -= analysis->bytes;
    }
    const bool has_trees = job.material != nullptr;
    jobs_.end(job, state, failure, Clock::now());
    const JobStatus status = job.status(Clock::now());
    spdlog::info("job ended: job={} state={} merged={} total={} seconds={:.3f} digest={}{}",
                 job.id.value,
                 to_text(state),
                 status.summary.merged(),
                 status.summary.total,
                 status.seconds,
                 status.digest ? to_short_hex(*status.digest) : "none",
                 failure.empty() ? "" : " reason=\"" + failure + "\"");
    act(dispatcher().job_closed(job.id));
    for (auto& [worker, link] : workers_) {
        if (link.jobs.erase(job.id) != 0) {
            link.channel->send(RemoveJob{job.id});
        }
    }
    if (has_trees) {
        release_tree(job.tree_a);
        release_tree(job.tree_b);
    }
    const auto [begin, end] = waiting_for_end_.equal_range(job.id);
    for (auto waiting = begin; waiting != end; ++waiting) {
        if (const auto timer = waiting->second.lock()) {
            timer->cancel();
        }
    }
    waiting_for_end_.erase(begin, end);
}

void Coordinator::release_tree(TreeId tree) {
    if (!trees_.release(tree)) {
        return;
    }
    blocks_.tree_removed(tree);
    for (auto& [id, link] : workers_) {
        link.transfers.tree_removed(tree);
        if (link.trees.erase(tree) != 0) {
            link.channel->send(RemoveTree{tree});
        }
    }
}

void Coordinator::tree_failed(TreeId tree, const Error& why) {
    for (const JobId id : std::set<JobId>(jobs_.running())) {
        MasterJob& job = *jobs_.find(id);
        if (job.material != nullptr && (job.tree_a == tree || job.tree_b == tree)) {
            end_job(job, JobState::Failed, why.detail);
        }
    }
    feed();
}

// ---- Questions
// ------------------------------------------------------------------------------------

Result<JobStatus> Coordinator::cancel_job(JobId id) {
    MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job(id);
    }
    if (job->is_running()) {
        end_job(*job, JobState::Cancelled, "cancelled");
        feed();
    }
    return job->status(Clock::now());
}

Result<JobStatus> Coordinator::job_status(JobId id) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job(id);
    }
    return job->status(Clock::now());
}

Result<AnalysisInput> Coordinator::analysis_input(JobId id) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job(id);
    }
    if (!job->analysis_input) {
        return Error{ErrorCode::Refused,
                     "the job does not give out scenarios: it is " +
                         std::string(job->is_running() ? "being prepared" : to_text(job->state))};
    }
    return *job->analysis_input;
}

Result<Explained> Coordinator::explain(JobId id, Analysis analysis) {
    // It may have ended while the scenario was analysed.
    if (const Result<AnalysisInput> input = analysis_input(id); !input) {
        return input.error();
    }
    return dispatcher().explain(id,
                                {analysis.scenario.index,
                                 std::move(analysis.roots_a),
                                 std::move(analysis.roots_b),
                                 analysis.bytes,
                                 analysis.predicted_ns});
}

std::uint64_t Coordinator::job_changes(JobId id) {
    const MasterJob* job = jobs_.find(id);
    return job == nullptr ? 0 : job->changes;
}

void Coordinator::notify_at_end(JobId job, const std::shared_ptr<asio::steady_timer>& timer) {
    waiting_for_end_.emplace(job, timer);
}

std::shared_ptr<ResultStore> Coordinator::results_of(JobId id) {
    const MasterJob* job = jobs_.find(id);
    return job == nullptr ? nullptr : job->results;
}

} // namespace cd
