#include "common/tree/wire/wide_block.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"
#include "common/tree/wide/wide_boxes.hpp"
#include "common/tree/wide/wide_frame.hpp"
#include "common/tree/wire/byte_planes.hpp"
#include "common/tree/wire/wide_blocks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <string>
#include <utility>

namespace cd {

namespace {

constexpr std::uint8_t flag_double = 1;
constexpr unsigned number_planes_shift = 1;
constexpr unsigned id_planes_shift = 4;
constexpr std::uint8_t planes_mask = 7;

constexpr std::uint8_t count_mask = 15;
constexpr std::uint8_t leaf_bit = 16;
constexpr unsigned kind_shift = 5;

template <class Float>
std::span<const Float> coordinates_of(const TriangleBlocks& blocks) {
    if constexpr (sizeof(Float) == 4) {
        return blocks.floats;
    } else {
        return blocks.doubles;
    }
}

// ---- Encoding --------------------------------------------------------------------------------

FrameCode frame_code_of(const WideNode& node) {
    std::array<float, 9> axes{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            axes[3 * k + c] = node.columns[c][k];
        }
    }
    const FrameCode code = code_of(axes);
    CD_CHECK(frame_of(code) == axes);
    return code;
}

void put_nodes(ByteWriter& out, std::span<const WideNode> nodes) {
    std::array<std::vector<std::uint16_t>, 3> parts;
    for (const WideNode& node : nodes) {
        const FrameCode code = frame_code_of(node);
        out.put(static_cast<std::uint8_t>((node.count - 1) | (node.is_leaf ? leaf_bit : 0) |
                                          (code.kind << kind_shift)));
        for (std::size_t k = 0; k < 3 && code.kind != 0; ++k) {
            parts[k].push_back(static_cast<std::uint16_t>(code.parts[k]));
        }
    }
    for (const std::vector<std::uint16_t>& column : parts) {
        put_planes(out, std::span<const std::uint16_t>(column));
    }
}

/// Returns the number of triangles of each block.
std::vector<std::uint8_t> triangle_counts(const WideView& wide) {
    std::vector<std::uint8_t> counts;
    for (const WideNode& node : wide.nodes) {
        if (node.is_leaf) {
            CD_CHECK(node.first == counts.size());
            counts.push_back(node.count);
        }
    }
    return counts;
}

void put_corners(ByteWriter& out,
                 const TriangleBlocks& blocks,
                 std::span<const std::uint8_t> counts) {
    for (std::size_t block = 0; block < counts.size(); ++block) {
        std::uint8_t met = 0;
        for (std::size_t i = 0; i < counts[block]; ++i) {
            const BlockCorners& corners = blocks.corners[block_size * block + i];
            for (std::size_t k = 0; k < 3; ++k) {
                CD_CHECK(corners[k] <= met);
                out.put(static_cast<std::uint8_t>(met - corners[k]));
                met += corners[k] == met ? 1 : 0;
            }
        }
    }
}

/// The distinct vertices of all blocks, in the order of first use.
struct SharedVertices {
    std::vector<std::uint32_t> steps_back; ///< Distance back, by vertex; 0: a new vertex.
    std::vector<std::uint32_t> first_uses; ///< Per distinct vertex: its first index in the blocks.
};

template <class Float>
SharedVertices share_vertices(const TriangleBlocks& blocks) {
    const std::span<const Float> coordinates = coordinates_of<Float>(blocks);
    const std::uint32_t count = blocks.vertex_begin.back();
    const auto key = [&](std::uint32_t vertex) {
        std::array<BitsOf<Float>, 3> bits{};
        for (std::size_t k = 0; k < 3; ++k) {
            bits[k] = std::bit_cast<BitsOf<Float>>(coordinates[3 * std::size_t{vertex} + k]);
        }
        return bits;
    };
    std::vector<std::uint32_t> sorted(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        sorted[i] = i;
    }
    std::ranges::sort(sorted, [&](std::uint32_t left, std::uint32_t right) {
        return std::pair(key(left), left) < std::pair(key(right), right);
    });
    std::vector<std::uint32_t> first_equal(count); // For each vertex, the first equal one.
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_new = i == 0 || key(sorted[i]) != key(sorted[i - 1]);
        first_equal[sorted[i]] = is_new ? sorted[i] : first_equal[sorted[i - 1]];
    }
    SharedVertices shared;
    std::vector<std::uint32_t> number(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto next = static_cast<std::uint32_t>(shared.first_uses.size());
        if (first_equal[i] == i) {
            number[i] = next;
            shared.first_uses.push_back(i);
        }
        shared.steps_back.push_back(first_equal[i] == i ? 0 : next - number[first_equal[i]]);
    }
    return shared;
}

template <class Float>
void put_vertices(ByteWriter& out,
                  const TriangleBlocks& blocks,
                  std::span<const std::uint32_t> vertices) {
    const std::span<const Float> coordinates = coordinates_of<Float>(blocks);
    std::vector<BitsOf<Float>> column(vertices.size());
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            column[i] = std::bit_cast<BitsOf<Float>>(coordinates[3 * std::size_t{vertices[i]} + k]);
        }
        put_planes(out, std::span<const BitsOf<Float>>(column));
    }
}

/// Returns the steps between ids modulo 2^32, so that every step fits.
std::vector<std::uint32_t> id_steps(const TriangleBlocks& blocks,
                                    std::span<const std::uint8_t> counts) {
    std::vector<std::uint32_t> steps;
    std::uint32_t first_before = 0;
    for (std::size_t block = 0; block < counts.size(); ++block) {
        const std::uint32_t* const ids = &blocks.ids[block_size * block];
        steps.push_back(
            static_cast<std::uint32_t>(zigzag(static_cast<std::int32_t>(ids[0] - first_before))));
        first_before = ids[0];
        for (std::size_t i = 1; i < counts[block]; ++i) {
            steps.push_back(ids[i] - ids[i - 1] - 1);
        }
    }
    return steps;
}

template <class Float>
Bytes encode(const WideView& wide) {
    const TriangleBlocks& blocks = wide.triangles;
    const std::vector<std::uint8_t> counts = triangle_counts(wide);
    const SharedVertices shared = share_vertices<Float>(blocks);
    const std::vector<std::uint32_t> ids = id_steps(blocks, counts);
    const std::size_t number_planes = planes_for(shared.steps_back);
    const std::size_t id_planes = planes_for(ids);
    ByteWriter out;
    out.put(wide_block_version);
    out.put(static_cast<std::uint8_t>((sizeof(Float) == 8 ? flag_double : 0) |
                                      (number_planes << number_planes_shift) |
                                      (id_planes << id_planes_shift)));
    put_varint(out, wide.nodes.size());
    put_varint(out, shared.first_uses.size());
    put_nodes(out, wide.nodes);
    put_corners(out, blocks, counts);
    put_planes(out, std::span<const std::uint32_t>(shared.steps_back), number_planes);
    put_vertices<Float>(out, blocks, shared.first_uses);
    put_planes(out, std::span<const std::uint32_t>(ids), id_planes);
    return out.take();
}

// ---- Decoding --------------------------------------------------------------------------------

/// A decoded tree without its boxes.
struct Outline {
    std::vector<WideNode> nodes;
    std::vector<FrameCode> frames;
    std::vector<std::uint8_t> counts; ///< Number of triangles of each block.
    std::size_t triangles = 0;
};

/// Sets the first child of each inner node. Returns false when the nodes are no tree, or a tree so
/// deep that making its boxes could take long.
bool number_children(std::vector<WideNode>& nodes) {
    struct Open {
        std::size_t node;
        unsigned depth;
    };
    std::vector<Open> open{{0, 0}};
    std::size_t next = 1;
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        if (nodes[node].is_leaf) {
            continue;
        }
        const std::size_t count = nodes[node].count;
        if (count < 2 || depth == limits::wide_tree_depth_max || count > nodes.size() - next) {
            return false;
        }
        nodes[node].first = static_cast<std::uint32_t>(next);
        for (std::size_t i = count; i-- > 0;) {
            open.push_back({next + i, depth + 1});
        }
        next += count;
    }
    return next == nodes.size();
}

bool get_frames(ByteReader& in, std::span<const std::byte> kinds, std::vector<FrameCode>& frames) {
    std::size_t own = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        frames[i].kind = std::to_integer<std::uint8_t>(kinds[i]) >> kind_shift;
        own += frames[i].kind != 0 ? 1 : 0;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<std::uint16_t> parts = get_planes<std::uint16_t>(in, own);
        if (in.failed()) {
            return false;
        }
        auto part = parts.begin();
        for (FrameCode& frame : frames) {
            if (frame.kind != 0) {
                frame.parts[k] = static_cast<std::int16_t>(*part++);
            }
        }
    }
    return true;
}

bool get_outline(ByteReader& in, std::size_t count, Outline& outline) {
    const std::span<const std::byte> kinds = in.get_bytes(count);
    if (in.failed() || count == 0) {
        return false;
    }
    outline.nodes.resize(count);
    outline.frames.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        WideNode& node = outline.nodes[i];
        const auto bits = std::to_integer<std::uint8_t>(kinds[i]);
        node.count = static_cast<std::uint8_t>((bits & count_mask) + 1);
        node.is_leaf = (bits & leaf_bit) != 0;
        if (node.is_leaf) {
            node.first = static_cast<std::uint32_t>(outline.counts.size());
            outline.counts.push_back(node.count);
            outline.triangles += node.count;
        }
    }
    return number_children(outline.nodes) && get_frames(in, kinds, outline.frames);
}

/// Reads one column of coordinates and raises `reach` to the largest magnitude. Returns false when
/// the bytes end early or a number is NaN or too large.
template <class Float>
bool get_coordinates(ByteReader& in, std::size_t count, std::vector<Float>& column, double& reach) {
    const std::vector<BitsOf<Float>> bits = get_planes<BitsOf<Float>>(in, count);
    if (in.failed()) {
        return false;
    }
    column.resize(count);
    // Without the sign, the bits of floats sort as the absolute values do, and NaN comes last.
    constexpr BitsOf<Float> sign = BitsOf<Float>{1} << (8 * sizeof(Float) - 1);
    BitsOf<Float> largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        largest = std::max(largest, static_cast<BitsOf<Float>>(bits[i] & ~sign));
        column[i] = std::bit_cast<Float>(bits[i]);
    }
    const auto size = static_cast<double>(std::bit_cast<Float>(largest));
    reach = std::max(reach, size);
    return size < wide_coordinate_max;
}

/// Fills the blocks of a tree in order, from decoded columns.
template <class Float>
class BlockFiller {
  public:
    BlockFiller(const std::byte* corners,
                std::span<const std::uint32_t> steps_back,
                const std::array<std::vector<Float>, 3>& vertices,
                std::span<const std::uint32_t> id_steps,
                WideBlocks& blocks)
        : corner_(corners),
          step_back_(steps_back.data()),
          steps_end_(steps_back.data() + steps_back.size()),
          vertices_(vertices),
          id_step_(id_steps.data()),
          blocks_(blocks) {
        if constexpr (sizeof(Float) == 4) {
            to_ = blocks.floats.data();
        } else {
            to_ = blocks.doubles.data();
        }
    }

    /// Fills the next block, number `block`. Returns false when corners name no vertex.
    bool fill(std::size_t block, std::size_t triangles);
    /// Returns true if the filled blocks use all vertices and all steps.
    [[nodiscard]] bool is_complete() const {
        return next_ == vertices_[0].size() && step_back_ == steps_end_;
    }

  private:
    bool copy_vertices(std::size_t count);

    const std::byte* corner_;
    const std::uint32_t* step_back_;
    const std::uint32_t* steps_end_;
    const std::array<std::vector<Float>, 3>& vertices_;
    const std::uint32_t* id_step_;
    WideBlocks& blocks_;
    Float* to_;
    std::size_t next_ = 0;              ///< The lowest vertex not yet used.
    std::uint32_t first_before_ = 0;    ///< The first id of the previous block.
    std::uint32_t vertices_before_ = 0; ///< Vertices of all previous blocks.
};

template <class Float>
bool BlockFiller<Float>::copy_vertices(std::size_t count) {
    const std::size_t all = vertices_[0].size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t back = *step_back_++;
        const std::size_t vertex =
            next_ - back; // An underflow wraps round to an index that is refused.
        if (vertex >= all) {
            return false;
        }
        next_ += back == 0 ? 1 : 0;
        for (std::size_t k = 0; k < 3; ++k) {
            *to_++ = vertices_[k][vertex];
        }
    }
    return true;
}

template <class Float>
bool BlockFiller<Float>::fill(std::size_t block, std::size_t triangles) {
    BlockCorners* const corners = &blocks_.corners[block_size * block];
    std::uint32_t met = 0;
    bool is_valid = true;
    for (std::size_t i = 0; i < triangles; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto back = std::to_integer<std::uint32_t>(*corner_++);
            is_valid = is_valid && back <= met;
            corners[i][k] = static_cast<std::uint8_t>(met - back);
            met += back == 0 ? 1 : 0;
        }
    }
    if (!is_valid || met > static_cast<std::size_t>(steps_end_ - step_back_)) {
        return false;
    }
    std::uint32_t* const ids = &blocks_.ids[block_size * block];
    ids[0] = first_before_ + static_cast<std::uint32_t>(unzigzag(*id_step_++));
    first_before_ = ids[0];
    for (std::size_t i = 1; i < triangles; ++i) {
        ids[i] = ids[i - 1] + *id_step_++ + 1;
    }
    vertices_before_ += met;
    blocks_.vertex_begin[block + 1] = vertices_before_;
    return copy_vertices(met);
}

struct Arrays {
    std::vector<WideNode> nodes;
    WideBlocks blocks;
};

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("subtree block: ") + what};
}

struct Header {
    std::size_t nodes = 0;
    std::size_t vertices = 0;
    std::size_t number_planes = 0;
    std::size_t id_planes = 0;
};

template <class Float>
Status
get_blocks(ByteReader& in, const Header& header, const Outline& outline, WideBlocks& blocks) {
    const std::span<const std::byte> corners = in.get_bytes(3 * std::uint64_t{outline.triangles});
    const auto block_vertices = static_cast<std::size_t>(std::ranges::count(corners, std::byte{0}));
    const auto steps_back = get_planes<std::uint32_t>(in, block_vertices, header.number_planes);
    std::array<std::vector<Float>, 3> vertices;
    for (std::vector<Float>& column : vertices) {
        if (!get_coordinates(in, header.vertices, column, blocks.reach)) {
            return bad("vertices cut short or too large");
        }
    }
    const auto id_steps = get_planes<std::uint32_t>(in, outline.triangles, header.id_planes);
    if (!in.complete()) {
        return bad("a wrong length");
    }
    const std::size_t numbers = 3 * block_vertices + spare_numbers;
    if constexpr (sizeof(Float) == 4) {
        blocks.floats.resize(numbers);
    } else {
        blocks.doubles.resize(numbers);
    }
    blocks.vertex_begin.resize(outline.counts.size() + 1);
    blocks.corners.resize(block_size * outline.counts.size());
    blocks.ids.resize(block_size * outline.counts.size());
    BlockFiller<Float> filler(corners.data(), steps_back, vertices, id_steps, blocks);
    for (std::size_t i = 0; i < outline.counts.size(); ++i) {
        if (!filler.fill(i, outline.counts[i])) {
            return bad("corners that name no vertex");
        }
    }
    return filler.is_complete() ? Status(Done{}) : bad("vertices that no triangle has");
}

/// Makes the nodes' boxes. Returns false if a frame is invalid.
bool make_boxes(const std::vector<FrameCode>& frames, Arrays& arrays) {
    const WideBoxes boxes(arrays.blocks.view(), arrays.nodes);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto axes = frame_of(frames[i]);
        if (!axes) {
            return false;
        }
        arrays.nodes[i] = boxes.in_frame(i, *axes);
    }
    return true;
}

} // namespace

Bytes encode_wide_block(const WideView& wide) {
    CD_CHECK(!wide.nodes.empty());
    return wide.triangles.doubles.empty() ? encode<float>(wide) : encode<double>(wide);
}

Result<WideTree> decode_wide_block(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint8_t>() != wide_block_version) {
        return bad("unknown version");
    }
    const auto flags = in.get<std::uint8_t>();
    const auto nodes = get_varint(in);
    const auto vertices = get_varint(in);
    const Header header{nodes.value_or(0),
                        vertices.value_or(0),
                        std::size_t{flags} >> number_planes_shift & planes_mask,
                        std::size_t{flags} >> id_planes_shift & planes_mask};
    // A leaf takes at least four bytes, a node above leaves one, and a vertex twelve: nothing is
    // allocated that the bytes cannot hold.
    if (flags >= 128 || header.number_planes > 4 || header.id_planes > 4 ||
        header.nodes > in.remaining() / 2 || header.vertices > in.remaining() / 12) {
        return bad("a header that does not fit the bytes");
    }
    Outline outline;
    if (!get_outline(in, header.nodes, outline)) {
        return bad("nodes that are no tree");
    }
    auto arrays = std::make_shared<Arrays>();
    const Status filled = (flags & flag_double) != 0
                              ? get_blocks<double>(in, header, outline, arrays->blocks)
                              : get_blocks<float>(in, header, outline, arrays->blocks);
    if (!filled) {
        return filled.error();
    }
    arrays->nodes = std::move(outline.nodes);
    if (!make_boxes(outline.frames, *arrays)) {
        return bad("a frame that is none");
    }
    return WideTree({arrays->nodes, arrays->blocks.view(), extent_of(arrays->nodes)}, arrays);
}

} // namespace cd
