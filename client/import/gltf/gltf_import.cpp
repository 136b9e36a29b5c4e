#include "client/import/gltf/gltf_import.hpp"

#include "client/import/gltf/gltf_buffers.hpp"
#include "client/import/gltf/gltf_container.hpp"
#include "client/import/gltf/gltf_document.hpp"
#include "client/import/gltf/gltf_scene.hpp"

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
    const auto container = open_gltf(bytes_of(source.bytes));
    if (!container) {
        return source.refusal(container.error().detail);
    }
    const auto document = parse_gltf(container.value().json);
    if (!document) {
        return source.refusal(document.error().detail);
    }
    const auto buffers = GltfBuffers::load(
        document.value().buffers, container.value().chunk, source.path.parent_path());
    if (!buffers) {
        return source.refusal(buffers.error().detail);
    }
    auto imported = GltfScene(document.value(), buffers.value(), source.options).read();
    if (!imported) {
        return source.refusal(imported.error().detail);
    }
    if (document.value().scenes > 1) {
        imported.value().warnings.push_back(
            source.path.string() + ": has " + std::to_string(document.value().scenes) +
            " scenes, of which the one that it names, or its first, is read");
    }
    return imported;
}

} // namespace cd
