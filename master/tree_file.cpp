#include "master/tree_file.hpp"

#include "common/tree/cut.hpp"
#include "master/disk_file.hpp"

#include <utility>

namespace cd {

namespace {

constexpr FileKind kind{0x31'45'45'52'54'44'43'00, 1}; // "\0CDTREE1"

constexpr std::size_t node_bytes = sizeof(ObbNode::axes) + sizeof(ObbNode::center) +
                                   sizeof(ObbNode::half) + 3 * sizeof(std::uint32_t);

template <class T, std::size_t N>
void put_all(ByteWriter& out, const std::array<T, N>& values) {
    out.put_array(std::span<const T>(values));
}

Bytes encode_nodes(std::span<const ObbNode> nodes) {
    ByteWriter out;
    for (const ObbNode& node : nodes) {
        put_all(out, node.axes);
        put_all(out, node.center);
        put_all(out, node.half);
        out.put(node.right);
        out.put(node.triangles_begin);
        out.put(node.triangles_end);
    }
    return out.take();
}

template <class T, std::size_t N>
void get_into(ByteReader& in, std::array<T, N>& values) {
    for (T& value : values) {
        value = in.get<T>();
    }
}

void put_topology(ByteWriter& out, const Topology& topology) {
    for (const std::uint64_t count : {topology.degenerate,
                                      topology.duplicate,
                                      topology.boundary_edges,
                                      topology.non_manifold_edges,
                                      topology.inconsistent_edges}) {
        out.put(count);
    }
    out.put(static_cast<std::uint64_t>(topology.component_triangles.size()));
    out.put_array(std::span<const std::uint32_t>(topology.component_triangles));
}

Topology get_topology(ByteReader& in) {
    Topology topology;
    topology.degenerate = in.get<std::uint64_t>();
    topology.duplicate = in.get<std::uint64_t>();
    topology.boundary_edges = in.get<std::uint64_t>();
    topology.non_manifold_edges = in.get<std::uint64_t>();
    topology.inconsistent_edges = in.get<std::uint64_t>();
    topology.component_triangles = in.get_array<std::uint32_t>(in.get<std::uint64_t>());
    return topology;
}

std::vector<ObbNode> get_nodes(ByteReader& in) {
    const auto count = in.get<std::uint64_t>();
    if (count > in.remaining() / node_bytes) {
        return {}; // What is left over then tells.
    }
    std::vector<ObbNode> nodes(count);
    for (ObbNode& node : nodes) {
        get_into(in, node.axes);
        get_into(in, node.center);
        get_into(in, node.half);
        node.right = in.get<std::uint32_t>();
        node.triangles_begin = in.get<std::uint32_t>();
        node.triangles_end = in.get<std::uint32_t>();
    }
    return nodes;
}

bool is_permutation_of_triangles(std::span<const std::uint32_t> ids, std::size_t triangles) {
    std::vector<bool> seen(triangles, false);
    for (const std::uint32_t id : ids) {
        if (id >= triangles || seen[id]) {
            return false;
        }
        seen[id] = true;
    }
    return ids.size() == triangles;
}

bool all_below(std::span<const std::uint32_t> values, std::size_t limit) {
    for (const std::uint32_t value : values) {
        if (value >= limit) {
            return false;
        }
    }
    return true;
}

} // namespace

Status write_tree_file(const std::filesystem::path& path, const ObbTree& tree) {
    ByteWriter out;
    put_hash(out, tree.mesh().hash());
    out.put(static_cast<std::uint64_t>(tree.nodes().size()));
    put_bytes(out, encode_nodes(tree.nodes()));
    out.put(static_cast<std::uint64_t>(tree.triangle_ids().size()));
    out.put_array(tree.triangle_ids());
    put_topology(out, tree.topology());
    return write_checked(path, kind, out.bytes());
}

Result<std::shared_ptr<const ObbTree>> read_tree_file(const std::filesystem::path& path,
                                                      std::shared_ptr<const Mesh> mesh) {
    const Result<Bytes> content = read_checked(path, kind);
    if (!content) {
        return content.error();
    }
    const auto damaged = [&](const std::string& why) {
        return Error{ErrorCode::Io, path.string() + " is damaged: " + why};
    };
    ByteReader in(content.value());
    if (get_hash(in) != mesh->hash()) {
        return damaged("it belongs to another mesh");
    }
    std::vector<ObbNode> nodes = get_nodes(in);
    std::vector<std::uint32_t> ids = in.get_array<std::uint32_t>(in.get<std::uint64_t>());
    Topology topology = get_topology(in);
    const std::size_t triangles = mesh->triangles().size();
    if (!in.complete() || nodes.empty()) {
        return damaged("it is cut short or too long");
    }
    if (!is_permutation_of_triangles(ids, triangles) ||
        !all_below(topology.component_triangles, triangles)) {
        return damaged("its triangles are not those of the mesh");
    }
    const Result<TreeTop> checked = make_tree_top(nodes);
    if (!checked) {
        return damaged(checked.error().detail);
    }
    if (nodes.front().triangles_begin != 0 || nodes.front().triangles_end != triangles) {
        return damaged("its root does not hold all triangles");
    }
    return std::shared_ptr<const ObbTree>(std::make_shared<ObbTree>(
        std::move(mesh), std::move(nodes), std::move(ids), std::move(topology)));
}

std::uint64_t tree_checksum(const ObbTree& tree) {
    const std::array<std::uint64_t, 2> parts{checksum(encode_nodes(tree.nodes())),
                                             checksum(std::as_bytes(tree.triangle_ids()))};
    return checksum(std::as_bytes(std::span<const std::uint64_t>(parts)));
}

} // namespace cd
