// Ingests results: from arrival to merging and journaling.
#include "common/core/host/log.hpp"
#include "common/job/result/packed_map.hpp"
#include "master/base/mutation.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/results/record_size.hpp"

#include <algorithm>
#include <span>

namespace cd {

namespace {

MeasuredWork
measured_work(const MasterJob& job, const Results& results, std::span<const TakenResult> taken) {
    MeasuredWork work{results.task, 0, results.compute_seconds};
    for (const TakenResult& one : taken) {
        if (const auto open = job.open.find(one.result.index); open != job.open.end()) {
            work.predicted_ns += open->second->predicted_ns;
        }
    }
    return work;
}

} // namespace

void Coordinator::results_came(WorkerId worker, Results results, std::function<void()> done) {
    if (is_distrusted(worker)) {
        // Acknowledge: the worker may forget the ignored results.
        ledger_.promise(Delivery{worker, results.sequence}, written_);
        keep_promises();
        return done();
    }
    const auto task = tasks_.find(results.task);
    if (is_repeated(worker, results.sequence) || task == tasks_.end() ||
        task->second.worker != worker || task->second.content->job != results.job) {
        return late_results_came(
            {worker, std::make_shared<const Results>(std::move(results)), std::move(done)});
    }
    ++task->second.in_hand;
    parts_.compute.post([this,
                         executor = parts_.executor,
                         worker,
                         content = task->second.content,
                         came = std::make_shared<const Results>(std::move(results)),
                         done = std::move(done)]() mutable {
        const auto hand = std::make_shared<ResultsInHand>(
            ResultsInHand{worker, content, came, take_results(*content, *came), done, {}});
        asio::post(executor, [this, hand] { take_in(hand); });
    });
}

bool Coordinator::is_repeated(WorkerId worker, std::uint64_t sequence) {
    const auto link = workers_.find(worker);
    if (link == workers_.end() || sequence == 0) {
        return false;
    }
    std::uint64_t& last = link->second.results_last;
    return std::exchange(last, std::max(last, sequence)) >= sequence;
}

bool Coordinator::results_taken(WorkerId worker,
                                const TaskContent* task,
                                const Results& results,
                                Result<TakenResults> taken) {
    if (!taken) {
        cut_off(worker, taken.error());
        return true;
    }
    const JobId id = task == nullptr ? results.job : task->job;
    const Delivery delivery{worker, results.sequence};
    MasterJob* const job = is_distrusted(worker) ? nullptr : jobs_.find_running(id);
    const bool is_late = job == nullptr && !is_distrusted(worker);
    if (job != nullptr) {
        job->statistics.search += results.statistics;
        job->compute_seconds += results.compute_seconds;
        job->traffic.result_bytes += results.records.size() + results.map.size();
        // A resent message that was counted already adds no traffic.
        if (task != nullptr || !new_scenarios(*job, taken.value().results).empty()) {
            job->traffic.blocks += results.traffic;
        }
        const std::size_t count = taken.value().results.size();
        job->work_seconds.add(results.compute_seconds, static_cast<double>(count));
        if (task == nullptr) {
            // Late results measure no task.
        } else if (task->range) {
            act(dispatcher().places_answered(worker, results.task, count, results.compute_seconds));
        } else {
            dispatcher().work_measured(worker, measured_work(*job, results, taken.value().results));
        }
        std::vector<std::uint64_t> scenarios;
        scenarios.reserve(count);
        const bool has_analysed = dispatcher_.unanswered(id) != 0;
        for (const TakenResult& one : taken.value().results) {
            scenarios.push_back(one.result.index);
            // Range answers too: the range may have been lost and its scenarios analysed since.
            if (has_analysed) {
                act(dispatcher().scenario_answered(worker, id, one.result.index));
            }
        }
        const std::uint64_t merged_before = job->merger.summary().merged();
        const std::uint64_t disputes_before = job->disputes;
        merge(*job, std::move(taken.value()), worker);
        if (const auto running = tasks_.find(results.task);
            running != tasks_.end() && running->second.is_copy) {
            job->help.copies_won += job->merger.summary().merged() - merged_before;
        }
        for (const std::uint64_t scenario : scenarios) {
            if (job->help.copies != 0) {
                call_off_places(*job, worker, scenario);
            }
        }
        if (job->disputes == disputes_before) {
            ledger_.promise(delivery, id, scenarios);
        } else {
            // The dispute must be durable before the worker forgets the results.
            ledger_.promise(delivery, written_);
        }
        end_if_complete(*job);
    } else if (!is_late) {
        ledger_.promise(delivery, written_);
    }
    keep_promises();
    // The task is gone if its worker is.
    if (const auto running = tasks_.find(results.task);
        task != nullptr && running != tasks_.end()) {
        --running->second.in_hand;
        end_task_if_complete(results.task);
    }
    note_work(worker);
    feed();
    return !is_late;
}

void Coordinator::merge(MasterJob& job, TakenResults taken, WorkerId worker) {
    AddResults add{job.id, job.results, {}, {}, {}};
    add.author = sessions_.process_of(worker);
    add.results.reserve(taken.results.size());
    for (TakenResult& one : taken.results) {
        job.statistics += one.cost;
        if (const Status fits = check_record_size(one.result.index, one.record.size()); !fits) {
            return end_job(job, JobState::Failed, fits.error().detail);
        }
        if (merge_one(job, one, worker, add)) {
            const ResultRow row{
                one.result.index, one.record.size(), facts_of(one.result), one.digest};
            ledger_.write(job.id, row.scenario, written_ + 1);
            add.results.push_back({row, std::move(one.record)});
        }
    }
    if (!add.results.empty() && add.author != 0 && !mutated(Mutation::LiarKept)) {
        job.contributors.insert(add.author);
    }
    if (!add.results.empty() || !add.remarks.empty()) {
        ++job.changes;
        add.progress = job.progress(Clock::now());
        if (!add.results.empty() && !taken.map.empty()) {
            job.map.add(taken.map);
            add.map = pack_map(taken.map);
        }
        write(std::move(add));
    }
}

bool Coordinator::merge_one(MasterJob& job,
                            const TakenResult& taken,
                            WorkerId worker,
                            AddResults& add) {
    const std::uint64_t index = taken.result.index;
    switch (job.merger.add(taken.result, taken.digest)) {
    case ResultMerger::Outcome::Added:
        break;
    case ResultMerger::Outcome::Repeated:
        if (doubt_ends(job, index, worker)) {
            job.authors[index] = 0; // The result no longer rests on its author alone.
            add.remarks.push_back({Remark::Kind::Vouched, index, {}, 0});
        }
        return mutated(Mutation::SecondAnswerMerged);
    case ResultMerger::Outcome::Differs:
        if (job.given_up.contains(index)) {
            return false;
        }
        doubt_ends(job, index, worker);
        open_dispute(job, {job.id, index, worker, taken.digest}, add);
        return false;
    case ResultMerger::Outcome::Foreign:
        log_error("result for an unknown scenario: job={} scenario={} worker={}",
                  job.id.value,
                  index,
                  worker.value);
        return false;
    }
    if (worker != WorkerId{}) {
        job.authors.resize(std::max<std::size_t>(job.authors.size(), index + 1));
        job.authors[index] = static_cast<std::uint32_t>(worker.value);
    }
    close_analysis(job, index);
    return true;
}

void Coordinator::close_analysis(MasterJob& job, std::uint64_t scenario) {
    if (const auto open = job.open.find(scenario); open != job.open.end()) {
        open_bytes_ -= open->second->bytes;
        job.open.erase(open);
    }
}

} // namespace cd
