#include "worker/cache/joined_trees.hpp"

#include "common/core/limits/worker.hpp"
#include "common/tree/build/wide_join.hpp"

#include <utility>
#include <vector>

namespace cd {

namespace {

bool is_joinable(const PartialObbTree& blocks) {
    for (RootIndex root = 0; root < blocks.root_count(); ++root) {
        const auto& subtree = blocks.at(root);
        if (subtree == nullptr || subtree->form() != SubtreeForm::Wide) {
            return false;
        }
    }
    return blocks.has_top();
}

std::uint64_t bytes_of(const PartialObbTree& blocks) {
    std::uint64_t bytes = 0;
    for (RootIndex root = 0; root < blocks.root_count(); ++root) {
        bytes += blocks.at(root)->memory_bytes();
    }
    return bytes;
}

} // namespace

JoinedTrees::Joined JoinedTrees::Step::run() const {
    if (joined != nullptr) {
        return std::make_shared<const WideTree>(joined->with_support());
    }
    std::vector<WideView> subtrees;
    for (RootIndex root = 0; root < blocks->root_count(); ++root) {
        subtrees.push_back(blocks->at(root)->view().wide);
    }
    return std::make_shared<const WideTree>(join_subtrees(blocks->top(), subtrees));
}

JoinedTrees::Entry& JoinedTrees::entry_of(const Blocks& blocks) {
    Entry& entry = entries_[blocks.get()];
    if (entry.blocks.lock() != blocks) {
        entry = {};
        entry.blocks = blocks;
        entry.is_joinable = is_joinable(*blocks);
    }
    return entry;
}

std::optional<JoinedTrees::Step> JoinedTrees::count(const Blocks& blocks, std::uint64_t bytes_max) {
    Entry& entry = entry_of(blocks);
    ++entry.descents;
    entry.last_use = ++descents_;
    const bool has_points = entry.joined != nullptr && !entry.joined->view().support.sets.empty();
    const std::uint32_t descents_min =
        entry.joined == nullptr ? limits::join_descents_min : limits::points_descents_min;
    if (!entry.is_joinable || has_points || entry.is_under_way || entry.descents < descents_min) {
        return std::nullopt;
    }
    const std::uint64_t needed = bytes_of(*blocks);
    while (bytes() + needed > bytes_max) {
        const auto unused = least_recently_used();
        if (unused == entries_.end() ||
            descents_ - unused->second.last_use < limits::joined_unused_descents) {
            return std::nullopt;
        }
        entries_.erase(unused);
    }
    entry.is_under_way = true;
    return Step{blocks, entry.joined};
}

JoinedTrees::Entries::iterator JoinedTrees::least_recently_used() {
    auto found = entries_.end();
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
        if (entry->second.joined != nullptr &&
            (found == entries_.end() || entry->second.last_use < found->second.last_use)) {
            found = entry;
        }
    }
    return found;
}

void JoinedTrees::end(const Step& step, Joined joined) {
    const auto found = entries_.find(step.blocks.get());
    if (found != entries_.end()) {
        found->second.is_under_way = false;
        found->second.joined = std::move(joined);
    }
}

JoinedTrees::Joined JoinedTrees::find(const Blocks& blocks) const {
    const auto found = entries_.find(blocks.get());
    const bool is_of_blocks = found != entries_.end() && found->second.blocks.lock() == blocks;
    return is_of_blocks ? found->second.joined : nullptr;
}

void JoinedTrees::keep_within(std::uint64_t bytes_max) {
    std::erase_if(entries_, [](const auto& entry) { return entry.second.blocks.expired(); });
    while (bytes() > bytes_max) {
        entries_.erase(least_recently_used());
    }
}

std::uint64_t JoinedTrees::bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [blocks, entry] : entries_) {
        bytes += entry.joined == nullptr ? 0 : entry.joined->memory_bytes();
    }
    return bytes;
}

} // namespace cd
