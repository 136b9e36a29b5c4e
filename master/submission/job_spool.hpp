// Stores a job's poses and their labels on disk while a client uploads them.
#pragma once

#include "common/core/result.hpp"
#include "master/journal/journal.hpp"
#include "master/submission/label_spool.hpp"
#include "master/submission/pose_spool.hpp"
#include "proto/messages/client_messages.hpp"

#include <filesystem>
#include <memory>

namespace cd {

/// One job's poses and, if its pose file has ids or times, their labels. One thread at a time may
/// append. All members block for the disk.
class JobSpool {
  public:
    /// Creates files in `directory` for the scenarios and columns that `submit` announces. Errors:
    /// as `PoseSpool::create` and `LabelSpool::create`.
    [[nodiscard]] static Result<std::shared_ptr<JobSpool>>
    create(const std::filesystem::path& directory, const Submit& submit);

    /// Appends the next scenarios. Errors: as `PoseSpool::append` and `LabelSpool::append`.
    [[nodiscard]] Status append(const PosesPart& part);
    /// Finishes the files after the last part and renames them as the journal expects. Errors: Io.
    [[nodiscard]] Status seal(const Journal& journal, JobId job, Durability durability);

    [[nodiscard]] const std::shared_ptr<PoseSpool>& poses() const { return poses_; }

  private:
    std::shared_ptr<PoseSpool> poses_;
    std::unique_ptr<LabelSpool> labels_; ///< Null for a job without labels.
};

} // namespace cd
