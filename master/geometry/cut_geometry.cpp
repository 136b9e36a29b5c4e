#include "master/geometry/cut_geometry.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/tree/wire/top_block.hpp"
#include "master/geometry/blocks_file.hpp"

#include <mutex>
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
    mutable std::mutex writing{}; ///< Held while the file is written again.
    mutable bool is_lost = false; ///< The file could not be written again; guarded by `writing`.
    mutable std::mutex mutex{};   ///< Guards `anew`.
    /// The file that replaces `blocks` after damage; null if there was none.
    mutable std::shared_ptr<const BlocksFile> anew{};

    [[nodiscard]] Result<Bytes> read(RootIndex root) const;
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

Result<Bytes> CutGeometry::State::read(RootIndex root) const {
    std::shared_ptr<const BlocksFile> replacement;
    {
        const std::lock_guard lock(mutex);
        replacement = anew;
    }
    return read_block(replacement == nullptr ? blocks : *replacement, root);
}

Result<SubtreeBlock> CutGeometry::read(RootIndex root) const {
    if (root == top_root) {
        return state_->top_block;
    }
    Result<Bytes> bytes = state_->read(root);
    return bytes ? Result(SubtreeBlock{root, hash(root), std::move(bytes.value())}) : bytes.error();
}

SubtreeBlock CutGeometry::block(RootIndex root) const {
    Result<SubtreeBlock> read = this->read(root);
    if (!read) {
        const std::lock_guard writing(state_->writing);
        read = this->read(root); // Another thread may have replaced the file meanwhile.
        if (!read && !state_->is_lost) {
            write_anew(read.error().detail);
            read = this->read(root);
        }
    }
    return read ? std::move(read.value())
                : SubtreeBlock{root,
                               hash(root),
                               make_block(*state_->tree, state_->depth, state_->form, root)};
}

/// Renames the damaged file, and writes a new one. Sets `is_lost` if that fails. The index entries
/// do not change, since the tree determines them.
void CutGeometry::write_anew(const std::string& why) const {
    const std::filesystem::path path = state_->blocks.file.path();
    Status status = set_aside(path, why);
    if (status) {
        status = write_blocks_file(path, *state_->tree, state_->depth, state_->form, nullptr);
    }
    Result<BlocksFile> opened =
        status ? open_blocks_file(path, *state_->tree, state_->depth, state_->form)
               : Result<BlocksFile>(status.error());
    if (!opened) {
        state_->is_lost = true;
        log_error("blocks not written anew: error=\"{}\"", opened.error().detail);
        return;
    }
    const std::lock_guard lock(state_->mutex);
    state_->anew = std::make_shared<const BlocksFile>(std::move(opened.value()));
}

} // namespace cd
