#include "client/report/cluster_report.hpp"

#include "client/base/job_id.hpp"
#include "client/base/words.hpp"
#include "client/report/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <ctime>

namespace cd {

namespace {

std::string worker_name(const WorkerStatus& worker) {
    return "w-" + std::to_string(worker.worker.value);
}

std::string worker_state(const WorkerStatus& worker) {
    if (worker.state != WorkerState::Alive) {
        return std::string(to_text(worker.state)) + " " +
               cell_text(worker.silent_seconds, CellKind::Seconds);
    }
    if (worker.quarantined) {
        return "quarantined";
    }
    if (worker.draining) {
        return "draining";
    }
    if (worker.working != 0 || worker.buffered != 0) {
        return worker.claimed ? "claimed" : "working";
    }
    return "idle";
}

/// A time in UTC: "2026-03-01 12:00:00Z"; empty if the time cannot be converted.
std::string utc_text(std::uint64_t unix_seconds) {
    const auto time = static_cast<std::time_t>(unix_seconds);
    std::tm parts{};
    std::array<char, 32> text{};
    if (::gmtime_r(&time, &parts) == nullptr ||
        std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%SZ", &parts) == 0) {
        return "";
    }
    return text.data();
}

std::size_t count_running(const ClusterStatus& status) {
    return static_cast<std::size_t>(
        std::count_if(status.jobs.begin(), status.jobs.end(), [](const JobStatus& job) {
            return job.state == JobState::Running;
        }));
}

std::size_t count_here(const ClusterStatus& status) {
    return static_cast<std::size_t>(
        std::count_if(status.workers.begin(), status.workers.end(), [](const WorkerStatus& worker) {
            return worker.state != WorkerState::Lost;
        }));
}

std::uint64_t contacts_of(const Summary& summary) {
    return summary.touch + summary.cross + summary.inside + summary.contact;
}

/// The number of triangle pairs that a stage after floats decided.
std::uint64_t past_float(const PairStatistics& decisions) {
    return decisions.total() - decisions[PairStage::Float];
}

template <class Member>
std::uint64_t sum_over_workers(const ClusterStatus& status, Member member) {
    std::uint64_t sum = 0;
    for (const WorkerStatus& worker : status.workers) {
        sum += worker.*member;
    }
    return sum;
}

/// How much the sum of `member` over all workers grew between two statuses, per second; 0 if the
/// sum fell because workers left.
template <class Member>
double rate_between(const ClusterStatus& before, const ClusterStatus& after, Member member) {
    const double seconds = after.uptime_seconds - before.uptime_seconds;
    const std::uint64_t first = sum_over_workers(before, member);
    const std::uint64_t last = sum_over_workers(after, member);
    return seconds <= 0 || last < first ? 0 : static_cast<double>(last - first) / seconds;
}

/// The master's processor time between two statuses, as a share of one core.
double master_share(const ClusterStatus& before, const ClusterStatus& after) {
    const double seconds = after.uptime_seconds - before.uptime_seconds;
    return seconds <= 0 ? 0 : (after.cpu_seconds - before.cpu_seconds) / seconds;
}

} // namespace

Table jobs_table(const ClusterStatus& status) {
    Table table;
    table.columns = {{"job", "JOB", CellKind::Text},
                     {"name", "NAME", CellKind::Text},
                     {"state", "STATE", CellKind::Text},
                     {"owner", "OWNER", CellKind::Text},
                     {"began", "BEGAN", CellKind::Text},
                     {"scenarios", "SCENARIOS", CellKind::Count},
                     {"done", "DONE", CellKind::Count},
                     {"contact", "CONTACT", CellKind::Count},
                     {"failed", "FAILED", CellKind::Count},
                     {"pairs", "PAIRS", CellKind::Count},
                     {"seconds", "TIME", CellKind::Seconds},
                     {"scenarios_per_second", "RATE", CellKind::Rate},
                     {"digest", "DIGEST", CellKind::Text},
                     {"answered_by_master", "BY MASTER", CellKind::Count, true},
                     {"box_tests", "BOX TESTS", CellKind::Count, true},
                     {"triangle_tests", "TRIANGLE TESTS", CellKind::Count, true},
                     {"past_float", "PAST FLOAT", CellKind::Count, true},
                     {"compute_seconds", "COMPUTE", CellKind::Seconds, true},
                     {"inside_scenarios", "INSIDE?", CellKind::Count, true},
                     {"inside_seconds", "FOR INSIDE", CellKind::Seconds, true},
                     {"withdrawn", "WITHDRAWN", CellKind::Count, true},
                     {"recalled", "RECALLED", CellKind::Count, true},
                     {"copies", "COPIES", CellKind::Count, true},
                     {"copies_won", "COPIES WON", CellKind::Count, true},
                     {"depths", "DEPTHS", CellKind::Text, true},
                     {"master_bytes", "FROM MASTER", CellKind::Size, true},
                     {"peer_bytes", "FROM PEERS", CellKind::Size, true},
                     {"cache_hits", "FOUND", CellKind::Count, true},
                     {"cache_misses", "ASKED FOR", CellKind::Count, true},
                     {"hinted", "AHEAD", CellKind::Count, true},
                     {"evictions", "EVICTED", CellKind::Count, true},
                     {"result_bytes", "RESULTS", CellKind::Size, true},
                     {"failure", "FAILURE", CellKind::Text, true}};
    const std::vector<JobId> ids = ids_of(status.jobs);
    for (const JobStatus& job : status.jobs) {
        table.rows.push_back({job_id_text(job.job, ids),
                              job.name,
                              std::string(job.paused.empty() ? to_text(job.state) : "paused"),
                              job.owner,
                              utc_text(job.began),
                              job.summary.total,
                              job.summary.merged(),
                              contacts_of(job.summary),
                              job.summary.failed,
                              job.summary.pairs,
                              job.seconds,
                              job.scenarios_per_second,
                              job.digest ? to_short_hex(*job.digest) : std::string(),
                              job.answered_by_master,
                              job.statistics.search.box_tests,
                              job.statistics.search.triangle_tests,
                              past_float(job.statistics.search.decisions),
                              job.compute_seconds,
                              job.statistics.inside.scenarios,
                              job.statistics.inside.seconds,
                              job.withdrawn,
                              job.recalled,
                              job.copies,
                              job.copies_won,
                              job.depths,
                              job.traffic.blocks.master_bytes,
                              job.traffic.blocks.peer_bytes,
                              job.traffic.blocks.hits,
                              job.traffic.blocks.misses,
                              job.traffic.blocks.hinted,
                              job.traffic.blocks.evictions,
                              job.traffic.result_bytes,
                              job.failure});
    }
    return table;
}

Table workers_table(const ClusterStatus& status) {
    Table table;
    table.columns = {{"worker", "WORKER", CellKind::Text},
                     {"name", "NAME", CellKind::Text},
                     {"state", "STATE", CellKind::Text},
                     {"threads", "THREADS", CellKind::Count},
                     {"buffered", "BUFFERED", CellKind::Count},
                     {"working", "WORKING", CellKind::Count},
                     {"scenarios", "DONE", CellKind::Count},
                     {"scenarios_per_second", "RATE", CellKind::Rate},
                     {"bytes_sent", "SENT", CellKind::Size},
                     {"bytes_received", "RECEIVED", CellKind::Size},
                     {"cached_bytes", "CACHED", CellKind::Size},
                     {"subtree_bytes_sent", "FROM MASTER", CellKind::Size},
                     {"peer_bytes", "FROM PEERS", CellKind::Size},
                     {"cache_hit_share", "HITS", CellKind::Share},
                     {"cache_bytes", "CACHE", CellKind::Size, true},
                     {"tasks", "TASKS", CellKind::Count, true},
                     {"subtrees_sent", "SUBTREES", CellKind::Count, true},
                     {"uploaded_bytes", "TO PEERS", CellKind::Size, true},
                     {"cache_hits", "FOUND", CellKind::Count, true},
                     {"cache_misses", "ASKED FOR", CellKind::Count, true},
                     {"hinted", "AHEAD", CellKind::Count, true},
                     {"evictions", "EVICTED", CellKind::Count, true}};
    for (const WorkerStatus& worker : status.workers) {
        const BlockTraffic& blocks = worker.cache.blocks;
        table.rows.push_back({worker_name(worker),  worker.name,
                              worker_state(worker), std::uint64_t{worker.threads},
                              worker.buffered,      worker.working,
                              worker.scenarios,     worker.scenarios_per_second,
                              worker.bytes_sent,    worker.bytes_received,
                              worker.cached_bytes,  worker.subtree_bytes_sent,
                              blocks.peer_bytes,    hit_share(blocks),
                              worker.cache_bytes,   worker.tasks,
                              worker.subtrees_sent, worker.cache.uploaded_bytes,
                              blocks.hits,          blocks.misses,
                              blocks.hinted,        blocks.evictions});
    }
    return table;
}

Table meshes_table(const ClusterStatus& status) {
    Table table;
    table.columns = {{"mesh", "MESH", CellKind::Text},
                     {"name", "NAME", CellKind::Text},
                     {"triangles", "TRIANGLES", CellKind::Count},
                     {"bytes", "BYTES", CellKind::Size},
                     {"build_seconds", "TREE BUILT IN", CellKind::Seconds},
                     {"needed", "NEEDED", CellKind::Text},
                     {"sha256", "SHA-256", CellKind::Text, true}};
    for (const MeshStatus& mesh : status.meshes) {
        table.rows.push_back({to_short_hex(mesh.mesh),
                              mesh.name,
                              mesh.triangles,
                              mesh.bytes,
                              mesh.build_seconds,
                              std::string(mesh.is_needed ? "yes" : "no"),
                              to_hex(mesh.mesh)});
    }
    return table;
}

std::string bottleneck_text(const ClusterStatus& before, const ClusterStatus& after) {
    if (count_running(after) == 0) {
        return "none: no job is running";
    }
    if (count_here(after) == 0) {
        return "no worker is connected: start `cdworker --master ...`";
    }
    std::uint64_t idle = 0;
    for (const WorkerStatus& worker : after.workers) {
        idle += worker.state != WorkerState::Lost && worker.working == 0 ? 1u : 0u;
    }
    const std::size_t workers = count_here(after);
    const double master = master_share(before, after);
    const std::string share = cell_text(master, CellKind::Share) + " of a core";
    // The master analyses with several threads, so it may use more than one core.
    if (idle * 2 > workers && master > 0.8) {
        return "the master's processor (" + share + "): it analyses more slowly than " +
               counted(workers, "worker") + " can finish";
    }
    if (idle * 2 > workers) {
        return "too little to do: " + std::to_string(idle) + " of " + counted(workers, "worker") +
               " have nothing (the job is short, or at its end)";
    }
    const double geometry = rate_between(before, after, &WorkerStatus::subtree_bytes_sent);
    const double scenarios = rate_between(before, after, &WorkerStatus::scenarios);
    if (geometry > 0 && scenarios == 0) {
        return "geometry on its way to the workers (" + cell_text(geometry, CellKind::Size) +
               "/s): the caches are filling";
    }
    return "the workers' processors: " + std::to_string(workers - idle) + " of " +
           counted(workers, "worker") + " are busy, more would help (master: " + share + ")";
}

namespace {

/// The reason why jobs are paused; empty if none is.
std::string paused_text(const ClusterStatus& status) {
    for (const JobStatus& job : status.jobs) {
        if (!job.paused.empty()) {
            return job.paused;
        }
    }
    return "";
}

/// Connections and workers lost since the master started; empty if none.
std::string faults_text(const ClusterStatus& status) {
    if (status.workers_lost + status.sessions_resumed == 0) {
        return "";
    }
    return "connections that broke and came back: " + std::to_string(status.sessions_resumed) +
           "   workers lost: " + std::to_string(status.workers_lost) +
           "   scenarios given to others: " + std::to_string(status.scenarios_given_back) + "\n";
}

/// A line with the number and size of all meshes, and of those that no kept job uses.
std::string meshes_text(const std::vector<MeshStatus>& meshes) {
    const auto count = [&](bool with_needed) {
        std::uint64_t bytes = 0;
        std::size_t number = 0;
        for (const MeshStatus& mesh : meshes) {
            const bool counts = with_needed || !mesh.is_needed;
            bytes += counts ? mesh.bytes : 0;
            number += counts ? 1 : 0;
        }
        return std::pair(number, cell_text(bytes, CellKind::Size));
    };
    const auto [all, size] = count(true);
    const auto [unneeded, unneeded_size] = count(false);
    return std::to_string(all) + (all == 1 ? " mesh" : " meshes") + "   " + size +
           (unneeded == 0 ? ""
                          : "   " + std::to_string(unneeded) + " of no job (" + unneeded_size +
                                "): `cdctl rm MESH` removes one") +
           "\n";
}

std::string sizes_text(const StateSizes& sizes) {
    const auto size = [](std::uint64_t bytes) { return cell_text(bytes, CellKind::Size); };
    return "on the master's disk: results " + size(sizes.results) + "   poses " +
           size(sizes.poses) + "   meshes " + size(sizes.meshes) + "   trees " + size(sizes.trees) +
           "   journal " + size(sizes.journal) + "   free " + size(sizes.free) + "\n";
}

/// A line for each scenario that runs for long, each job with withdrawn results, and each job whose
/// scenarios were recalled or copied at the job's end.
std::string long_text(const ClusterStatus& status) {
    const std::vector<JobId> ids = ids_of(status.jobs);
    std::string text;
    for (const JobStatus& job : status.jobs) {
        const std::string id = job_id_text(job.job, ids);
        for (const LongScenario& one : job.long_scenarios) {
            const std::string scenario = std::to_string(one.scenario);
            text += "scenario " + scenario + " of " + id + " runs for " +
                    cell_text(one.seconds, CellKind::Seconds) + " on w-" +
                    std::to_string(one.worker.value) + " (" + one.name + "); `cdctl cancel " + id +
                    " --scenario " + scenario + "` ends it\n";
        }
        if (job.withdrawn != 0) {
            text += counted(job.withdrawn, "result") + " of " + id +
                    " came from a worker in quarantine and were withdrawn\n";
        }
        if (job.recalled != 0 || job.copies != 0) {
            text += "at the end of " + id + " " + counted(job.recalled, "scenario") +
                    " called back from workers that had not begun them, " +
                    std::to_string(job.copies) + " copied; of the copies, " +
                    std::to_string(job.copies_won) + " ended first\n";
        }
    }
    return text;
}

} // namespace

std::string status_text(const ClusterStatus& before, const ClusterStatus& after) {
    const std::size_t running = count_running(after);
    std::string text = "cdmaster " + after.build + "   up " +
                       cell_text(after.uptime_seconds, CellKind::Seconds) + "   processor " +
                       cell_text(after.cpu_seconds, CellKind::Seconds) + "\n";
    text += counted(running, "job") + " running, " + std::to_string(after.jobs.size() - running) +
            " ended\n";
    if (!after.jobs.empty()) {
        text += table_text(jobs_table(after), false, "  ");
    }
    text +=
        counted(count_here(after), "worker") + "   " +
        cell_text(rate_between(before, after, &WorkerStatus::scenarios), CellKind::Rate) +
        "   sent " + cell_text(sum_over_workers(after, &WorkerStatus::bytes_sent), CellKind::Size) +
        "   received " +
        cell_text(sum_over_workers(after, &WorkerStatus::bytes_received), CellKind::Size) + "\n";
    if (!after.workers.empty()) {
        text += table_text(workers_table(after), false, "  ");
    }
    text += faults_text(after) + long_text(after);
    for (const std::string& alarm : after.alarms) {
        text += "ALARM: " + alarm + "\n";
    }
    text += meshes_text(after.meshes) + sizes_text(after.sizes);
    if (const std::string paused = paused_text(after); !paused.empty()) {
        text += "jobs are paused and continue when the disk can be written: " + paused + "\n";
    }
    return text + "bottleneck: " + bottleneck_text(before, after) + "\n";
}

namespace {

nlohmann::ordered_json long_scenarios_json(const ClusterStatus& status) {
    const std::vector<JobId> ids = ids_of(status.jobs);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const JobStatus& job : status.jobs) {
        for (const LongScenario& one : job.long_scenarios) {
            nlohmann::ordered_json entry;
            entry["job"] = job_id_text(job.job, ids);
            entry["scenario"] = one.scenario;
            entry["worker"] = "w-" + std::to_string(one.worker.value);
            entry["name"] = one.name;
            entry["seconds"] = one.seconds;
            list.push_back(std::move(entry));
        }
    }
    return list;
}

} // namespace

std::string status_json(const ClusterStatus& before, const ClusterStatus& after) {
    nlohmann::ordered_json document;
    document["build"] = after.build;
    document["uptime_seconds"] = after.uptime_seconds;
    document["cpu_seconds"] = after.cpu_seconds;
    document["jobs"] = nlohmann::ordered_json::parse(table_json(jobs_table(after)));
    document["workers"] = nlohmann::ordered_json::parse(table_json(workers_table(after)));
    document["meshes"] = nlohmann::ordered_json::parse(table_json(meshes_table(after)));
    document["alarms"] = after.alarms;
    document["alarm_count"] = after.alarm_count;
    document["workers_lost"] = after.workers_lost;
    document["sessions_resumed"] = after.sessions_resumed;
    document["scenarios_given_back"] = after.scenarios_given_back;
    document["state_bytes"] = {{"results", after.sizes.results},
                               {"poses", after.sizes.poses},
                               {"meshes", after.sizes.meshes},
                               {"trees", after.sizes.trees},
                               {"journal", after.sizes.journal},
                               {"free", after.sizes.free}};
    document["long_scenarios"] = long_scenarios_json(after);
    document["paused"] = paused_text(after);
    document["bottleneck"] = bottleneck_text(before, after);
    return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string job_json(const JobStatus& job) {
    ClusterStatus alone;
    alone.jobs.push_back(job);
    const auto list = nlohmann::ordered_json::parse(table_json(jobs_table(alone)));
    return list.front().dump(2) + "\n";
}

} // namespace cd
