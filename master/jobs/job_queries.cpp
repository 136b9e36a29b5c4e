#include "master/jobs/job_queries.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/job/packed_scenarios.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/submission/label_spool.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Opens a job's labels; null if it has none.
Result<std::unique_ptr<LabelSpool>> open_labels(const Submit& submit,
                                                const std::filesystem::path& path) {
    return submit.poses.labels.is_empty()
               ? Result<std::unique_ptr<LabelSpool>>(nullptr)
               : LabelSpool::open(path, submit.poses.labels, submit.scenarios);
}

Status add_labels(LabelSpool* spool, std::uint64_t first, std::uint64_t count, PoseLabels& labels) {
    if (spool == nullptr) {
        return Done{};
    }
    const Result<PoseLabels> read = spool->read(first, count);
    if (!read) {
        return read.error();
    }
    labels.append(read.value());
    return Done{};
}

} // namespace

Result<JobDescription> JobQueries::description(JobId job) const {
    Result<JobRecord> record = journal_.job(job);
    if (!record) {
        return record.error();
    }
    return JobDescription{job, record.value().began, std::move(record.value().submit)};
}

Result<MeshBytes> JobQueries::mesh(const MeshQuery& query) const {
    return geometry_.read(query.mesh, query.offset, limits::mesh_answer_bytes);
}

Result<LabelledScenarios> JobQueries::scenarios(const PosesQuery& query) const {
    const Result<JobRecord> record = journal_.job(query.job);
    if (!record) {
        return record.error();
    }
    const Submit& submit = record.value().submit;
    const std::uint64_t places = query.sample == 0 ? submit.scenarios : query.sample;
    if (query.first >= places || query.count == 0 || query.count > places - query.first) {
        return Error{ErrorCode::BadInput,
                     "poses of " + std::to_string(query.count) + " scenarios from " +
                         std::to_string(query.first) + " on; the job has " +
                         std::to_string(submit.scenarios)};
    }
    const auto source = open_poses(submit, journal_.poses_path(query.job), PoseCheck::AsRead);
    if (!source) {
        return source.error();
    }
    const auto labels = open_labels(submit, journal_.labels_path(query.job));
    if (!labels) {
        return labels.error();
    }
    LabelledScenarios found;
    const std::uint64_t step = query.sample == 0 ? query.count : 1;
    for (std::uint64_t place = query.first; place < query.first + query.count; place += step) {
        const std::uint64_t first = sampled_scenario(place, query.sample, submit.scenarios);
        const auto read = source.value()->read_submitted(first, step);
        if (!read) {
            return read.error();
        }
        found.scenarios.insert(found.scenarios.end(), read.value().begin(), read.value().end());
        if (const Status added = add_labels(labels.value().get(), first, step, found.labels);
            !added) {
            return added.error();
        }
    }
    return found;
}

Result<JobPoses> JobQueries::poses(const PosesQuery& query) const {
    PosesQuery part = query;
    part.count = std::min(query.count,
                          query.sample == 0 ? limits::poses_answer_scenarios
                                            : limits::sampled_poses_answer_max);
    Result<LabelledScenarios> read = scenarios(part);
    if (!read) {
        return read.error();
    }
    return JobPoses{query.job,
                    query.first,
                    part.count,
                    pack_scenarios(read.value().scenarios),
                    std::move(read.value().labels)};
}

} // namespace cd
