#include "master/submission/job_spool.hpp"

#include <cstdint>
#include <utility>

namespace cd {

Result<std::shared_ptr<JobSpool>> JobSpool::create(const std::filesystem::path& directory,
                                                   const Submit& submit) {
    auto spool = std::make_shared<JobSpool>();
    auto poses = PoseSpool::create(directory, announced_by(submit));
    if (!poses) {
        return poses.error();
    }
    spool->poses_ = std::move(poses.value());
    if (!submit.poses.labels.is_empty()) {
        auto labels = LabelSpool::create(directory, submit.poses.labels, submit.scenarios);
        if (!labels) {
            return labels.error();
        }
        spool->labels_ = std::move(labels.value());
    }
    return spool;
}

Status JobSpool::append(const PosesPart& part) {
    const std::uint64_t before = poses_->count();
    if (Status poses = poses_->append(part.scenarios); !poses) {
        return poses;
    }
    if (labels_ != nullptr) {
        return labels_->append(part.labels, poses_->count() - before);
    }
    return part.labels.is_empty()
               ? Status(Done{})
               : Status(Error{ErrorCode::BadInput, "ids or times that were not announced"});
}

Status JobSpool::seal(const Journal& journal, JobId job, Durability durability) {
    if (labels_ != nullptr) {
        if (Status sealed = labels_->seal(journal.labels_path(job), durability); !sealed) {
            return sealed;
        }
    }
    return poses_->seal(journal.poses_path(job), durability);
}

} // namespace cd
