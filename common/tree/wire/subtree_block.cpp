#include "common/tree/wire/subtree_block.hpp"

#include "common/core/check.hpp"
#include "common/core/varint.hpp"
#include "common/tree/wire/byte_planes.hpp"
#include "common/tree/wire/node_columns.hpp"
#include "common/tree/wire/wide_block.hpp"

#include <algorithm>
#include <concepts>
#include <utility>

namespace cd {

namespace {

constexpr std::uint8_t version = 1;
constexpr std::uint8_t flag_double = 1;
constexpr std::uint8_t flag_wide_indices = 2;

/// Returns whether corners need 32 bits: their distances (`put_corners`) reach the number of
/// vertices.
bool needs_wide_indices(std::size_t vertices) {
    return vertices > UINT16_MAX;
}

// ---- Triangles -------------------------------------------------------------------------------

/// Encodes each corner as its distance behind the lowest vertex number not used so far: 0 is that
/// new vertex. Vertices are numbered by first use, so that most distances are small.
template <std::unsigned_integral Index>
void put_corners(ByteWriter& out, std::span<const Triangle> triangles, std::size_t vertices) {
    std::vector<Index> distances;
    distances.reserve(3 * triangles.size());
    std::uint32_t next = 0;
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            CD_CHECK(vertex <= next);
            distances.push_back(static_cast<Index>(next - vertex));
            next += vertex == next ? 1 : 0;
        }
    }
    CD_CHECK(next == vertices);
    put_planes(out, std::span<const Index>(distances));
}

/// Decodes corners. Returns an empty vector when a corner names no vertex, or a vertex is unused.
template <std::unsigned_integral Index>
std::vector<Triangle> get_corners(ByteReader& in, std::size_t count, std::size_t vertices) {
    const auto distances = get_planes<Index>(in, 3 * count);
    if (in.failed()) {
        return {};
    }
    std::vector<Triangle> triangles(count);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (distances[i] > next || (distances[i] == 0 && next == vertices)) {
            return {};
        }
        triangles[i / 3][i % 3] = next - distances[i];
        next += distances[i] == 0 ? 1 : 0;
    }
    return next == vertices ? triangles : std::vector<Triangle>{};
}

void put_ids(ByteWriter& out, std::span<const std::uint32_t> ids) {
    std::vector<std::uint32_t> steps;
    steps.reserve(ids.size());
    std::uint32_t before = 0;
    for (const std::uint32_t id : ids) {
        // Steps are modulo 2^32, so that every step fits.
        steps.push_back(static_cast<std::uint32_t>(zigzag(static_cast<std::int32_t>(id - before))));
        before = id;
    }
    put_planes(out, std::span<const std::uint32_t>(steps));
}

std::vector<std::uint32_t> get_ids(ByteReader& in, std::size_t count) {
    auto ids = get_planes<std::uint32_t>(in, count);
    std::uint32_t before = 0;
    for (std::uint32_t& id : ids) {
        before += static_cast<std::uint32_t>(unzigzag(id));
        id = before;
    }
    return ids;
}

// ---- Vertices --------------------------------------------------------------------------------

template <class Float>
void put_vertices(ByteWriter& out, std::span<const Vec3> vertices) {
    for (int k = 0; k < 3; ++k) {
        put_column<Float>(out, vertices.size(), [&](std::size_t i) { return vertices[i][k]; });
    }
}

template <class Float>
bool get_vertices(ByteReader& in, std::vector<Vec3>& vertices) {
    bool complete = true;
    for (int k = 0; k < 3; ++k) {
        complete =
            complete && get_column<Float>(in, vertices.size(), [&](std::size_t i) -> double& {
                return vertices[i][k];
            });
    }
    return complete && std::all_of(vertices.begin(), vertices.end(), [](const Vec3& vertex) {
               return vertex.allFinite();
           });
}

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("subtree block: ") + what};
}

} // namespace

Bytes encode_subtree(const Subtree& subtree) {
    const TreeView view = subtree.view();
    if (subtree.form() == SubtreeForm::Wide) {
        return encode_wide_block(view.wide);
    }
    const bool is_double = precision_of(view.vertices) == Precision::Double;
    const bool is_wide = needs_wide_indices(view.vertices.size());
    ByteWriter out;
    out.put(version);
    out.put(static_cast<std::uint8_t>((is_double ? flag_double : 0) |
                                      (is_wide ? flag_wide_indices : 0)));
    out.put(static_cast<std::uint32_t>(view.nodes.size()));
    out.put(static_cast<std::uint32_t>(view.vertices.size()));
    out.put(static_cast<std::uint32_t>(view.triangles.size()));
    put_nodes(out, view.nodes);
    if (is_double) {
        put_vertices<double>(out, view.vertices);
    } else {
        put_vertices<float>(out, view.vertices);
    }
    if (is_wide) {
        put_corners<std::uint32_t>(out, view.triangles, view.vertices.size());
    } else {
        put_corners<std::uint16_t>(out, view.triangles, view.vertices.size());
    }
    put_ids(out, view.triangle_ids);
    return out.take();
}

Result<Subtree> decode_subtree(std::span<const std::byte> bytes) {
    if (!bytes.empty() && std::to_integer<std::uint8_t>(bytes[0]) == wide_block_version) {
        Result<WideTree> wide = decode_wide_block(bytes);
        return wide ? Result<Subtree>(Subtree(std::move(wide.value()))) : wide.error();
    }
    ByteReader in(bytes);
    if (in.get<std::uint8_t>() != version) {
        return bad("unknown version");
    }
    const auto flags = in.get<std::uint8_t>();
    const auto node_count = in.get<std::uint32_t>();
    const auto vertex_count = in.get<std::uint32_t>();
    const auto triangle_count = in.get<std::uint32_t>();
    const bool is_double = (flags & flag_double) != 0;
    const bool is_wide = (flags & flag_wide_indices) != 0;
    // A vertex takes at least 12 bytes, a triangle 10: nothing is allocated that the bytes cannot
    // hold.
    if (in.failed() || flags > (flag_double | flag_wide_indices) || node_count == 0 ||
        triangle_count == 0 || is_wide != needs_wide_indices(vertex_count) ||
        node_count > in.remaining() / node_bytes_min || vertex_count > in.remaining() / 12 ||
        triangle_count > in.remaining() / 10) {
        return bad("a header that does not fit the bytes");
    }
    std::vector<ObbNode> nodes(node_count);
    if (!get_nodes(in, nodes, triangle_count)) {
        return bad("nodes that are no tree of boxes");
    }
    std::vector<Vec3> vertices(vertex_count, Vec3::Zero());
    if (!(is_double ? get_vertices<double>(in, vertices) : get_vertices<float>(in, vertices))) {
        return bad("vertices cut short or not finite");
    }
    auto triangles = is_wide ? get_corners<std::uint32_t>(in, triangle_count, vertex_count)
                             : get_corners<std::uint16_t>(in, triangle_count, vertex_count);
    auto ids = get_ids(in, triangle_count);
    if (!in.complete() || triangles.empty()) {
        return bad("triangles that do not fit the vertices, or a wrong length");
    }
    return Subtree(std::move(nodes), std::move(vertices), std::move(triangles), std::move(ids));
}

} // namespace cd
