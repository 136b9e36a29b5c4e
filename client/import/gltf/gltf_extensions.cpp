#include "client/import/gltf/gltf_extensions.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace cd {

namespace {

/// Extensions that do not change triangles, and those that are supported.
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

} // namespace

void refuse_unknown_extensions(const GltfFields& file) {
    for (const GltfFields::Json& entry : file.list("extensionsRequired")) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
        if (std::ranges::find(compressions, name) != compressions.end()) {
            file.report(compressed_by(name));
        } else if (std::ranges::find(harmless_extensions, name) == harmless_extensions.end()) {
            file.report("requires the extension " + name +
                        ", which is not supported; export the file without it");
        }
    }
}

void refuse_compression(const GltfFields& object) {
    const auto extensions = object.object("extensions");
    for (const char* name : compressions) {
        if (extensions && extensions->has(name)) {
            object.report(compressed_by(name));
        }
    }
}

} // namespace cd
