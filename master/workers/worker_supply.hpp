// Tracks the jobs and trees that one worker knows, and makes the messages that update the worker.
#pragma once

#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "proto/codec/message.hpp"
#include "proto/messages/work_messages.hpp"

#include <map>
#include <set>
#include <span>
#include <vector>

namespace cd {

/// Changes return the messages that the caller must send to the worker, in order. No sockets.
class WorkerSupply {
  public:
    using Messages = std::vector<Message>;

    [[nodiscard]] bool has_job(JobId job) const { return jobs_.contains(job); }
    [[nodiscard]] bool has_tree(TreeId tree) const { return trees_.contains(tree); }

    /// Adds a job that the worker does not know, and before it the job's trees that the worker
    /// lacks.
    [[nodiscard]] Messages add_job(const AddJob& job, std::span<const AddTree> trees);
    [[nodiscard]] Messages remove_job(JobId job);
    /// Removes a tree that no job uses any more. The worker keeps the tree's blocks while it has
    /// room.
    [[nodiscard]] Messages remove_tree(TreeId tree);

    /// Records cuts whose blocks the worker kept from an earlier session. Errors: TooLarge for more
    /// than `limits::cuts_held_max`.
    [[nodiscard]] Status cuts_kept(const Holding& holding);
    /// Adds to the worker the trees of `in_use` that it lacks, if it may have kept their blocks.
    /// The worker then reports the blocks that it holds.
    [[nodiscard]] Messages add_kept(std::span<const AddTree> in_use);

    /// Resynchronises with the worker's inventory, after messages may have been lost. Removes the
    /// jobs and trees that the worker should not have. Forgets that the worker got the jobs and
    /// trees it lacks, so that they are sent again when needed.
    [[nodiscard]] Messages compare(const Inventory& inventory);

  private:
    void add_tree(const AddTree& tree, Messages& out);

    std::map<TreeId, Sha256> trees_; ///< Sent to the worker (AddTree), with their cuts.
    std::set<JobId> jobs_;           ///< Sent to the worker (AddJob).
    std::set<Sha256> cuts_;          ///< Cuts of which the worker may have kept blocks.
};

} // namespace cd
