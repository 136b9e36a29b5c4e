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
    const Worker* known = workers_.find(worker);
    if (known == nullptr || known->is_quarantined) {
        // Acknowledge: the worker may forget the ignored results.
        writer_.promise(Delivery{worker, results.sequence});
        writer_.announce();
        return done();
    }
    const auto& author = known->author;
    const auto task = tasks_.find(results.task);
    if (is_repeated(worker, results.sequence) || task == tasks_.end() ||
        task->second.worker != worker || task->second.content->job != results.job) {
        return late_results_came(
            {author, std::make_shared<const Results>(std::move(results)), std::move(done)});
    }
    ++task->second.in_hand;
    parts_.compute.post([this,
                         executor = parts_.executor,
                         author,
                         content = task->second.content,
                         came = std::make_shared<const Results>(std::move(results)),
                         done = std::move(done)]() mutable {
        const auto hand = std::make_shared<ResultsInHand>(
            ResultsInHand{author, content, came, take_results(*content, *came), done, {}});
        asio::post(executor, [this, hand] { take_in(hand); });
    });
}

bool Coordinator::is_repeated(WorkerId worker, std::uint64_t sequence) {
    Worker* known = workers_.find(worker);
    if (known == nullptr || sequence == 0) {
        return false;
    }
    std::uint64_t& last = known->results_last;
    return std::exchange(last, std::max(last, sequence)) >= sequence;
}

void Coordinator::results_taken(const ResultsInHand& hand, Result<TakenResults> taken) {
    const WorkerId worker = hand.author->worker;
    const Results& results = *hand.message;
    if (!taken) {
        return workers_.cut_off(worker, taken.error());
    }
    const JobId id = hand.job();
    const Delivery delivery{worker, results.sequence};
    MasterJob* const job =
        alarms_.is_quarantined(hand.author->process) ? nullptr : jobs_.find_running(id);
    if (job == nullptr) {
        writer_.promise(delivery); // Nobody needs the results.
    } else {
        job->statistics.search += results.statistics;
        job->compute_seconds += results.compute_seconds;
        job->traffic.result_bytes += results.records.size() + results.map.size();
        // A resent message that was counted already adds no traffic.
        if (hand.task != nullptr || !new_scenarios(*job, taken.value().results).empty()) {
            job->traffic.blocks += results.traffic;
        }
        const std::size_t count = taken.value().results.size();
        job->work_seconds.add(results.compute_seconds, static_cast<double>(count));
        if (hand.task == nullptr) {
            // Late results measure no task.
        } else if (hand.task->range) {
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
        const std::uint64_t merged_before = job->merged.summary().merged();
        const std::uint64_t disputes_before = job->disputes;
        merge(*job, std::move(taken.value()), hand.author);
        if (const auto running = tasks_.find(results.task);
            running != tasks_.end() && running->second.is_copy) {
            job->help.copies_won += job->merged.summary().merged() - merged_before;
        }
        for (const std::uint64_t scenario : scenarios) {
            if (job->help.copies != 0) {
                call_off_places(*job, worker, scenario);
            }
        }
        if (job->disputes == disputes_before) {
            writer_.promise(delivery, id, scenarios);
        } else {
            // The dispute must be durable before the worker forgets the results.
            writer_.promise(delivery);
        }
        end_if_complete(*job);
    }
    writer_.announce();
    // The task is gone if its worker is.
    if (const auto running = tasks_.find(results.task);
        hand.task != nullptr && running != tasks_.end()) {
        --running->second.in_hand;
        end_task_if_complete(results.task);
    }
    note_work(worker);
    feed();
}

void Coordinator::merge(MasterJob& job,
                        TakenResults taken,
                        const std::shared_ptr<const Author>& author) {
    AddResults add{job.id, job.results, {}, {}, {}};
    std::vector<Dispute> disputes;
    add.author = author == nullptr ? 0 : author->process;
    add.results.reserve(taken.results.size());
    for (TakenResult& one : taken.results) {
        job.statistics += one.cost;
        if (const Status fits = check_record_size(one.result.index, one.record.size()); !fits) {
            return end_job(job, JobState::Failed, fits.error().detail);
        }
        if (auto dispute = merge_one(job, one, author, add)) {
            disputes.push_back(std::move(*dispute));
        }
    }
    if (!add.results.empty() || !add.remarks.empty()) {
        ++job.changes;
        add.progress = job.progress(Clock::now());
        if (!add.results.empty() && !taken.map.empty() && job.map.withdrawn().empty()) {
            job.map.add(taken.map);
            add.map = pack_map(taken.map);
        }
        writer_.write(std::move(add));
    }
    for (const Dispute& dispute : disputes) {
        writer_.promise(dispute);
    }
}

std::optional<Dispute> Coordinator::merge_one(MasterJob& job,
                                              TakenResult& taken,
                                              const std::shared_ptr<const Author>& author,
                                              AddResults& add) {
    const std::uint64_t index = taken.result.index;
    const ScenarioFacts facts = facts_of(taken.result);
    switch (job.merged.add(index, facts, taken.digest, author)) {
    case MergedResults::Outcome::Repeated:
        if (!mutated(Mutation::SecondAnswerMerged)) {
            return std::nullopt;
        }
        break;
    case MergedResults::Outcome::Differs:
        // A failure that the master itself has recorded stays: the scenario may take it down, or
        // was cancelled.
        if (author != nullptr && !job.merged.is_failed_by_master(index)) {
            return open_dispute(job, {job.id, index, author, taken.digest}, add);
        }
        return std::nullopt;
    case MergedResults::Outcome::Foreign:
        log_error("result for an unknown scenario: job={} scenario={}", job.id.value, index);
        return std::nullopt;
    case MergedResults::Outcome::Added:
        close_analysis(job, index);
    }
    const ResultRow row{index, taken.record.size(), facts, taken.digest};
    add.results.push_back({row, std::move(taken.record)});
    return std::nullopt;
}

void Coordinator::close_analysis(MasterJob& job, std::uint64_t scenario) {
    if (const auto open = job.open.find(scenario); open != job.open.end()) {
        open_bytes_ -= open->second->bytes;
        job.open.erase(open);
    }
}

} // namespace cd
