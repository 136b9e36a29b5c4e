#include "client/import/gltf/gltf_buffers.hpp"
#include "client/import/gltf/gltf_container.hpp"
#include "client/import/gltf/gltf_document.hpp"
#include "client/import/gltf/gltf_scene.hpp"
#include "client/import/mesh_readers.hpp"
#include "common/core/errors.hpp"

namespace cd {

namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace

bool is_gltf(std::string_view bytes, std::string_view lower_extension) {
    return is_glb(bytes_of(bytes)) || lower_extension == ".gltf" || lower_extension == ".glb";
}

Result<ImportedMesh> read_gltf(const MeshSource& source) {
    const std::string place = source.path.string() + ": ";
    const auto container = CD_TRY(within(place, open_gltf(bytes_of(source.bytes))));
    const auto document = CD_TRY(within(place, parse_gltf(container.json)));
    const auto buffers = CD_TRY(within(
        place, GltfBuffers::load(document.buffers, container.chunk, source.path.parent_path())));
    auto imported = CD_TRY(within(place, GltfScene(document, buffers, source.options).read()));
    if (document.scenes > 1) {
        imported.warnings.push_back(
            place + "has " + std::to_string(document.scenes) +
            " scenes, of which the one that it names, or its first, is read");
    }
    return imported;
}

} // namespace cd
