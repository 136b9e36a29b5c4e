#include "web/status/cluster_report.hpp"

#include "common/core/words.hpp"
#include "web/status/growth_text.hpp"
#include "web/status/job_id.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>

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

/// Returns the share, 0 to 1, of needed subtrees that workers had cached; 0 if none was needed.
double hit_share(const BlockTraffic& blocks) {
    const std::uint64_t needed = blocks.hits + blocks.misses;
    return needed == 0 ? 0 : static_cast<double>(blocks.hits) / static_cast<double>(needed);
}

/// Returns a time in UTC: "2026-03-01 12:00:00Z"; empty if the time cannot be converted.
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
        std::ranges::count(status.jobs, JobState::Running, &JobStatus::state));
}

std::size_t count_here(const ClusterStatus& status) {
    const auto lost = std::ranges::count(status.workers, WorkerState::Lost, &WorkerStatus::state);
    return status.workers.size() - static_cast<std::size_t>(lost);
}

std::uint64_t contacts_of(const Summary& summary) {
    return summary.touch + summary.cross + summary.inside + summary.contact;
}

/// Returns the number of triangle pairs that a stage after floats decided.
std::uint64_t past_float(const JobStatus& job) {
    const PairStatistics& decisions = job.statistics.search.decisions;
    return decisions.total() - decisions[PairStage::Float];
}

template <class Member>
std::uint64_t sum_over_workers(const ClusterStatus& status, Member member) {
    std::uint64_t sum = 0;
    for (const WorkerStatus& worker : status.workers) {
        sum += std::invoke(member, worker);
    }
    return sum;
}

/// Returns how much the sum of `member` over all workers grew per second between two statuses; 0 if
/// the sum fell because workers left.
template <class Member>
double rate_between(const ClusterStatus& before, const ClusterStatus& after, Member member) {
    const double seconds = after.uptime_seconds - before.uptime_seconds;
    const std::uint64_t first = sum_over_workers(before, member);
    const std::uint64_t last = sum_over_workers(after, member);
    return seconds <= 0 || last < first ? 0 : static_cast<double>(last - first) / seconds;
}

/// Returns the master's processor time between two statuses, as a share of one core.
double master_share(const ClusterStatus& before, const ClusterStatus& after) {
    const double seconds = after.uptime_seconds - before.uptime_seconds;
    return seconds <= 0 ? 0 : (after.cpu_seconds - before.cpu_seconds) / seconds;
}

} // namespace

ClusterRates rates_between(const ClusterStatus& before, const ClusterStatus& after) {
    const auto from_peers = [](const WorkerStatus& worker) {
        return worker.cache.blocks.peer_bytes;
    };
    return {rate_between(before, after, &WorkerStatus::scenarios),
            rate_between(before, after, &WorkerStatus::bytes_sent),
            rate_between(before, after, &WorkerStatus::bytes_received),
            rate_between(before, after, from_peers)};
}

Table jobs_table(const ClusterStatus& status) {
    using enum CellKind;
    using Job = JobStatus;
    const std::vector<JobId> ids = ids_of(status.jobs);
    const auto state = [](const Job& job) {
        return std::string(job.paused.empty() ? to_text(job.state) : "paused");
    };
    const auto digest = [](const Job& job) { return job.digest ? to_short_hex(*job.digest) : ""; };
    const auto in_search = [](auto member) {
        return [member](const Job& job) { return job.statistics.search.*member; };
    };
    const auto in_effort = [](auto member) {
        return [member](const Job& job) { return job.statistics.search.effort.*member; };
    };
    const auto in_inside = [](auto member) {
        return [member](const Job& job) { return job.statistics.inside.*member; };
    };
    const auto in_blocks = [](auto member) {
        return [member](const Job& job) { return job.traffic.blocks.*member; };
    };
    TableOf<Job> table(status.jobs);
    table.add("job", "JOB", Text, [&](const Job& job) { return job_id_text(job.job, ids); });
    table.add("name", "NAME", Text, &Job::name);
    table.add("state", "STATE", Text, state);
    table.add("owner", "OWNER", Text, [](const Job& job) { return job.turn.owner; });
    table.add("priority", "PRIO", Text, [](const Job& job) { return job.turn.priority; });
    table.add("share", "SHARE", Share, [](const Job& job) { return job.turn.share; });
    table.add("began", "BEGAN", Text, [](const Job& job) { return utc_text(job.began); });
    table.add("scenarios", "SCENARIOS", Count, [](const Job& job) { return job.summary.total; });
    table.add("done", "DONE", Count, [](const Job& job) { return job.summary.merged(); });
    table.add("contact", "CONTACT", Count, [](const Job& job) { return contacts_of(job.summary); });
    table.add("failed", "FAILED", Count, [](const Job& job) { return job.summary.failed; });
    table.add("pairs", "PAIRS", Count, [](const Job& job) { return job.summary.pairs; });
    table.add("seconds", "TIME", Seconds, &Job::seconds);
    table.add("scenarios_per_second", "RATE", Rate, &Job::scenarios_per_second);
    table.add("digest", "DIGEST", Text, digest);
    table.add_wide("near", "NEAR", Count, [](const Job& job) { return job.summary.near; });
    table.add_wide(
        "near_pairs", "NEAR PAIRS", Count, [](const Job& job) { return job.summary.near_pairs; });
    table.add_wide("answered_by_master", "BY MASTER", Count, &Job::answered_by_master);
    table.add_wide("box_tests", "BOX TESTS", Count, in_search(&QueryStatistics::box_tests));
    table.add_wide(
        "triangle_tests", "TRIANGLE TESTS", Count, in_search(&QueryStatistics::triangle_tests));
    table.add_wide("past_float", "PAST FLOAT", Count, past_float);
    table.add_wide("cells", "CELLS", Count, in_effort(&SearchEffort::cells));
    table.add_wide("leaves", "LEAVES", Count, in_effort(&SearchEffort::leaves));
    table.add_wide("roots_named", "ROOTS NAMED", Count, in_effort(&SearchEffort::roots_named));
    table.add_wide("roots_used", "ROOTS USED", Count, in_effort(&SearchEffort::roots_used));
    table.add_wide("compute_seconds", "COMPUTE", Seconds, &Job::compute_seconds);
    table.add_wide("inside_scenarios", "INSIDE?", Count, in_inside(&InsideStatistics::scenarios));
    table.add_wide("inside_seconds", "FOR INSIDE", Seconds, in_inside(&InsideStatistics::seconds));
    table.add_wide("withdrawn", "WITHDRAWN", Count, &Job::withdrawn);
    table.add_wide("recalled", "RECALLED", Count, &Job::recalled);
    table.add_wide("copies", "COPIES", Count, &Job::copies);
    table.add_wide("copies_won", "COPIES WON", Count, &Job::copies_won);
    table.add_wide("depths", "DEPTHS", Text, &Job::depths);
    table.add_wide("master_bytes", "FROM MASTER", Size, in_blocks(&BlockTraffic::master_bytes));
    table.add_wide("peer_bytes", "FROM PEERS", Size, in_blocks(&BlockTraffic::peer_bytes));
    table.add_wide("cache_hits", "FOUND", Count, in_blocks(&BlockTraffic::hits));
    table.add_wide("cache_misses", "ASKED FOR", Count, in_blocks(&BlockTraffic::misses));
    table.add_wide("hinted", "AHEAD", Count, in_blocks(&BlockTraffic::hinted));
    table.add_wide("evictions", "EVICTED", Count, in_blocks(&BlockTraffic::evictions));
    table.add_wide(
        "result_bytes", "RESULTS", Size, [](const Job& job) { return job.traffic.result_bytes; });
    table.add_wide("failure", "FAILURE", Text, &Job::failure);
    return table.take();
}

Table workers_table(const ClusterStatus& status) {
    using enum CellKind;
    using Worker = WorkerStatus;
    const auto in_blocks = [](auto member) {
        return [member](const Worker& worker) { return worker.cache.blocks.*member; };
    };
    TableOf<Worker> table(status.workers);
    table.add("worker", "WORKER", Text, worker_name);
    table.add("name", "NAME", Text, &Worker::name);
    table.add("state", "STATE", Text, worker_state);
    table.add("threads", "THREADS", Count, &Worker::threads);
    table.add("buffered", "BUFFERED", Count, &Worker::buffered);
    table.add("working", "WORKING", Count, &Worker::working);
    table.add("scenarios", "DONE", Count, &Worker::scenarios);
    table.add("scenarios_per_second", "RATE", Rate, &Worker::scenarios_per_second);
    table.add("bytes_sent", "SENT", Size, &Worker::bytes_sent);
    table.add("bytes_received", "RECEIVED", Size, &Worker::bytes_received);
    table.add("cached_bytes", "CACHED", Size, &Worker::cached_bytes);
    table.add("subtree_bytes_sent", "FROM MASTER", Size, &Worker::subtree_bytes_sent);
    table.add("peer_bytes", "FROM PEERS", Size, in_blocks(&BlockTraffic::peer_bytes));
    table.add("cache_hit_share", "HITS", Share, [](const Worker& worker) {
        return hit_share(worker.cache.blocks);
    });
    table.add_wide("cache_bytes", "CACHE", Size, &Worker::cache_bytes);
    table.add_wide("tasks", "TASKS", Count, &Worker::tasks);
    table.add_wide("subtrees_sent", "SUBTREES", Count, &Worker::subtrees_sent);
    table.add_wide("uploaded_bytes", "TO PEERS", Size, [](const Worker& worker) {
        return worker.cache.uploaded_bytes;
    });
    table.add_wide("cache_hits", "FOUND", Count, in_blocks(&BlockTraffic::hits));
    table.add_wide("cache_misses", "ASKED FOR", Count, in_blocks(&BlockTraffic::misses));
    table.add_wide("hinted", "AHEAD", Count, in_blocks(&BlockTraffic::hinted));
    table.add_wide("evictions", "EVICTED", Count, in_blocks(&BlockTraffic::evictions));
    return table.take();
}

Table meshes_table(const ClusterStatus& status) {
    using enum CellKind;
    TableOf<MeshStatus> table(status.meshes);
    table.add("mesh", "MESH", Text, [](const MeshStatus& mesh) { return to_short_hex(mesh.mesh); });
    table.add("name", "NAME", Text, &MeshStatus::name);
    table.add("triangles", "TRIANGLES", Count, &MeshStatus::triangles);
    table.add("bytes", "BYTES", Size, &MeshStatus::bytes);
    table.add("build_seconds", "TREE BUILT IN", Seconds, &MeshStatus::build_seconds);
    table.add("needed", "NEEDED", Text, [](const MeshStatus& mesh) {
        return mesh.is_needed ? "yes" : "no";
    });
    table.add_wide(
        "sha256", "SHA-256", Text, [](const MeshStatus& mesh) { return to_hex(mesh.mesh); });
    return table.take();
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
    // The master's share may exceed one core, since it analyses with several threads.
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

/// Returns why jobs are paused; empty if none is.
std::string paused_text(const ClusterStatus& status) {
    for (const JobStatus& job : status.jobs) {
        if (!job.paused.empty()) {
            return job.paused;
        }
    }
    return "";
}

/// Reports the connections and workers lost since the master started; empty if none.
std::string faults_text(const ClusterStatus& status) {
    if (status.losses.workers_lost + status.losses.sessions_resumed == 0) {
        return "";
    }
    return "connections that broke and came back: " +
           std::to_string(status.losses.sessions_resumed) +
           "   workers lost: " + std::to_string(status.losses.workers_lost) +
           "   scenarios given to others: " + std::to_string(status.losses.scenarios_given_back) +
           "\n";
}

/// Returns a line with the number and size of all meshes and of the meshes that no kept job uses.
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

/// Returns a line for each scenario that runs for long, for each job with withdrawn results, and
/// for each job whose scenarios were recalled or copied at its end.
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
    text += growth_text(after.growth);
    return text + "bottleneck: " + bottleneck_text(before, after) + "\n";
}

namespace {

nlohmann::ordered_json long_scenarios_json(const ClusterStatus& status) {
    const std::vector<JobId> ids = ids_of(status.jobs);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const JobStatus& job : status.jobs) {
        for (const LongScenario& one : job.long_scenarios) {
            list.push_back({{"job", job_id_text(job.job, ids)},
                            {"scenario", one.scenario},
                            {"worker", "w-" + std::to_string(one.worker.value)},
                            {"name", one.name},
                            {"seconds", one.seconds}});
        }
    }
    return list;
}

/// Returns the table of workers, with each one's longest-running scenario.
nlohmann::ordered_json workers_json(const ClusterStatus& status) {
    const std::vector<JobId> ids = ids_of(status.jobs);
    nlohmann::ordered_json list = table_json(workers_table(status));
    for (std::size_t i = 0; i < status.workers.size(); ++i) {
        list[i]["longest"] = nlohmann::ordered_json();
        if (const auto& longest = status.workers[i].longest) {
            list[i]["longest"] = {{"job", job_id_text(longest->job, ids)},
                                  {"scenario", longest->scenario},
                                  {"seconds", longest->seconds}};
        }
    }
    return list;
}

} // namespace

std::string status_json(const ClusterStatus& before, const ClusterStatus& after) {
    return json_text({{"build", after.build},
                      {"uptime_seconds", after.uptime_seconds},
                      {"cpu_seconds", after.cpu_seconds},
                      {"jobs", table_json(jobs_table(after))},
                      {"workers", workers_json(after)},
                      {"meshes", table_json(meshes_table(after))},
                      {"alarms", after.alarms},
                      {"alarm_count", after.alarm_count},
                      {"workers_lost", after.losses.workers_lost},
                      {"sessions_resumed", after.losses.sessions_resumed},
                      {"scenarios_given_back", after.losses.scenarios_given_back},
                      {"state_bytes",
                       {{"results", after.sizes.results},
                        {"poses", after.sizes.poses},
                        {"meshes", after.sizes.meshes},
                        {"trees", after.sizes.trees},
                        {"journal", after.sizes.journal},
                        {"free", after.sizes.free}}},
                      {"long_scenarios", long_scenarios_json(after)},
                      {"paused", paused_text(after)},
                      {"more_workers", growth_json(after.growth)},
                      {"bottleneck", bottleneck_text(before, after)}});
}

std::string job_json(const JobStatus& job) {
    ClusterStatus alone;
    alone.jobs.push_back(job);
    return json_text(table_json(jobs_table(alone)).front());
}

} // namespace cd
