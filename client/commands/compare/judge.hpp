// Judges the groups of a run by an earlier run and by what people said: --baseline and --statuses.
#pragma once

#include "client/cli/cli.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/compare/group_statuses.hpp"
#include "client/groups/group_sum.hpp"
#include "client/spec/status_file.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// The baseline, and the rules of the file of statuses.
class Judge {
  public:
    /// Opens the baseline and reads the file, as far as `options` name them. `fail_on` is what the
    /// verb fails on. Errors: as `open_run_at_hand` and `read_status_file`; BadInput to fail on new
    /// groups without a baseline, and for a baseline without groups.
    [[nodiscard]] static Result<Judge> open(const JudgeOptions& options,
                                            FailOn fail_on,
                                            const MasterOptions& master,
                                            const std::string& tree_cache,
                                            ThreadPool& pool);

    /// Judges the groups of a run, whose parts are of `kind_of_parts`, and prints warnings on
    /// stderr. Reads the records of both runs once more if a group of the baseline is gone. Errors:
    /// Io; Interrupted.
    [[nodiscard]] Result<GroupStatuses> judge(RunAtHand& run, GroupSum& groups);

    [[nodiscard]] bool has_baseline() const { return earlier_.has_value(); }
    /// Returns the parts that are in the groups of a run of this level and of the baseline.
    [[nodiscard]] PartKind kind_of_parts(Level level) const;
    /// Returns the baseline's digest, or why it has none.
    [[nodiscard]] std::string baseline_digest() const;

  private:
    Judge(std::optional<RunAtHand> earlier, std::vector<StatusRule> rules)
        : earlier_(std::move(earlier)), rules_(std::move(rules)) {}

    std::optional<RunAtHand> earlier_; ///< The baseline.
    std::vector<StatusRule> rules_;
};

/// Judges the run in a results folder for the verb `run`, and prints how it compares with the
/// baseline. Returns true if there are groups to fail on as new. Errors: as `Judge::judge` and
/// `open_run_at_hand`.
[[nodiscard]] Result<bool>
judge_folder(Judge& judge, const RunCommand& command, const std::string& dir, ThreadPool& pool);

} // namespace cd
