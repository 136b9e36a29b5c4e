#include "master/workers/worker_supply.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <utility>

namespace cd {

namespace {

JobId id_of(JobId job) {
    return job;
}

TreeId id_of(const std::pair<const TreeId, Sha256>& tree) {
    return tree.first;
}

/// Removes from `known` the entries whose ids are not in `there`. Returns the ids of `there` that
/// are not in `known`.
template <class Id, class Known>
std::vector<Id> keep_those(const std::set<Id>& there, Known& known) {
    std::vector<Id> strange;
    for (const Id one : there) {
        if (!known.contains(one)) {
            strange.push_back(one);
        }
    }
    std::erase_if(known, [&](const auto& entry) { return !there.contains(id_of(entry)); });
    return strange;
}

} // namespace

void WorkerSupply::add_tree(const AddTree& tree, Messages& out) {
    if (trees_.emplace(tree.tree, tree.cut).second) {
        out.emplace_back(tree);
    }
}

WorkerSupply::Messages WorkerSupply::add_job(const AddJob& job, std::span<const AddTree> trees) {
    const bool is_new = jobs_.insert(job.job).second;
    CD_CHECK(is_new);
    Messages out;
    for (const AddTree& tree : trees) {
        add_tree(tree, out);
    }
    out.emplace_back(job);
    return out;
}

WorkerSupply::Messages WorkerSupply::remove_job(JobId job) {
    return jobs_.erase(job) == 0 ? Messages{} : Messages{RemoveJob{job}};
}

WorkerSupply::Messages WorkerSupply::remove_tree(TreeId tree) {
    const auto found = trees_.find(tree);
    if (found == trees_.end()) {
        return {};
    }
    if (cuts_.size() < limits::cuts_held_max) {
        cuts_.insert(found->second);
    }
    trees_.erase(found);
    return {RemoveTree{tree}};
}

Status WorkerSupply::cuts_kept(const Holding& holding) {
    cuts_.insert(holding.cuts.begin(), holding.cuts.end());
    if (cuts_.size() > limits::cuts_held_max) {
        return Error{ErrorCode::TooLarge, "it holds blocks of too many cuts"};
    }
    return Done{};
}

WorkerSupply::Messages WorkerSupply::add_kept(std::span<const AddTree> in_use) {
    Messages out;
    for (const AddTree& tree : in_use) {
        if (cuts_.contains(tree.cut)) {
            add_tree(tree, out);
        }
    }
    return out;
}

WorkerSupply::Messages WorkerSupply::compare(const Inventory& inventory) {
    std::set<TreeId> trees;
    for (const InventoryTree& tree : inventory.trees) {
        trees.insert(tree.tree);
    }
    Messages out;
    for (const TreeId tree : keep_those(trees, trees_)) {
        out.emplace_back(RemoveTree{tree});
    }
    const std::set<JobId> jobs(inventory.jobs.begin(), inventory.jobs.end());
    for (const JobId job : keep_those(jobs, jobs_)) {
        out.emplace_back(RemoveJob{job});
    }
    return out;
}

} // namespace cd
