#include "web/server/cluster/cluster_source.hpp"

#include "common/core/host/wall_clock.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/timing/web.hpp"
#include "web/status/cluster_report.hpp"
#include "web/status/job_id.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

Result<PagedJob> find_in(const ClusterStatus& cluster, const std::string& id) {
    const std::vector<JobId> ids = ids_of(cluster.jobs);
    const Result<JobId> found = find_job(id, ids);
    if (!found) {
        return found.error();
    }
    const auto job = std::ranges::find(cluster.jobs, found.value(), &JobStatus::job);
    return PagedJob{*job, job_id_text(job->job, ids), cluster.workers.size()};
}

} // namespace

ClusterSource::ClusterSource(ClusterSourceParts parts, PageOrigin origin)
    : parts_(std::move(parts)),
      origin_(std::move(origin)),
      runs_(parts_.executor, parts_.running),
      timer_(parts_.executor) {}

void ClusterSource::close() {
    is_closed_ = true;
    timer_.cancel();
}

void ClusterSource::sample() {
    const std::weak_ptr<const void> alive = alive_;
    parts_.reader.status([this, alive](const Result<ClusterStatus>& now) {
        if (alive.expired() || is_closed_) {
            return;
        }
        if (now) {
            add_sample(now.value());
        }
        timer_.expires_after(timing::history_period);
        timer_.async_wait([this, alive](const auto&) {
            if (!alive.expired() && !is_closed_) {
                sample();
            }
        });
    });
}

void ClusterSource::add_sample(const ClusterStatus& now) {
    const ClusterRates rates = rates_between(last_, now);
    // The first sample has no predecessor.
    if (last_.uptime_seconds > 0) {
        samples_.push_back({static_cast<double>(unix_seconds()),
                            rates.scenarios,
                            rates.sent,
                            rates.received,
                            rates.from_peers});
    }
    if (samples_.size() > limits::history_samples_max) {
        samples_.pop_front();
    }
    last_ = now;
}

template <class T, class Work>
void ClusterSource::read(Take<T> take, Work work) {
    const std::weak_ptr<const void> alive = alive_;
    parts_.reading.post([executor = parts_.executor,
                         alive,
                         take = std::move(take),
                         work = std::move(work)]() mutable {
        const auto found = std::make_shared<Result<T>>(work());
        asio::post(executor, [alive, take = std::move(take), found] {
            if (!alive.expired()) {
                take(std::move(*found));
            }
        });
    });
}

template <class T, class Then>
void ClusterSource::with_job(const std::string& id, Take<T> take, Then then) {
    const std::weak_ptr<const void> alive = alive_;
    parts_.reader.status([alive, id, take = std::move(take), then = std::move(then)](
                             const Result<ClusterStatus>& cluster) mutable {
        if (alive.expired()) {
            return;
        }
        if (!cluster) {
            return take(cluster.error());
        }
        const Result<PagedJob> job = find_in(cluster.value(), id);
        if (!job) {
            return take(job.error());
        }
        then(job.value(), std::move(take));
    });
}

template <class T, class Work>
void ClusterSource::with_records(const std::string& id, Take<T> take, Work work) {
    with_job(id, std::move(take), [this, work = std::move(work)](PagedJob job, Take<T> then) {
        const Result<RecordReader> records = parts_.reader.records(job.status.job, job.scenarios());
        if (!records) {
            return then(records.error());
        }
        read(std::move(then), [work, job = std::move(job), records = records.value()] {
            return work(records, job);
        });
    });
}

void ClusterSource::cluster(Take<ClusterView> take) {
    parts_.reader.status(
        [before = last_, take = std::move(take)](const Result<ClusterStatus>& now) {
            take(now ? Result(ClusterView{before, now.value()}) : now.error());
        });
}

void ClusterSource::history(Take<std::vector<HistorySample>> take) {
    take(std::vector<HistorySample>(samples_.begin(), samples_.end()));
}

void ClusterSource::jobs(Take<std::vector<JobRow>> take) {
    parts_.reader.status([take = std::move(take)](const Result<ClusterStatus>& cluster) {
        if (!cluster) {
            return take(cluster.error());
        }
        const std::vector<JobId> ids = ids_of(cluster.value().jobs);
        std::vector<JobRow> rows;
        for (const JobStatus& job : cluster.value().jobs) {
            rows.push_back({job_id_text(job.job, ids), "", job});
        }
        take(std::move(rows));
    });
}

void ClusterSource::job(const std::string& id, Take<JobView> take) {
    with_job(id, std::move(take), [this](PagedJob job, Take<JobView> then) {
        const ContactMapQuery sums{job.status.job, true};
        parts_.reader.map(sums,
                          [this, alive = std::weak_ptr(alive_), job = std::move(job), then](
                              const Result<ContactMapAnswer>& answer) {
                              if (alive.expired()) {
                                  return;
                              }
                              // Without an answer, the groups are unknown.
                              read(then,
                                   [&reader = parts_.reader,
                                    job,
                                    parts = answer ? answer.value() : ContactMapAnswer()] {
                                       return view_of(reader, job, parts);
                                   });
                          });
    });
}

void ClusterSource::progress(const std::string& id, Take<JobRow> take) {
    with_job(id, std::move(take), [](const PagedJob& job, const Take<JobRow>& then) {
        then(JobRow{job.id, "", job.status});
    });
}

void ClusterSource::classes(const std::string& id,
                            const ScenarioChoice& choice,
                            Take<std::vector<std::uint8_t>> take) {
    with_records(id, std::move(take), [choice](const RecordReader& records, const PagedJob& job) {
        return classes_of(records, job, choice);
    });
}

void ClusterSource::counts(const std::string& id,
                           const ScenarioChoice& choice,
                           Take<std::vector<std::uint32_t>> take) {
    with_records(id, std::move(take), [choice](const RecordReader& records, const PagedJob& job) {
        return counts_of(records, job, choice);
    });
}

void ClusterSource::distances(const std::string& id,
                              const ScenarioChoice& choice,
                              Take<std::vector<double>> take) {
    with_records(id, std::move(take), [choice](const RecordReader& records, const PagedJob& job) {
        return distances_of(records, job, choice);
    });
}

void ClusterSource::poses(const std::string& id,
                          const ScenarioChoice& choice,
                          Take<PoseRows> take) {
    with_job(id, std::move(take), [this, choice](PagedJob job, Take<PoseRows> then) {
        read(std::move(then), [&reader = parts_.reader, choice, job = std::move(job)] {
            return poses_of(reader, job, choice);
        });
    });
}

void ClusterSource::keys(const std::string& id,
                         const ScenarioChoice& choice,
                         Take<std::vector<MotionKeys>> take) {
    using Keys = Take<std::vector<MotionKeys>>;
    with_job(id, std::move(take), [this, choice](PagedJob job, Keys then) {
        read(std::move(then), [&reader = parts_.reader, choice, job = std::move(job)] {
            return motions_of(reader, job, choice);
        });
    });
}

void ClusterSource::bodies(const std::string& id,
                           const ScenarioChoice& choice,
                           Take<std::vector<ScenePlace>> take) {
    using Places = Take<std::vector<ScenePlace>>;
    with_job(id, std::move(take), [this, choice](PagedJob job, Places then) {
        read(std::move(then), [&reader = parts_.reader, choice, job = std::move(job)] {
            return places_of(reader, job, choice);
        });
    });
}

void ClusterSource::steps(const std::string& id,
                          const ScenarioChoice& choice,
                          Take<std::vector<StepRow>> take) {
    using Rows = Take<std::vector<StepRow>>;
    with_job(id, std::move(take), [this, choice](PagedJob job, Rows then) {
        read(std::move(then), [&reader = parts_.reader, choice, job = std::move(job)] {
            return steps_of(reader, job, choice);
        });
    });
}

void ClusterSource::map(const std::string& id,
                        std::uint64_t body,
                        Take<std::vector<TriangleContacts>> take) {
    using Map = Take<std::vector<TriangleContacts>>;
    with_job(id, std::move(take), [this, body](PagedJob job, Map then) {
        const JobId number = job.status.job;
        parts_.reader.map({number},
                          [this, alive = std::weak_ptr(alive_), body, job = std::move(job), then](
                              const Result<ContactMapAnswer>& answer) {
                              if (alive.expired()) {
                                  return;
                              }
                              if (!answer) {
                                  return then(answer.error());
                              }
                              read(then,
                                   [&reader = parts_.reader, job, body, map = answer.value()] {
                                       return map_of(reader, job, map, body);
                                   });
                          });
    });
}

void ClusterSource::parts(const std::string& id,
                          std::uint64_t body,
                          Take<std::shared_ptr<const NamedParts>> take) {
    using Parts = Take<std::shared_ptr<const NamedParts>>;
    with_job(id, std::move(take), [this, body](PagedJob job, Parts then) {
        read(std::move(then), [&reader = parts_.reader, body, job = std::move(job)] {
            return parts_of(reader, job, body);
        });
    });
}

void ClusterSource::closed_parts(const std::string& id,
                                 std::uint64_t body,
                                 Take<std::vector<bool>> take) {
    with_job(id, std::move(take), [this, body](PagedJob job, Take<std::vector<bool>> then) {
        read(std::move(then), [&reader = parts_.reader, body, job = std::move(job)] {
            return closed_parts_of(reader, job, body);
        });
    });
}

void ClusterSource::scenario(const std::string& id,
                             std::uint64_t number,
                             Take<std::shared_ptr<const ScenarioView>> take) {
    if (const Status allowed = parts_.reader.may_run(); !allowed) {
        return take(allowed.error());
    }
    Take<ScenarioInputs> then =
        [this, id, number, take = std::move(take)](const Result<ScenarioInputs>& inputs) {
            run({id, number}, inputs, take);
        };
    with_records(
        id,
        std::move(then),
        [&reader = parts_.reader, number](const RecordReader& records, const PagedJob& job) {
            return inputs_of(reader, records, job, number);
        });
}

void ClusterSource::run(const ScenarioRuns::Key& key,
                        const Result<ScenarioInputs>& inputs,
                        Take<std::shared_ptr<const ScenarioView>> take) {
    if (!inputs) {
        return take(inputs.error());
    }
    auto work = [inputs = inputs.value(), run_max = parts_.run_max, stop = parts_.stop] {
        const auto until = std::chrono::steady_clock::now() + run_max;
        return Result(run_again(
            inputs, [&] { return std::chrono::steady_clock::now() > until || (stop && stop()); }));
    };
    runs_.ask(key, std::move(work), std::move(take));
}

void ClusterSource::next(const std::string& id, const NextContact& wanted, Take<NextFound> take) {
    with_records(
        id,
        std::move(take),
        [&reader = parts_.reader, wanted](const RecordReader& records, const PagedJob& job) {
            return next_of(reader, records, job, wanted);
        });
}

void ClusterSource::mesh(const Sha256& mesh, Take<std::shared_ptr<HttpBody>> take) {
    read(std::move(take), [&reader = parts_.reader, mesh] { return reader.mesh(mesh); });
}

} // namespace cd
