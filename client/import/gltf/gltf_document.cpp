#include "client/import/gltf/gltf_document.hpp"

#include "client/import/gltf/gltf_fields.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cd {

namespace {

using Json = nlohmann::json;

/// Extensions that are supported, or that do not change triangles.
constexpr std::array<std::string_view, 35> harmless_extensions{
    "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_common",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_materials_volume_scatter",
    "KHR_techniques_webgl",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "EXT_materials_bump",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
    "MSFT_texture_dds",
    "ADOBE_materials_clearcoat_specular",
    "ADOBE_materials_clearcoat_tint",
};

constexpr std::array<const char*, 3> compressions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};

std::string compressed_by(std::string_view extension) {
    return "its geometry is compressed by " + std::string(extension) +
           ", which is not read; write the file without compression (gltf-transform copy IN OUT "
           "unpacks it)";
}

/// Refuses the first unknown name in `extensionsRequired`: a reader that does not know a required
/// extension must refuse the file (glTF 2.0, section 3.12). `file` is the document's root object.
void refuse_unknown_extensions(const GltfFields& file) {
    for (const Json& entry : file.list("extensionsRequired")) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
        if (std::ranges::find(compressions, name) != compressions.end()) {
            file.refuse(compressed_by(name));
        } else if (std::ranges::find(harmless_extensions, name) == harmless_extensions.end()) {
            file.refuse("requires the extension " + name +
                        ", which is not supported; export the file without it");
        }
    }
}

/// Refuses an object whose geometry is compressed by an extension.
void refuse_compression(const GltfFields& object) {
    const auto extensions = object.object("extensions");
    for (const char* name : compressions) {
        if (extensions && extensions->has(name)) {
            object.refuse(compressed_by(name));
        }
    }
}

Error bad(std::size_t node, const std::string& what) {
    return bad_input("node " + std::to_string(node) + ": " + what);
}

/// Checks that each node has at most one parent (glTF 2.0, section 3.5.2). Otherwise the paths
/// through a few nodes could number 2^1000.
Status check_parents(const GltfDocument& document) {
    std::vector<bool> is_child(document.nodes.size(), false);
    for (const GltfNode& node : document.nodes) {
        for (const std::size_t child : node.children) {
            if (is_child[child]) {
                return bad(child, "is the child of two nodes");
            }
            is_child[child] = true;
        }
    }
    std::vector<bool> is_root(document.nodes.size(), false);
    for (const std::size_t root : document.roots) {
        if (is_child[root] || is_root[root]) {
            return bad(root,
                       is_child[root] ? "is a root of the scene and the child of a node"
                                      : "is a root of the scene twice");
        }
        is_root[root] = true;
    }
    return Done{};
}

Status check_depth(const GltfDocument& document) {
    std::vector<std::size_t> level = document.roots;
    for (std::size_t depth = 1; !level.empty(); ++depth) {
        if (depth > limits::mesh_file_depth_max) {
            return bad(level.front(),
                       "is nested more than " + std::to_string(limits::mesh_file_depth_max) +
                           " deep");
        }
        std::vector<std::size_t> next;
        for (const std::size_t node : level) {
            const auto& children = document.nodes[node].children;
            next.insert(next.end(), children.begin(), children.end());
        }
        level = std::move(next);
    }
    return Done{};
}

class DocumentReader {
  public:
    explicit DocumentReader(const Json& json) : file_(json, "") {}

    Result<GltfDocument> read() {
        check_version();
        refuse_unknown_extensions(file_);
        count_ = {file_.list("buffers").size(),
                  file_.list("bufferViews").size(),
                  file_.list("accessors").size(),
                  file_.list("meshes").size(),
                  file_.list("nodes").size(),
                  file_.list("skins").size()};
        read_list("buffers", "buffer ", document_.buffers, &DocumentReader::buffer);
        read_list("bufferViews", "bufferView ", document_.views, &DocumentReader::view);
        read_list("accessors", "accessor ", document_.accessors, &DocumentReader::accessor);
        read_list("meshes", "mesh ", document_.meshes, &DocumentReader::mesh);
        read_list("nodes", "node ", document_.nodes, &DocumentReader::node);
        read_scene();
        CD_TRY(check_parents(document_));
        CD_TRY(check_depth(document_));
        return std::move(document_);
    }

  private:
    struct Counts {
        std::size_t buffers = 0;
        std::size_t views = 0;
        std::size_t accessors = 0;
        std::size_t meshes = 0;
        std::size_t nodes = 0;
        std::size_t skins = 0;
    };

    template <class T>
    void read_list(const char* key,
                   const char* place,
                   std::vector<T>& out,
                   T (DocumentReader::*read_one)(const GltfFields&)) {
        const Json& list = file_.list(key);
        for (std::size_t i = 0; i < list.size(); ++i) {
            out.push_back((this->*read_one)(GltfFields(list[i], place + std::to_string(i))));
        }
    }

    void check_version() {
        const auto asset = file_.object("asset");
        if (!asset) {
            file_.refuse("is not glTF: it has no asset with a version");
        } else if (const std::string version = asset->text("version"); !version.starts_with("2.")) {
            file_.refuse("is of glTF version '" + version + "'; only 2.0 is read");
        }
    }

    GltfBuffer buffer(const GltfFields& fields) {
        GltfBuffer buffer;
        buffer.bytes = fields.needed_whole("byteLength");
        if (fields.has("uri")) {
            buffer.uri = fields.text("uri");
        }
        return buffer;
    }

    GltfView view(const GltfFields& fields) {
        refuse_compression(fields);
        return {fields.needed_index("buffer", count_.buffers),
                fields.whole("byteOffset").value_or(0),
                fields.needed_whole("byteLength"),
                fields.whole("byteStride").value_or(0)};
    }

    GltfNumber number_type(const GltfFields& fields) {
        const std::uint64_t type = fields.needed_whole("componentType");
        if (type < 5120 || type > 5126 || type == 5124) {
            fields.refuse("componentType " + std::to_string(type) + " is not known");
        }
        return static_cast<GltfNumber>(type);
    }

    GltfAccessor accessor(const GltfFields& fields) {
        constexpr std::array<std::pair<std::string_view, std::size_t>, 7> types{{{"SCALAR", 1},
                                                                                 {"VEC2", 2},
                                                                                 {"VEC3", 3},
                                                                                 {"VEC4", 4},
                                                                                 {"MAT2", 4},
                                                                                 {"MAT3", 9},
                                                                                 {"MAT4", 16}}};
        GltfAccessor accessor;
        accessor.view = fields.index("bufferView", count_.views);
        accessor.offset = fields.whole("byteOffset").value_or(0);
        accessor.type = number_type(fields);
        accessor.is_normalized = fields.flag("normalized");
        accessor.count = fields.needed_whole("count");
        const std::string type = fields.text("type");
        const auto* const found = std::ranges::find(
            types, type, [](const auto& entry) { return std::string(entry.first); });
        if (found == types.end()) {
            fields.refuse("type '" + type + "' is not known");
        }
        accessor.width = found->second;
        if (const auto sparse = fields.object("sparse")) {
            accessor.sparse = sparse_of(*sparse, accessor.type);
        }
        return accessor;
    }

    GltfSparse sparse_of(const GltfFields& fields, GltfNumber type) {
        GltfSparse sparse;
        sparse.count = fields.needed_whole("count");
        const auto indices = fields.object("indices");
        const auto values = fields.object("values");
        if (!indices || !values) {
            fields.refuse("its indices or values are missing");
        }
        sparse.indices = {indices->needed_index("bufferView", count_.views),
                          indices->whole("byteOffset").value_or(0),
                          number_type(*indices)};
        sparse.values = {values->needed_index("bufferView", count_.views),
                         values->whole("byteOffset").value_or(0),
                         type};
        return sparse;
    }

    GltfMesh mesh(const GltfFields& fields) {
        GltfMesh mesh;
        mesh.name = fields.text("name");
        mesh.is_morphed = has_weights(fields).value_or(false);
        const Json& primitives = fields.list("primitives");
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            mesh.primitives.push_back(primitive(
                GltfFields(primitives[i], fields.place() + ", primitive " + std::to_string(i))));
        }
        return mesh;
    }

    GltfPrimitive primitive(const GltfFields& fields) {
        refuse_compression(fields);
        GltfPrimitive primitive;
        const auto attributes = fields.object("attributes");
        if (!attributes || !attributes->has("POSITION")) {
            fields.refuse("it has no POSITION");
        }
        primitive.positions = attributes->needed_index("POSITION", count_.accessors);
        primitive.indices = fields.index("indices", count_.accessors);
        const std::uint64_t mode = fields.whole("mode").value_or(4);
        if (mode > 6) {
            fields.refuse("mode " + std::to_string(mode) + " is not known");
        }
        primitive.mode = static_cast<GltfMode>(mode);
        return primitive;
    }

    /// True if a weight of a morph target is not zero; nothing if there are no weights.
    static std::optional<bool> has_weights(const GltfFields& fields) {
        const auto weights = fields.numbers("weights");
        if (!weights) {
            return std::nullopt;
        }
        return std::ranges::any_of(*weights, [](double weight) { return weight != 0; });
    }

    GltfNode node(const GltfFields& fields) {
        GltfNode node;
        node.name = fields.text("name");
        node.mesh = fields.index("mesh", count_.meshes);
        node.skin = fields.index("skin", count_.skins);
        node.is_morphed = has_weights(fields);
        node.children = fields.indices("children", count_.nodes);
        copy(fields, "translation", node.transform.translation);
        copy(fields, "rotation", node.transform.rotation);
        copy(fields, "scale", node.transform.scale);
        std::array<double, 16> matrix{};
        if (copy(fields, "matrix", matrix)) {
            node.matrix = matrix;
            check_matrix(fields, matrix);
        }
        node.instances = instances(fields);
        return node;
    }

    template <std::size_t n>
    static bool copy(const GltfFields& fields, const char* key, std::array<double, n>& out) {
        const auto numbers = fields.numbers(key, n);
        if (numbers) {
            std::ranges::copy(*numbers, out.begin());
        }
        return numbers.has_value();
    }

    /// Refuses a matrix whose last row is not 0 0 0 1, up to the rounding of exporters: a node's
    /// matrix must decompose into translation, rotation and scale (glTF 2.0, section 3.5.3).
    static void check_matrix(const GltfFields& fields, const std::array<double, 16>& m) {
        constexpr double rounding = 1e-5;
        const double off =
            std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1)});
        if (!(off <= rounding)) {
            fields.refuse("its matrix has a last row other than 0 0 0 1");
        }
    }

    std::optional<GltfInstances> instances(const GltfFields& node) {
        const auto extensions = node.object("extensions");
        const auto instancing =
            extensions ? extensions->object("EXT_mesh_gpu_instancing") : std::nullopt;
        if (!instancing) {
            return std::nullopt;
        }
        const auto attributes = instancing->object("attributes");
        GltfInstances instances;
        if (attributes) {
            instances = {attributes->index("TRANSLATION", count_.accessors),
                         attributes->index("ROTATION", count_.accessors),
                         attributes->index("SCALE", count_.accessors)};
        }
        if (!instances.translation && !instances.rotation && !instances.scale) {
            instancing->refuse("it has no TRANSLATION, ROTATION or SCALE");
        }
        return instances;
    }

    void read_scene() {
        const Json& scenes = file_.list("scenes");
        document_.scenes = scenes.size();
        if (scenes.empty()) {
            file_.refuse("has no scene; export the scene with its nodes");
        }
        const std::size_t scene = file_.index("scene", scenes.size()).value_or(0);
        document_.roots = GltfFields(scenes[scene], "scene " + std::to_string(scene))
                              .indices("nodes", count_.nodes);
    }

    GltfFields file_;
    GltfDocument document_;
    Counts count_;
};

} // namespace

std::size_t size_of(GltfNumber type) {
    switch (type) {
    case GltfNumber::I8:
    case GltfNumber::U8:
        return 1;
    case GltfNumber::I16:
    case GltfNumber::U16:
        return 2;
    case GltfNumber::U32:
    case GltfNumber::F32:
        break;
    }
    return 4;
}

Result<GltfDocument> parse_gltf(std::string_view json) {
    try {
        const Json document = Json::parse(json);
        return DocumentReader(document).read();
    } catch (const Refusal& refusal) {
        return refusal.error;
    } catch (const Json::parse_error& error) {
        return bad_input("its JSON is damaged at byte " + std::to_string(error.byte));
    } catch (const Json::exception&) {
        return bad_input("its JSON has a number beyond all doubles");
    }
}

} // namespace cd
