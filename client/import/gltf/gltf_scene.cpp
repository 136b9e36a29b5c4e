#include "client/import/gltf/gltf_scene.hpp"

#include "client/import/gltf/gltf_corners.hpp"
#include "client/import/gltf/gltf_elements.hpp"
#include "common/core/limits/engine.hpp"

#include <utility>

namespace cd {

namespace {

/// glTF fixes the unit and the up axis (section 3.4).
const DeclaredFrame gltf_frame{"metre", 1, "Y"};

Error bad(const std::string& what) {
    return {ErrorCode::BadInput, what};
}

std::string numbered(const char* kind, std::size_t number) {
    return std::string(kind) + "[" + std::to_string(number) + "]";
}

/// Maps positions in the list of indices to vertices; without a list, position i is vertex i.
class GltfIndices {
  public:
    [[nodiscard]] static Result<GltfIndices> open(const GltfDocument& document,
                                                  const GltfBuffers& buffers,
                                                  const GltfPrimitive& primitive,
                                                  std::uint64_t vertices) {
        GltfIndices indices;
        indices.vertices_ = vertices;
        indices.count_ = vertices;
        if (primitive.indices) {
            const GltfAccessor& accessor = document.accessors[*primitive.indices];
            const bool is_unsigned = accessor.type == GltfNumber::U8 ||
                                     accessor.type == GltfNumber::U16 ||
                                     accessor.type == GltfNumber::U32;
            if (!is_unsigned || accessor.is_normalized || accessor.width != 1) {
                return bad("its indices are not unsigned integers");
            }
            auto elements = GltfElements::open(document, buffers, *primitive.indices);
            if (!elements) {
                return elements.error();
            }
            indices.count_ = elements.value().count();
            indices.elements_ = std::move(elements.value());
            indices.restart_ = (std::uint64_t{1} << (8 * size_of(accessor.type))) - 1;
        }
        return indices;
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }

    /// Errors: BadInput naming the index.
    [[nodiscard]] Result<std::uint64_t> at(std::uint64_t place) const {
        if (!elements_) {
            return place;
        }
        const auto vertex = static_cast<std::uint64_t>(elements_->at(place, 0));
        if (vertex == restart_) { // Section 3.7.2.1 forbids the restart value.
            return bad("index " + std::to_string(place) + " is " + std::to_string(vertex) +
                       ", which glTF does not allow: it stands for the begin of a new strip");
        }
        if (vertex >= vertices_) {
            return bad("index " + std::to_string(place) + " names vertex " +
                       std::to_string(vertex) + " of " + std::to_string(vertices_));
        }
        return vertex;
    }

  private:
    std::optional<GltfElements> elements_;
    std::uint64_t count_ = 0;
    std::uint64_t vertices_ = 0;
    std::uint64_t restart_ = 0;
};

Result<GltfElements>
open_positions(const GltfDocument& document, const GltfBuffers& buffers, std::size_t accessor) {
    const GltfAccessor& positions = document.accessors[accessor];
    const bool is_wide_integer = positions.type == GltfNumber::U32;
    const bool is_float = positions.type == GltfNumber::F32;
    if (positions.width != 3 || is_wide_integer || (is_float && positions.is_normalized)) {
        return bad("its POSITION is not three floats, or integers as of KHR_mesh_quantization");
    }
    return GltfElements::open(document, buffers, accessor);
}

} // namespace

GltfScene::GltfScene(const GltfDocument& document,
                     const GltfBuffers& buffers,
                     const ImportOptions& options)
    : document_(document), buffers_(buffers), factor_(factor_of(options, gltf_frame)) {
    imported_.declared = gltf_frame;
}

Result<ImportedMesh> GltfScene::read() {
    struct Visit {
        std::size_t node;
        Eigen::Matrix4d to_world;
    };
    const auto place_of = [](std::size_t node) { return "node " + std::to_string(node) + ": "; };
    std::vector<Visit> waiting;
    const auto push = [&](const std::vector<std::size_t>& nodes,
                          const Eigen::Matrix4d& parent) -> Status {
        for (std::size_t i = nodes.size(); i-- > 0;) {
            const auto own = to_parent(document_.nodes[nodes[i]]);
            if (!own) {
                return bad(place_of(nodes[i]) + own.error().detail);
            }
            waiting.push_back({nodes[i], parent * own.value()});
        }
        return Done{};
    };
    Status status = push(document_.roots, Eigen::Matrix4d::Identity());
    while (status && !waiting.empty()) {
        const Visit visit = waiting.back();
        waiting.pop_back();
        if (const Status added = add_node(visit.node, visit.to_world); !added) {
            return bad(place_of(visit.node) + added.error().detail);
        }
        status = push(document_.nodes[visit.node].children, visit.to_world);
    }
    if (!status) {
        return status.error();
    }
    auto mesh = builder_.finish(Precision::Float);
    if (!mesh) {
        return mesh.error();
    }
    imported_.mesh = std::make_shared<const Mesh>(std::move(mesh.value()));
    return std::move(imported_);
}

Status GltfScene::check_rigid(std::size_t number) const {
    const GltfNode& node = document_.nodes[number];
    if (node.skin) {
        return bad(
            "its mesh is deformed by skin " + std::to_string(*node.skin) +
            ", and only rigid meshes are read; apply the skin in the program that wrote the file "
            "(in Blender, apply the armature modifier)");
    }
    if (node.is_morphed.value_or(document_.meshes[*node.mesh].is_morphed)) {
        return bad(
            "its mesh is deformed by morph targets, and only rigid meshes are read; apply them "
            "in the program that wrote the file, or set their weights to zero");
    }
    return Done{};
}

Status GltfScene::add_node(std::size_t number, const Eigen::Matrix4d& to_world) {
    const GltfNode& node = document_.nodes[number];
    if (!node.mesh) {
        return Done{};
    }
    if (Status rigid = check_rigid(number); !rigid) {
        return rigid;
    }
    const auto placed = instances(node);
    if (!placed) {
        return placed.error();
    }
    const GltfMesh& mesh = document_.meshes[*node.mesh];
    for (const Eigen::Matrix4d& instance : placed.value()) {
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            builder_.begin_part(part_name(number, i));
            const Status added = add_primitive(mesh.primitives[i], to_world * instance);
            if (!added) {
                return bad("mesh " + std::to_string(*node.mesh) + ", primitive " +
                           std::to_string(i) + ": " + added.error().detail);
            }
        }
    }
    return Done{};
}

/// The transforms of a node's instances (EXT_mesh_gpu_instancing), relative to the node.
Result<std::vector<Eigen::Matrix4d>> GltfScene::instances(const GltfNode& node) const {
    if (!node.instances) {
        return std::vector<Eigen::Matrix4d>{Eigen::Matrix4d::Identity()};
    }
    std::vector<GltfTransform> transforms;
    bool is_first = true;
    const auto read =
        [&](std::optional<std::size_t> accessor, std::size_t width, auto numbers_of) -> Status {
        if (!accessor) {
            return Done{};
        }
        const auto elements = GltfElements::open(document_, buffers_, *accessor);
        if (!elements) {
            return elements.error();
        }
        const std::uint64_t count = elements.value().count();
        if (document_.accessors[*accessor].width != width ||
            (!is_first && count != transforms.size())) {
            return bad("its EXT_mesh_gpu_instancing has an accessor of another count or type: " +
                       std::to_string(*accessor));
        }
        transforms.resize(count);
        is_first = false;
        for (std::uint64_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < width; ++k) {
                numbers_of(transforms[i])[k] = elements.value().at(i, k);
            }
        }
        return Done{};
    };
    for (const Status& status :
         {read(node.instances->translation, 3, [](auto& t) { return t.translation.data(); }),
          read(node.instances->rotation, 4, [](auto& t) { return t.rotation.data(); }),
          read(node.instances->scale, 3, [](auto& t) { return t.scale.data(); })}) {
        if (!status) {
            return status.error();
        }
    }
    std::vector<Eigen::Matrix4d> matrices;
    for (const GltfTransform& transform : transforms) {
        const auto matrix = to_matrix(transform);
        if (!matrix) {
            return bad("instance " + std::to_string(matrices.size()) + ": " +
                       matrix.error().detail);
        }
        matrices.push_back(matrix.value());
    }
    return matrices;
}

Status GltfScene::add_primitive(const GltfPrimitive& primitive, const Eigen::Matrix4d& to_world) {
    const auto positions = open_positions(document_, buffers_, primitive.positions);
    if (!positions) {
        return positions.error();
    }
    const auto indices =
        GltfIndices::open(document_, buffers_, primitive, positions.value().count());
    if (!indices) {
        return indices.error();
    }
    const auto shapes = count_shapes(primitive.mode, indices.value().count());
    if (!shapes) {
        return shapes.error();
    }
    imported_.points_skipped += shapes.value().points;
    imported_.lines_skipped += shapes.value().lines;
    if (builder_.triangle_count() + shapes.value().triangles > limits::mesh_triangles_max) {
        return Error{ErrorCode::TooLarge, "the scene has more triangles than a mesh may have"};
    }
    for (std::uint64_t t = 0; t < shapes.value().triangles; ++t) {
        Corners corners;
        const auto places = corners_of(primitive.mode, t);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto vertex = indices.value().at(places[k]);
            if (!vertex) {
                return vertex.error();
            }
            const Eigen::Vector4d position(positions.value().at(vertex.value(), 0),
                                           positions.value().at(vertex.value(), 1),
                                           positions.value().at(vertex.value(), 2),
                                           1);
            const Eigen::Vector4d world = to_world * position;
            const Vec3 scaled = factor_ * Vec3(world.x(), world.y(), world.z());
            corners[k] = scaled.cast<float>().cast<double>();
            if (!corners[k].allFinite()) {
                return bad("vertex " + std::to_string(vertex.value()) +
                           " has a coordinate that is not finite");
            }
        }
        builder_.add(corners);
    }
    return Done{};
}

/// The name of a primitive's part. At the only root of a scene it is the mesh's name, which says
/// more than the node's. Unnamed nodes and meshes are numbered as assimp does.
std::string GltfScene::part_name(std::size_t number, std::size_t primitive) const {
    const GltfNode& node = document_.nodes[number];
    const GltfMesh& mesh = document_.meshes[*node.mesh];
    const std::string of_mesh = mesh.name.empty() ? numbered("meshes", *node.mesh) : mesh.name;
    if (mesh.primitives.size() > 1) {
        return of_mesh + "-" + std::to_string(primitive);
    }
    const bool is_whole_scene = document_.roots.size() == 1 && document_.roots[0] == number;
    if (is_whole_scene) {
        return of_mesh;
    }
    return node.name.empty() ? numbered("nodes", number) : node.name;
}

} // namespace cd
