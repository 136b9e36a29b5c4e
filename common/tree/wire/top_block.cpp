#include "common/tree/wire/top_block.hpp"

#include "common/tree/wire/node_columns.hpp"

#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::uint8_t version = 1;

} // namespace

Bytes encode_top(const TreeTop& top) {
    ByteWriter out;
    out.put(version);
    out.put(static_cast<std::uint32_t>(top.nodes.size()));
    out.put(top.triangle_count());
    put_nodes(out, top.nodes);
    return out.take();
}

Result<TreeTop> decode_top(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    const auto read_version = in.get<std::uint8_t>();
    const auto node_count = in.get<std::uint32_t>();
    const auto triangle_count = in.get<std::uint32_t>();
    const bool fits = node_count != 0 && node_count <= in.remaining() / node_bytes_min;
    if (in.failed() || read_version != version || !fits) {
        return Error{ErrorCode::BadFrame, "top of a tree: a header that does not fit the bytes"};
    }
    std::vector<ObbNode> nodes(node_count);
    if (!get_nodes(in, nodes, triangle_count) || !in.complete()) {
        return Error{ErrorCode::BadFrame, "top of a tree: nodes that are no tree of boxes"};
    }
    return make_tree_top(std::move(nodes));
}

} // namespace cd
