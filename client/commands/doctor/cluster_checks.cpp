#include "client/commands/doctor/cluster_checks.hpp"

#include "common/core/timing/client.hpp"
#include "common/core/timing/wire.hpp"
#include "common/core/version.hpp"
#include "common/core/words.hpp"
#include "web/status/job_id.hpp"
#include "web/status/table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace cd {

namespace {

using Grade = Finding::Grade;

/// Below this, a job may fill the master's disk at once.
constexpr std::uint64_t disk_bytes_min = 1u << 30;
/// Below this share of the disk, the doctor warns.
constexpr double disk_share_min = 0.1;
/// The status and the metrics of one master are read within this time.
constexpr double uptime_difference_max = 30;

double since_1970(std::chrono::system_clock::time_point time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

std::string worker_text(const WorkerStatus& worker) {
    return "w-" + std::to_string(worker.worker.value) + " " + worker.name;
}

/// Returns the one sample of a metric for each worker, by the worker's number.
std::map<std::string, const MetricSample*> by_worker(const MasterMetrics& metrics,
                                                     std::string_view name) {
    std::map<std::string, const MetricSample*> found;
    for (const MetricSample* const sample : metrics.all(name)) {
        found.emplace(sample->label("worker"), sample);
    }
    return found;
}

/// Returns what is wrong with a worker by its status; nothing if it is well.
std::optional<Finding> state_finding(const WorkerStatus& worker) {
    Finding finding{Grade::Warn, "workers", worker_text(worker)};
    if (worker.quarantined) {
        finding.grade = Grade::Fail;
        finding.text += ": it gave a wrong result and gets no more work; test its host's memory, "
                        "processor and build";
    } else if (worker.state == WorkerState::Silent) {
        finding.text += ": silent for " + fixed_text(worker.silent_seconds, 0) +
                        " s; others get its work if that lasts";
    } else if (worker.state == WorkerState::Lost) {
        finding.text += ": lost; others do its work. Look at its host";
    } else {
        return std::nullopt;
    }
    return finding;
}

void add_versions(const ClusterFacts& facts, std::vector<Finding>& findings) {
    const auto versions = by_worker(*facts.metrics, "cdcluster_worker_info");
    for (const WorkerStatus& worker : facts.status.workers) {
        const auto found = versions.find(std::to_string(worker.worker.value));
        if (found != versions.end() && found->second->label("version") != facts.status.build) {
            findings.push_back({Grade::Fail,
                                "workers",
                                worker_text(worker) + ": version " +
                                    found->second->label("version") + ", the master " +
                                    facts.status.build + ": upgrade it"});
        }
    }
}

void add_ports(const ClusterFacts& facts, std::vector<Finding>& findings) {
    const auto ports = by_worker(*facts.metrics, "cdcluster_worker_peer_reachable");
    for (const WorkerStatus& worker : facts.status.workers) {
        const auto found = ports.find(std::to_string(worker.worker.value));
        if (found != ports.end() && found->second->value == 0) {
            findings.push_back({Grade::Warn,
                                "workers",
                                worker_text(worker) + ": others cannot reach its port " +
                                    found->second->label("port") +
                                    " (firewall?), so the master serves"});
        }
    }
}

/// Returns the clock's difference for people, with a grade; nothing if it is unknown.
std::optional<std::pair<Grade, std::string>> clock_text(const ClusterFacts& facts) {
    const auto ahead = clock_ahead(facts);
    if (!ahead) {
        return std::nullopt;
    }
    const double size = std::abs(*ahead);
    const auto limit = [](std::chrono::seconds time) { return static_cast<double>(time.count()); };
    const Grade grade = size > limit(timing::clock_difference_max)          ? Grade::Fail
                        : size > limit(timing::doctor_clock_difference_max) ? Grade::Warn
                                                                            : Grade::Ok;
    std::string text =
        std::string("clock ") + (*ahead < 0 ? "-" : "+") + fixed_text(size, 1) + " s";
    if (grade != Grade::Ok) {
        text += ": set the clocks by NTP, since certificates have times";
    }
    return std::pair(grade, std::move(text));
}

} // namespace

bool is_of_master(const MasterMetrics& metrics, const ClusterStatus& status) {
    const auto uptime = metrics.value("cdcluster_uptime_seconds");
    return uptime && std::abs(*uptime - status.uptime_seconds) < uptime_difference_max;
}

std::optional<double> clock_ahead(const ClusterFacts& facts) {
    if (facts.metrics) {
        if (const auto time = facts.metrics->value("cdcluster_time_seconds")) {
            return *time - since_1970(facts.metrics_time);
        }
    }
    for (const JobStatus& job : facts.status.jobs) {
        // Of an older job the master does not count the time in which it was down.
        if (job.state == JobState::Running && job.seconds < facts.status.uptime_seconds) {
            // The time of acceptance is a whole second, cut off.
            return static_cast<double>(job.began) + 0.5 + job.seconds -
                   since_1970(facts.status_time);
        }
    }
    return std::nullopt;
}

Finding master_finding(const ClusterFacts& facts) {
    Finding finding{Grade::Ok, "master", facts.address + ", version " + facts.status.build};
    const bool is_same_version = facts.status.build == version;
    finding.text += is_same_version ? " as here" : ", here " + std::string(version);
    finding.text += std::string(facts.is_tls ? ", TLS" : ", no TLS") + ", you are `" + facts.owner +
                    "`" + (facts.role.empty() ? "" : " (" + facts.role + ")");
    if (!is_same_version) {
        finding.grade = Grade::Warn;
        finding.text += "; install the same release on both";
    }
    if (!facts.is_tls && !facts.is_loopback) {
        finding.grade = Grade::Warn;
        finding.text += "; anyone on the network may read and change what is sent: `cdmaster init` "
                        "and `cdctl join` secure it";
    }
    if (const auto clock = clock_text(facts)) {
        finding.grade = std::max(finding.grade, clock->first);
        finding.text += ", " + clock->second;
    }
    return finding;
}

std::vector<Finding> worker_findings(const ClusterFacts& facts) {
    std::vector<Finding> findings;
    std::uint64_t here = 0;
    for (const WorkerStatus& worker : facts.status.workers) {
        here += worker.state != WorkerState::Lost ? 1u : 0u;
        if (auto finding = state_finding(worker)) {
            findings.push_back(*std::move(finding));
        }
    }
    if (here == 0) {
        findings.push_back(
            {Grade::Warn, "workers", "none is here: start cdworker --master " + facts.address});
    }
    if (facts.metrics) {
        add_versions(facts, findings);
        add_ports(facts, findings);
    }
    if (findings.empty()) {
        findings.push_back(
            {Grade::Ok,
             "workers",
             counted(here, "worker") +
                 (facts.metrics
                      ? ", version " + facts.status.build + ", each can be reached by the others"
                      : "; their versions and ports are unknown: " + facts.no_metrics)});
    }
    return findings;
}

std::vector<Finding> job_findings(const ClusterFacts& facts) {
    std::vector<Finding> findings;
    for (const JobStatus& job : facts.status.jobs) {
        if (!job.paused.empty()) {
            const std::string id = job_id_text(job.job, ids_of(facts.status.jobs));
            findings.push_back({Grade::Fail, "jobs", id + " is paused: " + job.paused});
        }
    }
    if (facts.status.alarm_count != 0) {
        findings.push_back(
            {Grade::Warn,
             "alarms",
             counted(facts.status.alarm_count, "alarm") +
                 (facts.status.alarms.empty() ? "" : ", the last: " + facts.status.alarms.back())});
    }
    return findings;
}

Finding disk_finding(const ClusterFacts& facts) {
    const std::uint64_t free = facts.status.sizes.free;
    const auto total =
        facts.metrics ? facts.metrics->value("cdcluster_state_total_bytes") : std::nullopt;
    Finding finding{Grade::Ok,
                    "disk",
                    "master has " + cell_text(free, CellKind::Size) +
                        (total ? " of " + cell_text(*total, CellKind::Size) : "") +
                        " for its state"};
    if (free < disk_bytes_min) {
        finding.grade = Grade::Fail;
    } else if (total && static_cast<double>(free) < disk_share_min * *total) {
        finding.grade = Grade::Warn;
    }
    if (finding.grade != Grade::Ok) {
        finding.text += "; `cdctl rm` and cdmaster --keep-jobs make room";
    }
    return finding;
}

} // namespace cd
