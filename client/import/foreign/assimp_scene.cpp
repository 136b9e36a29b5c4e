#include "client/import/foreign/assimp_scene.hpp"

#include "client/import/foreign/collada_check.hpp"
#include "client/import/foreign/xml_frames.hpp"
#include "client/import/mesh_builder.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <Eigen/Core>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <exception>
#include <optional>
#include <span>

namespace cd {

namespace {

Eigen::Matrix4d to_double(const aiMatrix4x4& m) {
    Eigen::Matrix4d out;
    for (unsigned row = 0; row < 4; ++row) {
        for (unsigned column = 0; column < 4; ++column) {
            out(row, column) = static_cast<double>(m[row][column]);
        }
    }
    return out;
}

/// Traverses a scene depth first, without recursion, since the file decides the depth.
class SceneReader {
  public:
    SceneReader(const aiScene& scene,
                const std::filesystem::path& path,
                const Eigen::Matrix4d& root_to_world,
                double unit_factor)
        : scene_(scene), path_(path), root_to_world_(root_to_world), unit_factor_(unit_factor) {}

    Result<ImportedMesh> read() {
        struct Visit {
            const aiNode* node;
            Eigen::Matrix4d to_world;
        };
        std::vector<Visit> waiting{{scene_.mRootNode, root_to_world_}};
        while (!waiting.empty()) {
            const Visit visit = waiting.back();
            waiting.pop_back();
            for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
                const aiMesh& mesh = *scene_.mMeshes[visit.node->mMeshes[i]];
                CD_TRY(add(mesh, *visit.node, visit.to_world));
            }
            for (unsigned i = visit.node->mNumChildren; i-- > 0;) {
                const aiNode* child = visit.node->mChildren[i];
                waiting.push_back({child, visit.to_world * to_double(child->mTransformation)});
            }
        }
        return finish();
    }

  private:
    Status add(const aiMesh& mesh, const aiNode& node, const Eigen::Matrix4d& to_world) {
        builder_.begin_part(part_name(mesh, node));
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) {
                (face.mNumIndices == 2 ? lines_ : points_) += 1;
                continue;
            }
            Corners corners;
            for (unsigned k = 0; k < 3; ++k) {
                corners[k] = place(mesh.mVertices[face.mIndices[k]], to_world);
                if (!corners[k].allFinite()) {
                    return bad_input(path_,
                                     "face " + std::to_string(builder_.triangle_count()) +
                                         " has a coordinate that is not finite");
                }
            }
            builder_.add(corners);
        }
        return Done{};
    }

    [[nodiscard]] Vec3 place(const aiVector3D& v, const Eigen::Matrix4d& to_world) const {
        const Eigen::Vector4d in(
            static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z), 1);
        const Eigen::Vector4d world = to_world * in;
        const Vec3 scaled = unit_factor_ * Vec3(world.x(), world.y(), world.z());
        return scaled.cast<float>().cast<double>();
    }

    [[nodiscard]] std::string part_name(const aiMesh& mesh, const aiNode& node) const {
        const std::string of_node = node.mName.C_Str();
        const std::string of_mesh = mesh.mName.C_Str();
        if (node.mNumMeshes > 1 && !of_mesh.empty()) {
            return of_mesh;
        }
        const bool is_root = &node == scene_.mRootNode;
        if (!of_node.empty() && !is_root) {
            return of_node;
        }
        return of_mesh.empty() ? nameless_part : of_mesh;
    }

    Result<ImportedMesh> finish() {
        auto imported = CD_TRY(finish_import(path_, builder_, Precision::Float));
        imported.points_skipped = points_;
        imported.lines_skipped = lines_;
        return imported;
    }

    const aiScene& scene_;
    const std::filesystem::path& path_;
    Eigen::Matrix4d root_to_world_;
    double unit_factor_;
    MeshBuilder builder_;
    std::uint64_t points_ = 0;
    std::uint64_t lines_ = 0;
};

constexpr std::string_view collada_format = "Collada Importer";

/// Returns the name of the assimp importer that read the scene.
std::string format_of(const aiScene& scene) {
    aiString format;
    if (scene.mMetaData != nullptr) {
        scene.mMetaData->Get("SourceAsset_Format", format);
    }
    return format.C_Str();
}

/// Returns the unit and up axis of an FBX file. assimp stores the file's doubles as floats; the
/// shortest decimal of such a float is the number in the file.
DeclaredFrame fbx_frame(const aiScene& scene) {
    float scale = 1;
    scene.mMetaData->Get("UnitScaleFactor", scale);
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), scale).ptr;
    const double centimetres = to_number({text.begin(), end}).value_or(1);
    DeclaredFrame frame;
    frame.metres = centimetres / 100;
    frame.unit = centimetres == 1      ? "centimetre"
                 : centimetres == 100  ? "metre"
                 : centimetres == 2.54 ? "inch"
                 : centimetres == 0.1  ? "millimetre"
                                       : std::string(text.begin(), end) + " cm";
    constexpr std::array<const char*, 3> axes{"X", "Y", "Z"};
    std::int32_t up = 1;
    scene.mMetaData->Get("UpAxis", up);
    frame.up = up >= 0 && up < 3 ? axes[static_cast<std::size_t>(up)] : "";
    return frame;
}

/// Returns the unit and up axis that the file declares; nothing if its unit is unknown.
std::optional<DeclaredFrame> declared_frame(const aiScene& scene,
                                            const std::filesystem::path& path) {
    const std::string format = format_of(scene);
    if (format == collada_format) {
        return collada_frame(read_text(path));
    }
    if (format.find("FBX") != std::string::npos) {
        return fbx_frame(scene);
    }
    if (format.find("AMF") != std::string::npos) {
        return additive_frame(read_text(path));
    }
    if (format.find("3mf") != std::string::npos) {
        return three_mf_frame(path);
    }
    return DeclaredFrame{};
}

/// Refuses bones and morph targets: assimp would place such a mesh without deforming it.
Status check_rigid(const aiScene& scene, const std::filesystem::path& path) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        if (mesh.mNumBones > 0 || mesh.mNumAnimMeshes > 0) {
            return bad_input(
                path,
                "mesh '" + std::string(mesh.mName.C_Str()) + "' is deformed by " +
                    (mesh.mNumBones > 0 ? "a skin" : "morph targets") +
                    ", and only rigid meshes are read; apply them in the program that wrote "
                    "the file");
        }
    }
    return Done{};
}

/// Returns the error for a file that assimp refused, with assimp's message on one line.
Error unreadable(const std::filesystem::path& path, std::string why) {
    std::replace_if(
        why.begin(), why.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return bad_input(path, "cannot be read as a mesh" + (why.empty() ? "" : ": " + why));
}

/// Counts, for each mesh, the triangles into which its polygons will be cut.
///
/// It has to run before assimp triangulates, which does not check indices and aborts the process on
/// a polygon without corners. Errors: BadInput naming the face.
Result<std::vector<std::uint64_t>> count_triangles(const aiScene& scene,
                                                   const std::filesystem::path& path) {
    std::vector<std::uint64_t> triangles(scene.mNumMeshes, 0);
    std::uint64_t faces_before = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            const auto name = [&] { return "face " + std::to_string(faces_before + f); };
            if (face.mNumIndices == 0) {
                return bad_input(path, name() + " is missing: the file has fewer than it counts");
            }
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) {
                    return bad_input(path,
                                     name() + " names vertex " + std::to_string(face.mIndices[k]) +
                                         " of " + std::to_string(mesh.mNumVertices));
                }
            }
            triangles[m] += face.mNumIndices > 2 ? face.mNumIndices - 2 : 0;
        }
        faces_before += mesh.mNumFaces;
    }
    return triangles;
}

/// Refuses a mesh that lost triangles: assimp may drop some of a self-crossing polygon's.
Status check_triangles(const aiScene& scene,
                       std::span<const std::uint64_t> expected,
                       const std::filesystem::path& path) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        std::uint64_t triangles = 0;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            triangles += mesh.mFaces[f].mNumIndices == 3 ? 1 : 0;
        }
        if (triangles != expected[m]) {
            return bad_input(path,
                             "mesh '" + std::string(mesh.mName.C_Str()) +
                                 "' has polygons that cannot be cut into triangles; triangulate it "
                                 "before exporting");
        }
    }
    return Done{};
}

} // namespace

std::string assimp_version() {
    return std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) + "." +
           std::to_string(aiGetVersionPatch());
}

Result<ImportedMesh> read_with_assimp(const std::filesystem::path& path,
                                      const ImportOptions& options) {
    try {
        Assimp::Importer importer;
        importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
        importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
        const aiScene* scene = importer.ReadFile(path.string(), 0);
        if (scene == nullptr || scene->mRootNode == nullptr) {
            return unreadable(path, importer.GetErrorString());
        }
        CD_TRY(check_rigid(*scene, path));
        const auto triangles = CD_TRY(count_triangles(*scene, path));
        scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
        if (scene == nullptr || scene->mRootNode == nullptr) {
            return unreadable(path, importer.GetErrorString());
        }
        CD_TRY(check_triangles(*scene, triangles, path));
        const auto known_frame = declared_frame(*scene, path);
        if (!known_frame && !options.declared_unit_to.empty()) {
            return bad_input(
                path,
                "declares a unit that is not known here; name the unit of its coordinates "
                "(unit in the body's table of the job, --unit-a, --unit-b, or --unit of "
                "inspect)");
        }
        const DeclaredFrame declared = known_frame.value_or(DeclaredFrame{});
        // assimp puts the unit of a COLLADA file into the root transform; this is left out, since
        // the unit is applied as a factor.
        const Eigen::Matrix4d root = format_of(*scene) == collada_format
                                         ? Eigen::Matrix4d::Identity()
                                         : to_double(scene->mRootNode->mTransformation);
        auto imported = SceneReader(*scene, path, root, factor_of(options, declared)).read();
        if (imported) {
            imported.value().declared = declared;
            imported.value().is_by_assimp = true;
        }
        return imported;
    } catch (const std::exception& error) {
        return unreadable(path, error.what());
    }
}

} // namespace cd
