#include "common/tree/tree_file.hpp"

#include "common/core/files/section_file.hpp"
#include "common/tree/node_check.hpp"
#include "common/tree/wide/wide_check.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <array>
#include <utility>

namespace cd {

namespace {

constexpr FileKind binary_kind{0x32'45'45'52'54'44'43'00, 1}; // "\0CDTREE2"
constexpr FileKind wide_kind{0x31'45'44'49'57'44'43'00, 1};   // "\0CDWIDE1"

/// Both kinds of files begin with the topology.
enum TopologySection : std::size_t { counts, component_triangles, topology_sections };
enum BinarySection : std::size_t { nodes = topology_sections, triangle_ids, binary_sections };
enum WideSection : std::size_t {
    sizes = topology_sections, ///< Two doubles: `WideView::extent` and `TriangleBlocks::reach`.
    wide_nodes,
    floats,
    doubles,
    vertex_begin,
    corners,
    ids,
    wide_sections
};

template <class Array>
Section bytes_of(const Array& array) {
    return std::as_bytes(std::span(array));
}

std::array<std::uint64_t, 5> counts_of(const Topology& topology) {
    return {topology.degenerate,
            topology.duplicate,
            topology.boundary_edges,
            topology.non_manifold_edges,
            topology.inconsistent_edges};
}

Result<Topology> read_topology(const SectionFile& file, std::size_t triangles) {
    const auto numbers = file.array<std::uint64_t>(counts);
    const auto components = file.array<std::uint32_t>(component_triangles);
    if (!numbers || numbers.value().size() != 5 || !components) {
        return Error{ErrorCode::Io, "its topology has a wrong size"};
    }
    for (const std::uint32_t triangle : components.value()) {
        if (triangle >= triangles) {
            return Error{ErrorCode::Io, "its triangles are not those of the mesh"};
        }
    }
    const std::span<const std::uint64_t> n = numbers.value();
    return Topology{
        n[0], n[1], n[2], n[3], n[4], {components.value().begin(), components.value().end()}};
}

/// Owns the arrays of a tree that was read from a file.
struct BinaryArrays {
    std::shared_ptr<const SectionFile> file;
    std::vector<Triangle> triangles;
};

Result<BinaryTree> binary_tree_of(std::shared_ptr<const SectionFile> file, const Mesh& mesh) {
    const auto tree_nodes = file->array<ObbNode>(nodes);
    const auto order = file->array<std::uint32_t>(triangle_ids);
    if (!tree_nodes || !order) {
        return Error{ErrorCode::Io, "its arrays have wrong sizes"};
    }
    if (!is_permutation_of_triangles(order.value(), mesh.triangles().size())) {
        return Error{ErrorCode::Io, "its triangles are not those of the mesh"};
    }
    if (!is_tree_over(tree_nodes.value(), mesh.triangles().size())) {
        return Error{ErrorCode::Io, "its nodes are no tree"};
    }
    auto arrays = std::make_shared<BinaryArrays>();
    arrays->triangles.reserve(order.value().size());
    for (const std::uint32_t id : order.value()) {
        arrays->triangles.push_back(mesh.triangles()[id]);
    }
    arrays->file = std::move(file);
    return BinaryTree{tree_nodes.value(), order.value(), arrays->triangles, arrays};
}

Result<std::shared_ptr<const WideTree>> wide_tree_of(std::shared_ptr<const SectionFile> file,
                                                     std::size_t triangles) {
    const auto numbers = file->array<double>(sizes);
    const auto all_nodes = file->array<WideNode>(wide_nodes);
    const auto all_floats = file->array<float>(floats);
    const auto all_doubles = file->array<double>(doubles);
    const auto begins = file->array<std::uint32_t>(vertex_begin);
    const auto all_corners = file->array<BlockCorners>(corners);
    const auto all_ids = file->array<std::uint32_t>(ids);
    if (!numbers || numbers.value().size() != 2 || !all_nodes || !all_floats || !all_doubles ||
        !begins || !all_corners || !all_ids) {
        return Error{ErrorCode::Io, "its arrays have wrong sizes"};
    }
    const WideView view{all_nodes.value(),
                        {all_floats.value(),
                         all_doubles.value(),
                         begins.value(),
                         all_corners.value(),
                         all_ids.value(),
                         numbers.value()[1]},
                        numbers.value()[0]};
    if (const Status checked = check_wide_tree(view, triangles); !checked) {
        return checked.error();
    }
    return std::make_shared<const WideTree>(view, std::move(file));
}

} // namespace

Sha256 tree_key(const Sha256& mesh, const BuildOptions& options) {
    ByteWriter out;
    put_hash(out, mesh);
    out.put(tree_build_version);
    out.put(static_cast<std::uint8_t>(options.boxes));
    out.put(static_cast<std::uint8_t>(options.rule));
    out.put(options.leaf_triangles_max);
    out.put(options.sweep_triangles_max);
    return sha256(out.bytes());
}

Status write_tree_file(const std::filesystem::path& path,
                       const ObbTree& tree,
                       const Sha256& key,
                       Durability durability) {
    const auto numbers = counts_of(tree.topology());
    const std::array<Section, binary_sections> sections{
        bytes_of(numbers),
        bytes_of(tree.topology().component_triangles),
        bytes_of(tree.nodes()),
        bytes_of(tree.triangle_ids())};
    return write_section_file(path, {binary_kind, key}, sections, durability);
}

Status write_wide_tree_file(const std::filesystem::path& path,
                            const ObbTree& tree,
                            const Sha256& key,
                            Durability durability) {
    const WideView view = tree.view().wide;
    const auto numbers = counts_of(tree.topology());
    const std::array<double, 2> lengths{view.extent, view.triangles.reach};
    const std::array<Section, wide_sections> sections{bytes_of(numbers),
                                                      bytes_of(tree.topology().component_triangles),
                                                      bytes_of(lengths),
                                                      bytes_of(view.nodes),
                                                      bytes_of(view.triangles.floats),
                                                      bytes_of(view.triangles.doubles),
                                                      bytes_of(view.triangles.vertex_begin),
                                                      bytes_of(view.triangles.corners),
                                                      bytes_of(view.triangles.ids)};
    return write_section_file(path, {wide_kind, key}, sections, durability);
}

Result<std::shared_ptr<const ObbTree>> read_tree_file(const std::filesystem::path& path,
                                                      std::shared_ptr<const Mesh> mesh,
                                                      const Sha256& key) {
    const auto file = SectionFile::open(path, {binary_kind, key}, binary_sections);
    if (!file) {
        return file.error();
    }
    Result<Topology> topology = read_topology(*file.value(), mesh->triangles().size());
    if (!topology) {
        return damaged_file(path, topology.error().detail);
    }
    Result<BinaryTree> binary = binary_tree_of(file.value(), *mesh);
    if (!binary) {
        return damaged_file(path, binary.error().detail);
    }
    return std::make_shared<const ObbTree>(
        std::move(mesh), std::move(binary.value()), nullptr, std::move(topology.value()));
}

Result<std::shared_ptr<const ObbTree>> read_wide_tree_file(const std::filesystem::path& path,
                                                           std::shared_ptr<const Mesh> mesh,
                                                           const Sha256& key) {
    const auto file = SectionFile::open(path, {wide_kind, key}, wide_sections);
    if (!file) {
        return file.error();
    }
    Result<Topology> topology = read_topology(*file.value(), mesh->triangles().size());
    if (!topology) {
        return damaged_file(path, topology.error().detail);
    }
    Result<std::shared_ptr<const WideTree>> wide =
        wide_tree_of(file.value(), mesh->triangles().size());
    if (!wide) {
        return damaged_file(path, wide.error().detail);
    }
    return std::make_shared<const ObbTree>(
        std::move(mesh), BinaryTree{}, std::move(wide.value()), std::move(topology.value()));
}

std::uint64_t tree_checksum(const ObbTree& tree) {
    const std::array<std::uint64_t, 2> parts{checksum(bytes_of(tree.nodes())),
                                             checksum(bytes_of(tree.triangle_ids()))};
    return checksum(bytes_of(parts));
}

} // namespace cd
