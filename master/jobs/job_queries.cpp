#include "master/jobs/job_queries.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/job/packed_scenarios.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/submission/label_spool.hpp"

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

Result<JobPoses> JobQueries::poses(const PosesQuery& query) const {
    const Result<JobRecord> record = journal_.job(query.job);
    if (!record) {
        return record.error();
    }
    const Submit& submit = record.value().submit;
    if (query.first >= submit.scenarios || query.count == 0 ||
        query.count > submit.scenarios - query.first) {
        return Error{ErrorCode::BadInput,
                     "poses of " + std::to_string(query.count) + " scenarios from " +
                         std::to_string(query.first) + " on; the job has " +
                         std::to_string(submit.scenarios)};
    }
    JobPoses answer;
    answer.job = query.job;
    answer.first = query.first;
    answer.count = std::min(query.count, limits::poses_answer_scenarios);
    const auto source = open_poses(submit, journal_.poses_path(query.job), PoseCheck::AsRead);
    if (!source) {
        return source.error();
    }
    const auto scenarios = source.value()->read_submitted(answer.first, answer.count);
    if (!scenarios) {
        return scenarios.error();
    }
    answer.scenarios = pack_scenarios(scenarios.value());
    if (!submit.poses.labels.is_empty()) {
        const auto spool = LabelSpool::open(
            journal_.labels_path(query.job), submit.poses.labels, submit.scenarios);
        if (!spool) {
            return spool.error();
        }
        Result<PoseLabels> labels = spool.value()->read(answer.first, answer.count);
        if (!labels) {
            return labels.error();
        }
        answer.labels = std::move(labels.value());
    }
    return answer;
}

} // namespace cd
