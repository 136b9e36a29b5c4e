#include "master/geometry/cut_geometry.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/tree/wire/top_block.hpp"
#include "master/geometry/blocks_file.hpp"

#include <atomic>
#include <utility>

namespace cd {

struct CutGeometry::State {
    std::shared_ptr<const ObbTree> tree;
    std::uint32_t depth;
    SubtreeForm form;
    TreeTop top;
    SubtreeBlock top_block;
    BlocksFile blocks;
    std::uint64_t bytes = 0;
    mutable std::atomic<bool> is_set_aside = false; ///< The blocks file was renamed as damaged.
};

namespace {

Result<SubtreeBlock> block_of(const TreeTop& top) {
    const Bytes bytes = encode_top(top);
    if (bytes.size() > limits::subtree_block_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "the top of a tree with " + std::to_string(top.root_count()) +
                         " distribution roots is too large; a smaller distribution depth helps"};
    }
    return SubtreeBlock{top_root, sha256(bytes), compress(bytes, compression_level_geometry)};
}

} // namespace

Result<std::shared_ptr<const CutGeometry>> CutGeometry::open(const std::filesystem::path& path,
                                                             std::shared_ptr<const ObbTree> tree,
                                                             std::uint32_t depth,
                                                             SubtreeForm form) {
    Result<BlocksFile> blocks = open_blocks_file(path, *tree, depth, form);
    if (!blocks) {
        return blocks.error();
    }
    TreeTop top = cut_tree(*tree, depth);
    Result<SubtreeBlock> top_block = block_of(top);
    if (!top_block) {
        return top_block.error();
    }
    std::unique_ptr<State> state(new State{std::move(tree),
                                           depth,
                                           form,
                                           std::move(top),
                                           std::move(top_block.value()),
                                           std::move(blocks.value())});
    for (const BlockPlace& place : state->blocks.places) {
        state->bytes += place.bytes;
    }
    return std::shared_ptr<const CutGeometry>(new CutGeometry(std::move(state)));
}

CutGeometry::CutGeometry(std::unique_ptr<const State> state) : state_(std::move(state)) {}
CutGeometry::~CutGeometry() = default;

std::uint32_t CutGeometry::depth() const {
    return state_->depth;
}

SubtreeForm CutGeometry::form() const {
    return state_->form;
}

const TreeTop& CutGeometry::top() const {
    return state_->top;
}

std::uint32_t CutGeometry::root_count() const {
    return state_->top.root_count();
}

bool CutGeometry::has_blocks(std::span<const RootIndex> roots) const {
    roots = without_top(roots);
    return roots.empty() || roots.back() < root_count();
}

const Sha256& CutGeometry::hash(RootIndex root) const {
    return root == top_root ? state_->top_block.hash : state_->blocks.places[root].hash;
}

std::uint64_t CutGeometry::compressed_bytes(RootIndex root) const {
    return root == top_root ? state_->top_block.compressed.size()
                            : state_->blocks.places[root].compressed_bytes;
}

std::uint64_t CutGeometry::bytes_total() const {
    return state_->bytes;
}

SubtreeBlock CutGeometry::block(RootIndex root) const {
    return root == top_root ? state_->top_block
                            : SubtreeBlock{root, hash(root), compressed_block(root)};
}

Bytes CutGeometry::compressed_block(RootIndex root) const {
    Result<Bytes> read = read_block(state_->blocks, root);
    if (read) {
        return std::move(read.value());
    }
    if (!state_->is_set_aside.exchange(true)) {
        const Status moved = set_aside(state_->blocks.file.path(), read.error().detail);
        if (!moved) {
            log_error("damaged file not moved away: error=\"{}\"", moved.error().detail);
        }
    }
    return make_block(*state_->tree, state_->depth, state_->form, root);
}

} // namespace cd
