#include "master/net/metrics.hpp"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include <algorithm>
#include <concepts>
#include <functional>
#include <limits>
#include <vector>

namespace cd {

namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;
using Labels = std::vector<ClientMetric::Label>;

class Page {
  public:
    /// Starts a metric family; later calls of `add` add samples to it.
    void family(MetricType type, const std::string& name, const std::string& help) {
        families_.push_back({"cdcluster_" + name, help, type, {}});
    }
    template <class Number>
    void add(Number number, Labels labels = {}) {
        ClientMetric metric;
        metric.label = std::move(labels);
        const auto value = static_cast<double>(number);
        if (families_.back().type == MetricType::Counter) {
            metric.counter.value = value;
        } else {
            metric.gauge.value = value;
        }
        families_.back().metric.push_back(std::move(metric));
    }
    void
    histogram(const std::string& name, const std::string& help, const CommitTimes::Counts& of) {
        family(MetricType::Histogram, name, help);
        ClientMetric metric;
        for (std::size_t i = 0; i < of.commits.size(); ++i) {
            metric.histogram.sample_count += of.commits[i];
            const bool is_last = i == CommitTimes::bounds.size();
            metric.histogram.bucket.push_back(
                {metric.histogram.sample_count,
                 is_last ? std::numeric_limits<double>::infinity() : CommitTimes::bounds[i]});
        }
        metric.histogram.sample_sum = of.seconds;
        families_.back().metric.push_back(std::move(metric));
    }
    template <class Number>
    void one(MetricType type, const std::string& name, const std::string& help, Number number) {
        family(type, name, help);
        add(number);
    }
    [[nodiscard]] std::string text() const {
        return prometheus::TextSerializer().Serialize(families_);
    }

  private:
    std::vector<MetricFamily> families_;
};

constexpr MetricType counter = MetricType::Counter;
constexpr MetricType gauge = MetricType::Gauge;

void add_master(Page& page, const ClusterStatus& status) {
    page.family(gauge, "build_info", "1; the label is the master's version.");
    page.add(1, {{"version", status.build}});
    page.one(gauge, "uptime_seconds", "Time since the master started.", status.uptime_seconds);
    page.one(counter,
             "master_cpu_seconds_total",
             "Processor time of the master, user and system.",
             status.cpu_seconds);
    page.one(counter,
             "alarms_total",
             "Alarms raised; each needs an operator's attention.",
             status.alarm_count);
    page.one(counter,
             "workers_lost_total",
             "Workers lost; other workers got their scenarios.",
             status.losses.workers_lost);
    page.one(counter,
             "sessions_resumed_total",
             "Sessions of workers that went on over a new connection.",
             status.losses.sessions_resumed);
    page.one(counter,
             "scenarios_given_back_total",
             "Unanswered scenarios of lost workers, queued again.",
             status.losses.scenarios_given_back);
    page.one(gauge, "meshes", "Meshes stored by the master.", status.meshes.size());
}

void add_workers(Page& page, const std::vector<WorkerStatus>& workers) {
    page.family(gauge, "workers", "Workers by state of their connection.");
    for (const WorkerState state : {WorkerState::Alive, WorkerState::Silent, WorkerState::Lost}) {
        page.add(std::ranges::count(workers, state, &WorkerStatus::state),
                 {{"state", std::string(to_text(state))}});
    }
    page.one(gauge,
             "workers_quarantined",
             "Workers excluded after a wrong result.",
             std::ranges::count(workers, true, &WorkerStatus::quarantined));

    const auto each =
        [&](MetricType type, const std::string& name, const std::string& help, auto number) {
            page.family(type, "worker_" + name, help);
            for (const WorkerStatus& worker : workers) {
                page.add(std::invoke(number, worker),
                         {{"worker", std::to_string(worker.worker.value)}, {"name", worker.name}});
            }
        };
    each(gauge, "threads", "Threads that run scenarios.", &WorkerStatus::threads);
    each(counter, "scenarios_total", "Scenarios answered.", &WorkerStatus::scenarios);
    each(gauge, "scenarios_working", "Scenarios sent and not answered.", &WorkerStatus::working);
    each(gauge,
         "scenarios_buffered",
         "Scenarios that will be sent to the worker.",
         &WorkerStatus::buffered);
    each(gauge, "silent_seconds", "Time since the last message.", &WorkerStatus::silent_seconds);
    each(gauge, "cache_limit_bytes", "Limit of the subtree cache.", &WorkerStatus::cache_bytes);
    each(gauge, "cached_bytes", "Bytes in the subtree cache.", &WorkerStatus::cached_bytes);
    each(counter, "sent_bytes_total", "Bytes sent to the worker.", &WorkerStatus::bytes_sent);
    each(counter,
         "received_bytes_total",
         "Bytes received from the worker.",
         &WorkerStatus::bytes_received);
    each(counter,
         "block_hits_total",
         "Blocks needed that were cached.",
         [](const WorkerStatus& worker) { return worker.cache.blocks.hits; });
    each(counter,
         "block_misses_total",
         "Blocks needed that were requested.",
         [](const WorkerStatus& worker) { return worker.cache.blocks.misses; });
    each(counter,
         "block_evictions_total",
         "Blocks evicted for lack of room.",
         [](const WorkerStatus& worker) { return worker.cache.blocks.evictions; });
    each(counter,
         "block_master_bytes_total",
         "Bytes of blocks from the master.",
         [](const WorkerStatus& worker) { return worker.cache.blocks.master_bytes; });
    each(counter,
         "block_peer_bytes_total",
         "Bytes of blocks from other workers.",
         [](const WorkerStatus& worker) { return worker.cache.blocks.peer_bytes; });
}

void add_jobs(Page& page, const std::vector<JobStatus>& jobs) {
    page.family(gauge, "jobs", "Jobs that the master keeps, by state.");
    for (const JobState state :
         {JobState::Running, JobState::Done, JobState::Cancelled, JobState::Failed}) {
        page.add(std::ranges::count(jobs, state, &JobStatus::state),
                 {{"state", std::string(to_text(state))}});
    }
    page.one(gauge,
             "jobs_paused",
             "Running jobs that wait, for example for room on the disk.",
             std::ranges::count_if(jobs, [](const JobStatus& job) { return !job.paused.empty(); }));

    const auto each = [&](const std::string& name, const std::string& help, auto number) {
        page.family(gauge, "job_" + name, help);
        for (const JobStatus& job : jobs) {
            if (job.state == JobState::Running) {
                page.add(number(job), {{"job", std::to_string(job.job.value)}, {"name", job.name}});
            }
        }
    };
    each("scenarios", "Scenarios of a running job.", [](const JobStatus& job) {
        return job.summary.total;
    });
    each("scenarios_done", "Scenarios with a result.", [](const JobStatus& job) {
        return job.summary.merged();
    });
    each("scenarios_failed", "Scenarios that failed.", [](const JobStatus& job) {
        return job.summary.failed;
    });
    each("results_withdrawn",
         "Results of quarantined workers that were withdrawn.",
         [](const JobStatus& job) { return job.withdrawn; });
    each("compute_seconds", "Time of the workers' threads.", [](const JobStatus& job) {
        return job.compute_seconds;
    });
}

void add_writing(Page& page, const StateSizes& sizes, const MasterFigures& figures) {
    page.one(counter,
             "scenarios_total",
             "Scenarios whose result was handed to the journal; a withdrawn result counts, too.",
             figures.written.results);
    page.one(counter, "results_bytes_total", "Bytes of these results.", figures.written.bytes);
    page.histogram("journal_commit_seconds",
                   "Time of a commit of the journal, until it is on the disk.",
                   figures.commits);
    if (figures.disk_bytes != 0) {
        page.one(gauge,
                 "state_free_bytes",
                 "Room on the file system of the state directory.",
                 sizes.free);
        page.one(gauge,
                 "state_total_bytes",
                 "Size of the file system of the state directory.",
                 figures.disk_bytes);
    }
    if (figures.certificate_until) {
        page.one(gauge,
                 "certificate_expires_timestamp_seconds",
                 "End of the master's certificate, which it renews before.",
                 *figures.certificate_until);
    }
    page.one(gauge, "time_seconds", "The master's clock, in seconds since 1970.", figures.now);
    page.family(counter, "http_requests_total", "HTTP requests answered, by status code.");
    for (const auto& [code, number] : figures.http_answers) {
        page.add(number, {{"code", std::to_string(code)}});
    }
}

/// The names are those of Prometheus' own libraries, after the prefix.
void add_process(Page& page, const ProcessFigures& process, double cpu_seconds) {
    const auto add = [&](MetricType type, const char* name, const char* help, auto number) {
        page.one(type, std::string("process_") + name, help, number);
    };
    add(counter, "cpu_seconds_total", "Processor time, user and system.", cpu_seconds);
    add(gauge, "start_time_seconds", "Start, in seconds since 1970.", process.started);
    add(gauge, "resident_memory_bytes", "Memory in use.", process.resident_bytes);
    add(gauge, "virtual_memory_bytes", "Memory that is mapped.", process.virtual_bytes);
    add(gauge, "threads", "Threads of the process.", process.threads);
    add(gauge, "open_fds", "Open file descriptors.", process.open_files);
    add(gauge, "max_fds", "Most file descriptors that may be open.", process.open_files_max);
}

void add_worker_figures(Page& page, const std::vector<WorkerFigures>& workers) {
    const auto labels = [](const WorkerFigures& worker) {
        return Labels{{"worker", std::to_string(worker.worker.value)}, {"name", worker.name}};
    };
    page.family(gauge, "worker_info", "1; the label is the version of the worker's program.");
    for (const WorkerFigures& worker : workers) {
        Labels all = labels(worker);
        all.push_back({"version", worker.build});
        page.add(1, std::move(all));
    }
    page.family(gauge,
                "worker_peer_reachable",
                "0 if others cannot reach the port at which the worker serves geometry.");
    for (const WorkerFigures& worker : workers) {
        if (worker.peers) {
            Labels all = labels(worker);
            all.push_back({"port", std::to_string(worker.peers->port)});
            page.add(worker.peers->is_reachable ? 1 : 0, std::move(all));
        }
    }
}

} // namespace

std::string metrics_text(const ClusterStatus& status, const MasterFigures& figures) {
    Page page;
    add_writing(page, status.sizes, figures);
    add_process(page, figures.process, status.cpu_seconds);
    add_worker_figures(page, figures.workers);
    add_master(page, status);
    add_workers(page, status.workers);
    add_jobs(page, status.jobs);
    return page.text();
}

} // namespace cd
