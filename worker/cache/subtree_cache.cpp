#include "worker/cache/subtree_cache.hpp"

#include "common/core/check.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/worker.hpp"
#include "common/tree/wire/top_block.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cd {

Result<OpenedBlock> open_block(const SubtreeBlock& block) {
    const Result<Bytes> bytes = decompress(block.compressed, limits::subtree_block_bytes_max);
    if (!bytes) {
        return bytes.error();
    }
    if (sha256(bytes.value()) != block.hash) {
        return Error{ErrorCode::BadFrame,
                     "the block of root " + std::to_string(block.root) +
                         " does not have the announced hash"};
    }
    if (block.root == top_root) {
        Result<TreeTop> top = decode_top(bytes.value());
        return top ? Result<OpenedBlock>(std::make_shared<const TreeTop>(std::move(top.value())))
                   : top.error();
    }
    Result<Subtree> subtree = decode_subtree(bytes.value());
    return subtree
               ? Result<OpenedBlock>(std::make_shared<const Subtree>(std::move(subtree.value())))
               : subtree.error();
}

namespace {

/// The first id of a parked tree; the ids that a master gives are lower.
constexpr std::uint64_t parked_first = std::uint64_t{1} << 63;

bool is_parked(TreeId tree) {
    return tree.value >= parked_first;
}

using TreesById = std::map<TreeId, CachedTree>;

TreesById::iterator first_parked_of(TreesById& trees) {
    return trees.lower_bound(TreeId{parked_first});
}

CachedTree& rename(TreesById& trees, TreesById::iterator tree, TreeId to) {
    auto node = trees.extract(tree);
    node.key() = to;
    const auto inserted = trees.insert(std::move(node));
    CD_CHECK(inserted.inserted);
    return inserted.position->second;
}

/// Calls `change(slot, root)` for each cached subtree of the tree.
template <class Change>
void for_each_cached(CachedTree& tree, const Change& change) {
    for (RootIndex root = 0; root < tree.slots().size(); ++root) {
        if (tree.partial().at(root) != nullptr) {
            change(tree.slots()[root], root);
        }
    }
}

} // namespace

// ---- Trees --------------------------------------------------------------------------------------

void SubtreeCache::park(TreeId id) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    std::erase_if(evicted_, [&](const SubtreeKey& key) { return key.tree == id; });
    const TreeId parked_id{parked_first + parked_.last++};
    CachedTree& tree = rename(trees_, found, parked_id);
    for (Slot& slot : tree.slots()) {
        slot.is_pinned = false;
    }
    for_each_cached(tree, [&](Slot& slot, RootIndex root) {
        if (slot.is_idle) {
            idle_.erase(slot.place);
        }
        slot.is_idle = true;
        slot.place = parked_.blocks.insert(parked_.blocks.end(), {parked_id, root});
    });
    Slot& top = tree.top_slot();
    top.is_idle = true;
    top.place = parked_.blocks.insert(parked_.blocks.end(), {parked_id, top_root});
    const std::uint64_t bytes = tree.bytes();
    parked_.bytes += bytes;
    ++parked_.trees;
    if (bytes == 0) {
        drop(std::prev(trees_.end()));
    } else if (parked_.trees > limits::parked_trees_max) {
        drop(first_parked_of(trees_));
    }
    evict_beyond(bytes_max_);
}

void SubtreeCache::park_all() {
    for (const TreeId id : trees()) {
        park(id);
    }
}

void SubtreeCache::unpark(Trees::iterator parked, TreeId id) {
    CachedTree& tree = rename(trees_, parked, id);
    parked_.bytes -= tree.bytes();
    --parked_.trees;
    for_each_cached(tree, [&](Slot& slot, RootIndex /*root*/) {
        slot.place->tree = id;
        idle_.splice(idle_.end(), parked_.blocks, slot.place);
    });
    Slot& top = tree.top_slot();
    top.is_idle = false;
    parked_.blocks.erase(top.place);
}

void SubtreeCache::drop(Trees::iterator parked) {
    CachedTree& tree = parked->second;
    const std::uint64_t bytes = tree.bytes();
    for_each_cached(
        tree, [&](const Slot& slot, RootIndex /*root*/) { parked_.blocks.erase(slot.place); });
    parked_.blocks.erase(tree.top_slot().place);
    parked_.bytes -= bytes;
    --parked_.trees;
    bytes_ -= bytes;
    trees_.erase(parked);
}

std::vector<Sha256> SubtreeCache::parked() const {
    std::vector<Sha256> names;
    for (const auto& [id, tree] : trees_) {
        if (is_parked(id) && !held(id).empty()) {
            names.push_back(tree.named().cut);
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void SubtreeCache::drop_parked() {
    while (first_parked_of(trees_) != trees_.end()) {
        drop(first_parked_of(trees_));
    }
}

std::vector<TreeId> SubtreeCache::trees() const {
    std::vector<TreeId> present;
    for (const auto& [id, tree] : trees_) {
        if (!is_parked(id)) {
            present.push_back(id);
        }
    }
    return present;
}

std::vector<RootIndex> SubtreeCache::held(TreeId tree) const {
    std::vector<RootIndex> roots;
    if (const PartialObbTree* const partial = find(tree)) {
        for (RootIndex root = 0; root < partial->root_count(); ++root) {
            if (partial->at(root) != nullptr) {
                roots.push_back(root);
            }
        }
        if (partial->has_top()) {
            roots.push_back(top_root);
        }
    }
    return roots;
}

Status SubtreeCache::add_tree(const AddTree& add) {
    const std::string name = "tree " + std::to_string(add.tree.value);
    if (add.roots == 0 || add.roots > add.triangles || is_parked(add.tree)) {
        return Error{ErrorCode::BadFrame,
                     name + " has an impossible number of roots or an impossible id"};
    }
    if (trees_.contains(add.tree)) {
        return Error{ErrorCode::BadFrame, name + " was added already"};
    }
    for (auto parked = first_parked_of(trees_); parked != trees_.end(); ++parked) {
        const AddTree& named = parked->second.named();
        // Equal `cut` hashes mean equal blocks. The other fields are compared as a check.
        if (named.cut == add.cut && named.form == add.form && named.top == add.top &&
            named.roots == add.roots && named.triangles == add.triangles) {
            unpark(parked, add.tree);
            return Done{};
        }
    }
    trees_.try_emplace(add.tree, add);
    return Done{};
}

const PartialObbTree* SubtreeCache::find(TreeId tree) const {
    const auto found = trees_.find(tree);
    return found == trees_.end() ? nullptr : &found->second.partial();
}

std::shared_ptr<const PartialObbTree> SubtreeCache::snapshot(TreeId tree) {
    const auto found = trees_.find(tree);
    return found == trees_.end() ? nullptr : found->second.snapshot();
}

void SubtreeCache::touch(const SubtreeKey& key) {
    CachedTree* const tree = find_tree(key);
    if (tree != nullptr && tree->slots()[key.root].is_idle) {
        idle_.splice(idle_.end(), idle_, tree->slots()[key.root].place);
    }
}

CachedTree* SubtreeCache::find_tree(const SubtreeKey& key) {
    const auto found = trees_.find(key.tree);
    const bool is_there = found != trees_.end() && key.root < found->second.slots().size();
    return is_there ? &found->second : nullptr;
}

Status SubtreeCache::insert(const SubtreeKey& key,
                            OpenedBlock opened,
                            std::shared_ptr<const SubtreeBlock> block) {
    const auto found = trees_.find(key.tree);
    if (found == trees_.end() || has(key)) {
        return Done{};
    }
    CachedTree& tree = found->second;
    if (auto* const top = std::get_if<std::shared_ptr<const TreeTop>>(&opened)) {
        if (Status set = tree.set_top(std::move(*top), std::move(block)); !set) {
            return set;
        }
        bytes_ += tree.bytes_of_top();
    } else {
        auto& subtree = std::get<std::shared_ptr<const Subtree>>(opened);
        if (Status filled = tree.fill(key.root, std::move(subtree), std::move(block)); !filled) {
            return filled;
        }
        bytes_ += tree.bytes_of(key.root);
        if (Slot& slot = tree.slots()[key.root]; !slot.is_pinned) {
            set_idle(slot, key);
        }
    }
    evict_beyond(bytes_max_);
    return Done{};
}

std::shared_ptr<const Subtree> SubtreeCache::at(const SubtreeKey& key) const {
    const PartialObbTree* const tree = find(key.tree);
    const bool is_slot = tree != nullptr && key.root < tree->root_count();
    return is_slot ? tree->at(key.root) : nullptr;
}

bool SubtreeCache::has(const SubtreeKey& key) const {
    const PartialObbTree* const tree = find(key.tree);
    return key.root == top_root ? tree != nullptr && tree->has_top() : at(key) != nullptr;
}

std::shared_ptr<const SubtreeBlock> SubtreeCache::block_at(const SubtreeKey& key) const {
    const auto tree = trees_.find(key.tree);
    return tree == trees_.end() ? nullptr : tree->second.block_at(key.root);
}

void SubtreeCache::pin(const SubtreeKey& key) {
    CachedTree* const tree = find_tree(key);
    if (tree == nullptr) {
        return;
    }
    Slot& slot = tree->slots()[key.root];
    slot.is_pinned = true;
    if (slot.is_idle) {
        idle_.erase(slot.place);
        slot.is_idle = false;
    }
}

void SubtreeCache::unpin(const SubtreeKey& key) {
    CachedTree* const tree = find_tree(key);
    if (tree == nullptr || !tree->slots()[key.root].is_pinned) {
        return;
    }
    Slot& slot = tree->slots()[key.root];
    slot.is_pinned = false;
    if (tree->partial().at(key.root) != nullptr) {
        set_idle(slot, key);
        evict_beyond(bytes_max_);
    }
}

void SubtreeCache::set_idle(Slot& slot, const SubtreeKey& key) {
    CD_CHECK(!slot.is_idle);
    slot.is_idle = true;
    slot.place = idle_.insert(idle_.end(), key);
}

std::size_t SubtreeCache::let_go(std::uint64_t bytes) {
    const std::uint64_t evictions_before = evictions_;
    evict_beyond(bytes);
    return static_cast<std::size_t>(evictions_ - evictions_before);
}

void SubtreeCache::evict_beyond(std::uint64_t bytes_max) {
    while (bytes_ > bytes_max && !(parked_.blocks.empty() && idle_.empty())) {
        ++evictions_;
        const bool any_parked = !parked_.blocks.empty();
        const SubtreeKey key = any_parked ? parked_.blocks.front() : idle_.front();
        const auto found = trees_.find(key.tree);
        if (key.root == top_root) {
            drop(found);
            continue;
        }
        CachedTree& tree = found->second;
        const std::uint64_t bytes = tree.bytes_of(key.root);
        bytes_ -= bytes;
        tree.empty(key.root);
        tree.slots()[key.root].is_idle = false;
        if (any_parked) { // The master does not know of parked trees.
            parked_.blocks.pop_front();
            parked_.bytes -= bytes;
        } else {
            idle_.pop_front();
            evicted_.push_back(key);
        }
    }
}

std::vector<SubtreeKey> SubtreeCache::take_evicted() {
    return std::exchange(evicted_, {});
}

std::uint64_t SubtreeCache::bytes_expected(const SubtreeKey& key) const {
    const auto found = trees_.find(key.tree);
    CD_CHECK(found != trees_.end());
    return found->second.bytes_expected(key.root);
}

} // namespace cd
