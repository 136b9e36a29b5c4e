#include "master/jobs/job_queries.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "master/jobs/job_geometry.hpp"

#include <algorithm>
#include <utility>

namespace cd {

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

Status JobQueries::open(JobId job) {
    if (open_ && open_->job == job) {
        return Done{};
    }
    open_.reset();
    const Result<JobRecord> record = journal_.job(job);
    if (!record) {
        return record.error();
    }
    const Submit& submit = record.value().submit;
    Result<std::shared_ptr<PoseSource>> poses = open_poses(submit, journal_.poses_path(job));
    if (!poses) {
        return poses.error();
    }
    OpenJob opened{job, std::move(poses.value()), nullptr};
    if (!submit.poses.labels.is_empty()) {
        auto labels =
            LabelSpool::open(journal_.labels_path(job), submit.poses.labels, submit.scenarios);
        if (!labels) {
            return labels.error();
        }
        opened.labels = std::move(labels.value());
    }
    open_ = std::move(opened);
    return Done{};
}

Result<JobPoses> JobQueries::poses(const PosesQuery& query) {
    if (const Status opened = open(query.job); !opened) {
        return opened.error();
    }
    const std::uint64_t count = open_->poses->count();
    if (query.first >= count || query.count == 0 || query.count > count - query.first) {
        return Error{ErrorCode::BadInput,
                     "poses of " + std::to_string(query.count) + " scenarios from " +
                         std::to_string(query.first) + " on; the job has " + std::to_string(count)};
    }
    JobPoses answer;
    answer.job = query.job;
    answer.first = query.first;
    answer.count = std::min(query.count, limits::poses_answer_scenarios);
    const auto scenarios = open_->poses->read(answer.first, answer.count);
    if (!scenarios) {
        return scenarios.error();
    }
    answer.scenarios = pack_scenarios(scenarios.value());
    if (open_->labels != nullptr) {
        Result<PoseLabels> labels = open_->labels->read(answer.first, answer.count);
        if (!labels) {
            return labels.error();
        }
        answer.labels = std::move(labels.value());
    }
    return answer;
}

} // namespace cd
