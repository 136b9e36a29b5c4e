#include "master/cut_geometry.hpp"

#include "master/blocks_file.hpp"

namespace cd {

struct CutGeometry::State {
    std::uint32_t depth;
    SubtreeForm form;
    TreeTop top;
    BlocksFile blocks;
    std::uint64_t compressed_bytes = 0;
    std::uint64_t bytes = 0;
};

Result<std::shared_ptr<const CutGeometry>> CutGeometry::open(const std::filesystem::path& path,
                                                             const ObbTree& tree,
                                                             std::uint32_t depth,
                                                             SubtreeForm form) {
    Result<BlocksFile> blocks = open_blocks_file(path, tree, depth, form);
    if (!blocks) {
        return blocks.error();
    }
    auto state = std::make_unique<State>(
        State{depth, form, cut_tree(tree, depth), std::move(blocks.value()), 0, 0});
    for (const BlockPlace& place : state->blocks.places) {
        state->compressed_bytes += place.compressed_bytes;
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

const Sha256& CutGeometry::hash(RootIndex root) const {
    return state_->blocks.places[root].hash;
}

std::uint64_t CutGeometry::compressed_bytes(RootIndex root) const {
    return state_->blocks.places[root].compressed_bytes;
}

std::uint64_t CutGeometry::compressed_bytes_total() const {
    return state_->compressed_bytes;
}

std::uint64_t CutGeometry::bytes_total() const {
    return state_->bytes;
}

Result<SubtreeBlock> CutGeometry::block(RootIndex root) const {
    Result<Bytes> compressed = read_block(state_->blocks, root);
    if (!compressed) {
        return compressed.error();
    }
    return SubtreeBlock{root, hash(root), std::move(compressed.value())};
}

} // namespace cd
