#include "master/results/result_ingest.hpp"

#include "common/core/check.hpp"
#include "common/job/result/result.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace cd {

namespace {

/// The scenarios of `results` that have no merged result yet.
std::vector<std::uint64_t> new_scenarios(const MasterJob& job, const ResultBatch& results) {
    std::vector<std::uint64_t> scenarios;
    for (const ResultRow& row : results.rows()) {
        if (!job.merged.has(row.scenario)) {
            scenarios.push_back(row.scenario);
        }
    }
    return scenarios;
}

/// Returns the sums by part of the results that are not merged yet, by the pairs that they list.
ContactMap listed_map(const MasterJob& job, const ResultBatch& results) {
    ContactMapSum sum(job.work()->material->parts);
    results.for_each([&](const ResultRow& row, std::span<const std::byte> record) {
        if (!job.merged.has(row.scenario)) {
            const Result<ScenarioResult> result = decode_result(record);
            CD_CHECK(result); // It was checked when it came.
            sum.add(result.value(), {});
        }
    });
    return sum.take();
}

/// Records a message's sequence number. Returns whether the message was sent before.
bool is_repeated(Worker& worker, std::uint64_t sequence) {
    std::uint64_t& last = worker.results_last;
    return sequence != 0 && std::exchange(last, std::max(last, sequence)) >= sequence;
}

} // namespace

void ResultIngest::came(WorkerId worker, Results results, std::function<void()> done) {
    Worker* known = parts_.workers.find(worker);
    if (known == nullptr || known->is_quarantined) {
        parts_.writer.promise(Delivery{worker, results.sequence}); // Acknowledged but not merged.
        parts_.writer.announce();
        return done();
    }
    const bool was_seen = is_repeated(*known, results.sequence);
    Lease* task = parts_.tasks.book().find(worker, results.task);
    IncomingResults incoming{known->author,
                             std::make_shared<const Results>(std::move(results)),
                             std::move(done),
                             was_seen};
    if (was_seen || task == nullptr || task->content->job != incoming.message->job) {
        return late_came(std::move(incoming));
    }
    ++task->checks;
    parts_.background.compute(
        [check = check_, content = task->content, message = incoming.message] {
            return check(*content, *message);
        },
        [this, incoming, content = task->content](Result<TakenResults> taken) {
            take_in(std::make_shared<Checked>(Checked{incoming, content, std::move(taken), {}}));
        });
}

void ResultIngest::acknowledge(const Author& author, std::uint64_t sequence) {
    parts_.writer.promise(Delivery{author.worker, sequence});
    parts_.writer.announce();
}

// ---- Late results ------------------------------------------------------------------------------

void ResultIngest::late_came(IncomingResults late) {
    const MasterJob* job = parts_.jobs.find_running(late.message->job);
    if (job == nullptr) {
        // Nobody needs the results: the job has ended, or its acceptance was lost in a restart.
        acknowledge(*late.author, late.message->sequence);
        parts_.writer.when_room(late.done);
    } else if (job->work() != nullptr) {
        check_late(*job, std::move(late));
    } else {
        parked_.park(std::move(late));
    }
}

void ResultIngest::take_up(JobId job) {
    for (IncomingResults& late : parked_.take(job)) {
        late_came(std::move(late));
    }
}

void ResultIngest::check_late(const MasterJob& job, IncomingResults late) {
    parts_.awaited.check_begins(job.id);
    auto check = [id = job.id,
                  material = job.work()->material,
                  poses = job.run->poses,
                  message = late.message] {
        return take_late_results(id, material, *poses, *message);
    };
    parts_.background.block(
        std::move(check), [this, late = std::move(late)](Result<TakenResults> taken) {
            late_checked(std::make_shared<Checked>(Checked{late, nullptr, std::move(taken), {}}));
        });
}

void ResultIngest::late_checked(Hand hand) {
    const JobId id = hand->job();
    parts_.awaited.check_ends(id);
    MasterJob* job = parts_.jobs.find_running(id);
    if (hand->taken || hand->taken.error().code != ErrorCode::Io) {
        if (job != nullptr) {
            parts_.life.disk_gives(*job);
        }
        return take_in(hand);
    }
    // The poses could not be read, which is not the worker's fault, so the message is kept.
    if (job == nullptr) {
        return late_came(std::move(hand->incoming));
    }
    const bool others_wait = parked_.has_any(id);
    parked_.park(std::move(hand->incoming));
    if (!others_wait) {
        parts_.life.wait_for_disk(*job, hand->taken.error(), [this, id](MasterJob* running) {
            if (running != nullptr && !parked_.has_any(id)) { // All senders have left.
                return parts_.life.disk_gives(*running);
            }
            take_up(id);
        });
    }
}

// ---- Contact maps ------------------------------------------------------------------------------
// A message has one contact map for all its scenarios, which is usable only if no scenario has a
// merged result yet. If some have one, the master makes the map of the other scenarios: it runs
// them again or, without triangles, sums the pairs that their results list.

void ResultIngest::take_in(const Hand& hand) {
    const MasterJob* job = parts_.jobs.find_running(hand->job());
    if (job != nullptr && sums_contacts(job->submit) && hand->taken) {
        TakenResults& taken = hand->taken.value();
        std::vector<std::uint64_t> fresh = new_scenarios(*job, taken.results);
        if (fresh.empty()) {
            taken.map = {};
        } else if (fresh.size() != taken.results.size() && !job->submit.query.maps) {
            taken.map = listed_map(*job, taken.results);
        } else if (fresh.size() != taken.results.size() && fresh != hand->mapped) {
            hand->mapped = std::move(fresh);
            return make_map(*job, hand);
        }
    }
    merge(*hand);
    parts_.writer.when_room(hand->incoming.done);
}

void ResultIngest::make_map(const MasterJob& job, const Hand& hand) {
    parts_.background.block(
        [material = job.work()->material, poses = job.run->poses, hand] {
            return reference_map(*material, *poses, hand->mapped);
        },
        [this, hand](Result<ContactMap> map) { map_made(hand, std::move(map)); });
}

void ResultIngest::map_made(const Hand& hand, Result<ContactMap> map) {
    MasterJob* job = parts_.jobs.find_running(hand->job());
    if (map || job == nullptr) {
        if (map) {
            hand->taken.value().map = std::move(map.value());
        }
        if (job != nullptr) {
            parts_.life.disk_gives(*job);
        }
        return take_in(hand);
    }
    parked_.count(hand->incoming);
    parts_.life.wait_for_disk(*job, map.error(), [this, hand](const MasterJob* running) {
        parked_.uncount(hand->incoming);
        if (running == nullptr) {
            take_in(hand);
        } else {
            make_map(*running, hand);
        }
    });
}

// ---- Merging -----------------------------------------------------------------------------------

void ResultIngest::merge(Checked& hand) {
    const Author& author = *hand.incoming.author;
    const Results& results = *hand.incoming.message;
    if (!hand.taken) {
        return parts_.workers.cut_off(author.worker, hand.taken.error());
    }
    MasterJob* const job = parts_.alarms.is_quarantined(author.process)
                               ? nullptr
                               : parts_.jobs.find_running(hand.job());
    if (job == nullptr) {
        acknowledge(author, results.sequence);
    } else {
        merge_into(*job, hand);
        parts_.writer.announce();
    }
    if (hand.task != nullptr) {
        parts_.tasks.checked(author.worker, results.task);
    }
    parts_.tasks.note_work(author.worker);
}

void ResultIngest::merge_into(MasterJob& job, Checked& hand) {
    const WorkerId worker = hand.incoming.author->worker;
    const Results& results = *hand.incoming.message;
    std::vector<std::uint64_t> scenarios;
    scenarios.reserve(hand.taken.value().results.size());
    for (const ResultRow& row : hand.taken.value().results.rows()) {
        scenarios.push_back(row.scenario);
    }
    if (!hand.incoming.is_repeated) {
        measure(job, hand);
    }
    const bool is_copy = parts_.dispatch.view().is_copy(worker, results.task);
    // Late results belong to no task, and their times were measured before.
    const bool is_late = hand.task == nullptr;
    const auto repeated = std::ranges::count_if(
        scenarios, [&](std::uint64_t scenario) { return job.merged.has(scenario); });
    parts_.dispatch.act(parts_.dispatch->answered({worker,
                                                   is_late ? TaskId{} : results.task,
                                                   job.id,
                                                   std::move(hand.taken.value().positions),
                                                   is_late ? 0 : results.compute_seconds,
                                                   static_cast<std::uint64_t>(repeated)}));
    const std::uint64_t merged_before = job.merged.summary().merged();
    const std::uint64_t disputes_before = job.run->disputes;
    parts_.merger.merge(job, std::move(hand.taken.value()), hand.incoming.author);
    job.tally.help.copies_won += is_copy ? job.merged.summary().merged() - merged_before : 0;
    const Delivery delivery{worker, results.sequence};
    if (!job.is_running() || job.run->disputes == disputes_before) {
        parts_.writer.promise(delivery, job.id, scenarios);
    } else {
        // The worker forgets the results once they are acknowledged, so the acknowledgement waits
        // for everything written so far, which includes the dispute.
        parts_.writer.promise(delivery);
    }
    parts_.life.end_if_complete(job);
}

void ResultIngest::measure(MasterJob& job, const Checked& hand) {
    const Results& results = *hand.incoming.message;
    const ResultBatch& taken = hand.taken.value().results;
    QueryStatistics search = results.statistics;
    if (search.effort != SearchEffort{} && new_scenarios(job, taken).empty()) {
        search.effort = {}; // Counts once for each scenario, whoever answers it again.
    }
    job.tally.statistics.search += search;
    job.tally.compute_seconds += results.compute_seconds;
    job.tally.traffic.result_bytes += results.records.size() + results.map.size();
    // Leaves out traffic that was counted before a restart of the master.
    if (hand.task != nullptr || !new_scenarios(job, taken).empty()) {
        job.tally.traffic.blocks += results.traffic;
    }
    job.work()->rates.work.add(results.compute_seconds, static_cast<double>(taken.size()));
}

} // namespace cd
