#include "client/import/gltf/gltf_scene.hpp"

#include "client/import/gltf/gltf_elements.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <array>
#include <utility>

namespace cd {

namespace {

/// The unit and the up axis of every glTF file (glTF 2.0, section 3.4).
const DeclaredFrame gltf_frame{"metre", 1, "Y"};

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
                return bad_input("its indices are not unsigned integers");
            }
            auto elements = CD_TRY(GltfElements::open(document, buffers, *primitive.indices));
            indices.count_ = elements.count();
            indices.elements_ = std::move(elements);
            indices.restart_ = (std::uint64_t{1} << (8 * size_of(accessor.type))) - 1;
        }
        return indices;
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }

    /// Returns the vertex at a position. Errors: BadInput naming the index.
    [[nodiscard]] Result<std::uint64_t> at(std::uint64_t place) const {
        if (!elements_) {
            return place;
        }
        const auto vertex = static_cast<std::uint64_t>(elements_->at(place, 0));
        if (vertex == restart_) { // glTF 2.0, section 3.7.2.1, forbids the restart value.
            return bad_input("index " + std::to_string(place) + " is " + std::to_string(vertex) +
                             ", which glTF does not allow: it marks the start of a new strip");
        }
        if (vertex >= vertices_) {
            return bad_input("index " + std::to_string(place) + " names vertex " +
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
        return bad_input(
            "its POSITION is not three floats, or integers as of KHR_mesh_quantization");
    }
    return GltfElements::open(document, buffers, accessor);
}

/// Numbers of triangles, lines and points in a primitive.
struct GltfShapes {
    std::uint64_t triangles = 0;
    std::uint64_t lines = 0;
    std::uint64_t points = 0;
};

Result<GltfShapes> whole(GltfShapes shapes, bool is_whole, std::uint64_t indices) {
    if (!is_whole) {
        return bad_input("its " + std::to_string(indices) +
                         " indices do not make whole triangles or lines");
    }
    return shapes;
}

/// Counts a primitive's triangles, lines and points. Errors: BadInput if the number of indices
/// leaves a triangle or a line incomplete.
Result<GltfShapes> count_shapes(GltfMode mode, std::uint64_t indices) {
    switch (mode) {
    case GltfMode::Points:
        return GltfShapes{0, 0, indices};
    case GltfMode::Lines:
        return whole({0, indices / 2, 0}, indices % 2 == 0, indices);
    case GltfMode::LineLoop:
        return whole({0, indices, 0}, indices != 1, indices);
    case GltfMode::LineStrip:
        return whole({0, indices - (indices > 0 ? 1 : 0), 0}, indices != 1, indices);
    case GltfMode::Triangles:
        return whole({indices / 3, 0, 0}, indices % 3 == 0, indices);
    case GltfMode::TriangleStrip:
    case GltfMode::TriangleFan:
        break;
    }
    return whole({indices < 3 ? 0 : indices - 2, 0, 0}, indices == 0 || indices > 2, indices);
}

/// Returns the positions of a triangle's corners in the list of indices, ordered so that all
/// triangles of a strip or a fan face the same way (glTF 2.0, section 3.7.2.1).
std::array<std::uint64_t, 3> corners_of(GltfMode mode, std::uint64_t triangle) {
    switch (mode) {
    case GltfMode::TriangleStrip:
        return triangle % 2 == 0 ? std::array{triangle, triangle + 1, triangle + 2}
                                 : std::array{triangle + 1,
                                              triangle,
                                              triangle + 2}; // Every other triangle is reversed.
    case GltfMode::TriangleFan:
        return {0, triangle + 1, triangle + 2};
    default:
        return {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
    }
}

double nearest_float(double number) {
    return static_cast<double>(static_cast<float>(number));
}

/// Returns the rotation of a quaternion of any length. Dividing by the squared length makes a
/// quarter turn that is given in floats exact.
Eigen::Matrix3d rotation_of(double x, double y, double z, double w) {
    const double s = 2 / (x * x + y * y + z * z + w * w);
    Eigen::Matrix3d r;
    r << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), //
        s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),  //
        s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
    return r;
}

Result<Eigen::Matrix4d> to_matrix(const GltfTransform& transform) {
    const auto& q = transform.rotation;
    const Eigen::Matrix3d rotation = rotation_of(
        nearest_float(q[0]), nearest_float(q[1]), nearest_float(q[2]), nearest_float(q[3]));
    if (!rotation.allFinite()) {
        return bad_input("its rotation is no quaternion of a length above zero");
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        matrix.block<3, 1>(0, axis) = nearest_float(transform.scale[i]) * rotation.col(axis);
        matrix(axis, 3) = nearest_float(transform.translation[i]);
    }
    return matrix;
}

/// Returns the map from a node's coordinates to its parent's (glTF 2.0, section 3.5.3). Exporters
/// compute transforms in float but may write more digits, so each number is rounded to the nearest
/// float, and all else is computed in double. Quaternions need not have length 1. Errors: BadInput
/// for a quaternion of zeros.
Result<Eigen::Matrix4d> to_parent(const GltfNode& node) {
    if (!node.matrix) {
        return to_matrix(node.transform);
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) { // The last row stays 0 0 0 1.
            matrix(row, column) =
                nearest_float((*node.matrix)[static_cast<std::size_t>(4 * column + row)]);
        }
    }
    return matrix;
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
            const Eigen::Matrix4d own =
                CD_TRY(within(place_of(nodes[i]), to_parent(document_.nodes[nodes[i]])));
            waiting.push_back({nodes[i], parent * own});
        }
        return Done{};
    };
    CD_TRY(push(document_.roots, Eigen::Matrix4d::Identity()));
    while (!waiting.empty()) {
        const Visit visit = waiting.back();
        waiting.pop_back();
        CD_TRY(within(place_of(visit.node), add_node(visit.node, visit.to_world)));
        CD_TRY(push(document_.nodes[visit.node].children, visit.to_world));
    }
    auto mesh = CD_TRY(builder_.finish(Precision::Float));
    imported_.mesh = std::make_shared<const Mesh>(std::move(mesh));
    return std::move(imported_);
}

Status GltfScene::check_rigid(std::size_t number) const {
    const GltfNode& node = document_.nodes[number];
    if (node.skin) {
        return bad_input(
            "its mesh is deformed by skin " + std::to_string(*node.skin) +
            ", and only rigid meshes are read; apply the skin in the program that wrote the file "
            "(in Blender, apply the armature modifier)");
    }
    if (node.is_morphed.value_or(document_.meshes[*node.mesh].is_morphed)) {
        return bad_input(
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
    CD_TRY(check_rigid(number));
    const auto placed = CD_TRY(instances(node));
    const GltfMesh& mesh = document_.meshes[*node.mesh];
    for (const Eigen::Matrix4d& instance : placed) {
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            builder_.begin_part(part_name(number, i));
            const std::string place =
                "mesh " + std::to_string(*node.mesh) + ", primitive " + std::to_string(i) + ": ";
            CD_TRY(within(place, add_primitive(mesh.primitives[i], to_world * instance)));
        }
    }
    return Done{};
}

/// Returns the transforms of a node's instances (EXT_mesh_gpu_instancing) relative to it.
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
        const auto elements = CD_TRY(GltfElements::open(document_, buffers_, *accessor));
        const std::uint64_t count = elements.count();
        if (document_.accessors[*accessor].width != width ||
            (!is_first && count != transforms.size())) {
            return bad_input(
                "its EXT_mesh_gpu_instancing has an accessor of another count or type: " +
                std::to_string(*accessor));
        }
        transforms.resize(count);
        is_first = false;
        for (std::uint64_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < width; ++k) {
                numbers_of(transforms[i])[k] = elements.at(i, k);
            }
        }
        return Done{};
    };
    CD_TRY(read(node.instances->translation, 3, [](auto& t) { return t.translation.data(); }));
    CD_TRY(read(node.instances->rotation, 4, [](auto& t) { return t.rotation.data(); }));
    CD_TRY(read(node.instances->scale, 3, [](auto& t) { return t.scale.data(); }));
    std::vector<Eigen::Matrix4d> matrices;
    for (const GltfTransform& transform : transforms) {
        const std::string place = "instance " + std::to_string(matrices.size()) + ": ";
        matrices.push_back(CD_TRY(within(place, to_matrix(transform))));
    }
    return matrices;
}

Status GltfScene::add_primitive(const GltfPrimitive& primitive, const Eigen::Matrix4d& to_world) {
    const auto positions = CD_TRY(open_positions(document_, buffers_, primitive.positions));
    const auto indices =
        CD_TRY(GltfIndices::open(document_, buffers_, primitive, positions.count()));
    const auto shapes = CD_TRY(count_shapes(primitive.mode, indices.count()));
    imported_.points_skipped += shapes.points;
    imported_.lines_skipped += shapes.lines;
    if (builder_.triangle_count() + shapes.triangles > limits::mesh_triangles_max) {
        return Error{ErrorCode::TooLarge, "the scene has more triangles than a mesh may have"};
    }
    for (std::uint64_t t = 0; t < shapes.triangles; ++t) {
        Corners corners;
        const auto places = corners_of(primitive.mode, t);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto vertex = CD_TRY(indices.at(places[k]));
            const Eigen::Vector4d position(
                positions.at(vertex, 0), positions.at(vertex, 1), positions.at(vertex, 2), 1);
            const Eigen::Vector4d world = to_world * position;
            const Vec3 scaled = factor_ * Vec3(world.x(), world.y(), world.z());
            corners[k] = scaled.cast<float>().cast<double>();
            if (!corners[k].allFinite()) {
                return bad_input("vertex " + std::to_string(vertex) +
                                 " has a coordinate that is not finite");
            }
        }
        builder_.add(corners);
    }
    return Done{};
}

/// Returns the name of a primitive's part. The only root of a scene gives it the mesh's name, which
/// says more than the node's. Unnamed nodes and meshes are numbered as assimp does.
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
