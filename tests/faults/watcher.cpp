#include "tests/faults/watcher.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "master/journal/journal_records.hpp"
#include "master/journal/result_group.hpp"
#include "master/journal/result_store.hpp"
#include "master/workers/worker_watch.hpp"
#include "tests/faults/world.hpp"

#include <algorithm>

namespace cd::tests {

namespace {

std::string name_of(JobId job, std::uint64_t scenario) {
    return "scenario " + std::to_string(scenario) + " of job " + std::to_string(job.value);
}

std::vector<std::uint64_t> scenarios_in(const Bytes& packed) {
    std::vector<std::uint64_t> indices;
    const std::vector<Scenario> scenarios = unpack_scenarios(packed, limits::scenarios_max).value();
    for (const Scenario& scenario : scenarios) {
        indices.push_back(scenario.index);
    }
    return indices;
}

std::vector<std::uint64_t> scenarios_in(const WorkUnit& unit) {
    if (!unit.scenarios.empty()) {
        return scenarios_in(unit.scenarios);
    }
    std::vector<std::uint64_t> indices;
    for (std::uint64_t i = 0; i < unit.count; ++i) {
        indices.push_back(unit.first + i);
    }
    return indices;
}

std::vector<InstanceId> authors_of(const ResultGroup& group) {
    std::vector<InstanceId> authors;
    for (const AuthorRun& run : group.authors) {
        authors.insert(authors.end(), run.rows, run.author);
    }
    return authors;
}

/// The digest of a record that the master has written.
Sha256 digest_at(JobId job, const RecordPlace& place) {
    const std::string path = "/state/jobs/" + std::to_string(job.value) + ".results";
    const Bytes& content = World::current()->disk.by_path.at(path)->content;
    return digest_of_record(std::span(content).subspan(place.offset, place.length));
}

} // namespace

std::vector<std::uint64_t> scenarios_in(const Results& results) {
    std::vector<std::uint64_t> indices;
    Bytes unpacked;
    ByteReader in(received_records(results.records, results.are_packed, unpacked).value());
    for (std::uint32_t i = 0; i < results.count; ++i) {
        indices.push_back(decode_result(in.get_bytes(in.get<std::uint32_t>())).value().index);
    }
    return indices;
}

// ---- The disk -----------------------------------------------------------------------------------

std::string Watcher::committed(std::span<const DatabaseChange> changes) {
    using Kind = DatabaseChange::Kind;
    std::string wrong;
    for (const DatabaseChange& change : changes) {
        if (change.kind == Kind::Alarms) {
            alarms = change.content;
            continue;
        }
        DurableJob& job = jobs_[change.job];
        switch (change.kind) {
        case Kind::Accept:
            job.record = change.content;
            job.known = &known_job(decode_job(job.record).value().submit.name);
            last_job = std::max(last_job, change.job);
            break;
        case Kind::Record:
            job.record = change.content;
            break;
        case Kind::Progress:
            job.progress = change.content;
            break;
        case Kind::Results:
            if (const std::string found = add_group(change.job, change.content); wrong.empty()) {
                wrong = found;
            }
            break;
        case Kind::End:
            job.end = change.content;
            if (const std::string found = check_end(change.job, job); wrong.empty()) {
                wrong = found;
            }
            break;
        case Kind::Drop:
            jobs_.erase(change.job);
            break;
        case Kind::Alarms:
            break;
        }
    }
    return wrong;
}

std::string Watcher::add_group(JobId id, const Bytes& bytes) {
    DurableJob& job = jobs_[id];
    job.groups.push_back(bytes);
    std::string wrong;
    const ResultGroup group = decode_group(bytes).value();
    for (const Bytes& map : group.maps) {
        constexpr std::uint64_t any = 1u << 20;
        job.map.add(unpack_map(map, {any, any, any}).value());
    }
    std::set<InstanceId> withdrawn;
    for (const Remark& remark : group.remarks) {
        if (remark.kind == Remark::Kind::Withdrawn) {
            withdrawn.insert(remark.author);
            withdraw(job, remark.author);
        }
    }
    const std::vector<InstanceId> authors = authors_of(group);
    std::uint64_t end = group.begin;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const ResultRow& row = group.rows[i];
        const RecordPlace place = ResultStore::place_at(end, row.length);
        end = ResultStore::end_of(place);
        if (withdrawn.contains(authors[i])) {
            job.withdrawn.insert(row.scenario);
            continue;
        }
        const std::string name = name_of(id, row.scenario);
        const auto [result, is_new] =
            job.results.emplace(row.scenario, DurableResult{digest_at(id, place), authors[i]});
        if (!is_new && job.is_right(row.scenario)) {
            wrong = name + " is merged twice";
        } else if (!is_new) {
            result->second.digest = digest_at(id, place);
            result->second.author = authors[i];
            ++corrected_;
        }
        if (row.facts.kind != ScenarioClass::Failed) {
            continue;
        }
        job.failed.insert(row.scenario);
        if (times_sent_[{id, row.scenario}] < limits::scenario_losses_max) {
            wrong = name + " is given up, and went out " +
                    std::to_string(times_sent_[{id, row.scenario}]) + " times";
        }
    }
    return wrong;
}

void Watcher::withdraw(DurableJob& job, InstanceId author) {
    for (auto result = job.results.begin(); result != job.results.end();) {
        const bool is_its = result->second.author == author;
        if (is_its) {
            job.withdrawn.insert(result->first);
            ++corrected_;
        }
        result = is_its ? job.results.erase(result) : std::next(result);
    }
}

void Watcher::master_began() {
    ranges_.clear();
    given_back_.clear();
    held_.clear();
    sessions_.clear();
    tasks_given_.clear();
    done_before_.clear();
    for (const auto& [id, job] : jobs_) {
        for (const auto& [scenario, result] : job.results) {
            done_before_[id].insert(scenario);
        }
    }
    awaited_.clear();
    awaited_until_ = std::chrono::steady_clock::now() + FailureTimes().return_within;
    for (const auto& [id, job] : jobs_) {
        for (const auto& [scenario, result] : job.results) {
            if (job.end.empty() && result.author != 0) {
                awaited_[id].insert(result.author);
            }
        }
    }
}

// ---- Messages ---------------------------------------------------------------------------------

std::string Watcher::master_says(const Route& route, const Message& message) {
    if (std::string wrong = check_quarantined(route, message); !wrong.empty()) {
        return wrong;
    }
    if (const auto* welcome = std::get_if<Welcome>(&message)) {
        return welcomed(route, *welcome);
    } else if (const auto* unit = std::get_if<WorkUnit>(&message)) {
        tasks_given_.insert({route.to, unit->task});
        const std::vector<std::uint64_t> scenarios = scenarios_in(*unit);
        if (!unit->is_analysed()) {
            ranges_[{route.to, unit->task}] = scenarios;
        }
        return sent(unit->job, scenarios);
    } else if (const auto* directions = std::get_if<FetchFromPeers>(&message)) {
        return check_sources(*directions);
    } else if (const auto* drop = std::get_if<DropScenario>(&message)) {
        called_off_ += drop->task == TaskId{} ? 0 : 1;
    } else if (const auto* kept = std::get_if<ResultsKept>(&message)) {
        for (const std::uint64_t sequence : kept->sequences) {
            if (std::string wrong = check_kept(route.to, sequence); !wrong.empty()) {
                return wrong;
            }
        }
    }
    return {};
}

/// Rejects work sent before returning workers have delivered their results: it may repeat them.
std::string Watcher::check_awaited(JobId job) const {
    const auto found = awaited_.find(job);
    if (found == awaited_.end() || std::chrono::steady_clock::now() >= awaited_until_) {
        return {};
    }
    for (const std::uint64_t worker : found->second) {
        if (!quarantine().contains(worker)) {
            return "work of job " + std::to_string(job.value) + " goes out before worker-" +
                   std::to_string(worker) + " has said what it brings";
        }
    }
    return {};
}

std::string Watcher::sent(JobId job, std::span<const std::uint64_t> scenarios) {
    const std::set<std::uint64_t>& done = done_before_[job];
    for (const std::uint64_t scenario : scenarios) {
        ++scenarios_sent_;
        ++times_sent_[{job, scenario}];
        // Results of a quarantined worker may be withdrawn before the journal has it on disk.
        const auto is_withdrawn = [&] {
            const auto result = jobs_.at(job).results.find(scenario);
            return result == jobs_.at(job).results.end() ||
                   quarantine().contains(result->second.author);
        };
        if (done.contains(scenario) && !is_withdrawn()) {
            return name_of(job, scenario) + " is done again after a restart";
        }
    }
    return check_awaited(job);
}

std::string Watcher::check_kept(std::uint64_t worker, std::uint64_t sequence) {
    const auto found = deliveries_.find({worker, sequence});
    if (found == deliveries_.end()) {
        return "acknowledged what was never sent";
    }
    if (quarantine().contains(worker)) {
        return {}; // Nobody needs its answers.
    }
    for (const auto& [id, scenario] : found->second) {
        const auto job = jobs_.find(id);
        // Nobody needs results of a job that has ended or never existed. A result that repeats one
        // of an exposed worker is withdrawn with it.
        if (job != jobs_.end() && job->second.end.empty() &&
            !job->second.results.contains(scenario) && !job->second.withdrawn.contains(scenario)) {
            return name_of(id, scenario) + " is acknowledged, and not on the disk";
        }
        acknowledged(worker, id, scenario);
    }
    return {};
}

std::string Watcher::check_sources(const FetchFromPeers& directions) const {
    if (directions.sources.size() > limits::peer_sources_max) {
        return "more sources are named for a fetch than may be";
    }
    for (const PeerSource& source : directions.sources) {
        for (const RootIndex root : directions.roots) {
            if (!held_.contains({source.worker, directions.tree, root})) {
                return "worker " + std::to_string(source.worker.value) +
                       " is to give a block that it never said to hold, or has let go";
            }
        }
    }
    return {};
}

void Watcher::given_back(std::uint64_t worker, const Recalled& recalled) {
    std::set<std::uint64_t>& back = given_back_[{worker, recalled.task}];
    const std::size_t before = back.size();
    back.insert(recalled.scenarios.begin(), recalled.scenarios.end());
    const std::vector<std::uint64_t>& range = ranges_[{worker, recalled.task}];
    for (std::uint64_t position = recalled.kept; position < range.size(); ++position) {
        back.insert(range[position]);
    }
    recalled_ += back.size() - before;
}

std::string Watcher::check_answers(std::uint64_t worker, const Results& results) {
    const std::set<std::uint64_t>& back = given_back_[{worker, results.task}];
    for (const std::uint64_t scenario : scenarios_in(results)) {
        if (back.contains(scenario)) {
            return name_of(results.job, scenario) + " is answered by who has given it back";
        }
    }
    return {};
}

std::string Watcher::worker_says(const Route& route, const Message& message) {
    if (const auto* hello = std::get_if<Hello>(&message)) {
        hellos_[route.connection] = *hello;
        corrections_[route.from] = {route.connection, {}, 0};
    } else if (const auto* recalled = std::get_if<Recalled>(&message)) {
        given_back(route.from, *recalled);
    } else if (const auto* inventory = std::get_if<Inventory>(&message)) {
        for (const Recalled& task : inventory->tasks) {
            given_back(route.from, task);
        }
    }
    note_correction(route, message, false);
    const auto* results = std::get_if<Results>(&message);
    if (results == nullptr) {
        return {};
    }
    if (std::string wrong = check_answers(route.from, *results); !wrong.empty()) {
        return wrong;
    }
    std::vector<Key>& keys = deliveries_[{route.from, results->sequence}];
    results_repeated_ += keys.empty() ? 0 : 1;
    keys.clear();
    for (const std::uint64_t scenario : scenarios_in(*results)) {
        keys.emplace_back(results->job, scenario);
    }
    return {};
}

/// A session resumes only in the master incarnation that began it.
std::string Watcher::welcomed(const Route& route, const Welcome& welcome) {
    worker_ids_[route.connection] = WorkerId{welcome.id};
    connections_[route.to] = route.connection;
    sessions_[route.to] = WorkerId{welcome.id};
    const Hello& hello = hellos_[route.connection];
    old_sessions_ += hello.resumed.id != 0 && !welcome.is_resumed ? 1 : 0;
    const bool is_right = hello.resumed.epoch == welcome.epoch && hello.resumed.id == welcome.id;
    return welcome.is_resumed && !is_right ? "a session of a former life of the master goes on"
                                           : "";
}

std::string Watcher::master_hears(const Route& route, const Message& message) {
    const auto id = worker_ids_.find(route.connection);
    if (id == worker_ids_.end()) {
        return {};
    }
    if (connections_.at(route.from) != route.connection) {
        ++late_messages_; // The master must ignore the message.
        return {};
    }
    note_held(id->second, message);
    note_correction(route, message, true);
    if (std::holds_alternative<Inventory>(message)) {
        for (auto& [job, workers] : awaited_) {
            workers.erase(route.from);
        }
    }
    if (const auto* results = std::get_if<Results>(&message)) {
        answering_.insert(route.from);
        late_results_ += results->task == TaskId{} ? 1 : 0;
        if (results->task != TaskId{} && !tasks_given_.contains({route.from, results->task})) {
            return "task " + std::to_string(results->task.value) +
                   " is answered by who never got it from this life of the master";
        }
    }
    return {};
}

WorkerId Watcher::session_of(std::uint64_t worker) const {
    const auto found = sessions_.find(worker);
    return found == sessions_.end() ? WorkerId{} : found->second;
}

bool Watcher::is_correction_under_way(std::uint64_t worker, TreeId tree, RootIndex root) const {
    const auto found = corrections_.find(worker);
    return found != corrections_.end() &&
           (found->second.standings != 0 || found->second.blocks.contains({tree, root}));
}

void Watcher::note_correction(const Route& route, const Message& message, bool is_heard) {
    Corrections& corrections = corrections_[route.from];
    if (corrections.connection != route.connection) {
        return; // The message was in vain.
    }
    const auto note = [&](TreeId tree, std::span<const RootIndex> roots) {
        for (const RootIndex root : roots) {
            const auto position = corrections.blocks.try_emplace({tree, root}).first;
            position->second += is_heard ? -1 : 1;
            if (position->second == 0) {
                corrections.blocks.erase(position);
            }
        }
    };
    if (const auto* evicted = std::get_if<Evicted>(&message)) {
        note(evicted->tree, evicted->roots);
    } else if (const auto* want = std::get_if<WantSubtrees>(&message)) {
        note(want->tree, want->roots);
    } else if (std::holds_alternative<Inventory>(message)) {
        corrections.standings += is_heard ? -1 : 1;
    }
}

void Watcher::note_held(WorkerId worker, const Message& message) {
    const auto set = [&](TreeId tree, std::span<const RootIndex> roots, bool holds) {
        for (const RootIndex root : roots) {
            if (holds) {
                held_.insert({worker, tree, root});
            } else {
                held_.erase({worker, tree, root});
            }
        }
    };
    if (const auto* held = std::get_if<Held>(&message)) {
        set(held->tree, held->roots, true);
    } else if (const auto* evicted = std::get_if<Evicted>(&message)) {
        set(evicted->tree, evicted->roots, false);
    } else if (const auto* want = std::get_if<WantSubtrees>(&message)) {
        set(want->tree, want->roots, false);
    } else if (const auto* inventory = std::get_if<Inventory>(&message)) {
        std::erase_if(held_, [&](const auto& one) { return std::get<0>(one) == worker; });
        for (const InventoryTree& tree : inventory->trees) {
            set(tree.tree, tree.held, true);
        }
    }
}

} // namespace cd::tests
