#include "client/import/gltf/gltf_container.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/bytes.hpp"

#include <string>

namespace cd {

namespace {

constexpr std::string_view magic = "glTF";
constexpr std::uint32_t json_chunk = 0x4e4f534a;   // "JSON"
constexpr std::uint32_t binary_chunk = 0x004e4942; // "BIN"

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t type = 0;
    std::span<const std::byte> bytes;
};

Result<Chunk> next_chunk(ByteReader& in) {
    const auto size = in.get<std::uint32_t>();
    const auto type = in.get<std::uint32_t>();
    const std::size_t there = in.remaining();
    const auto bytes = in.get_bytes(size);
    if (in.failed()) {
        return bad_input("a chunk of this GLB counts " + std::to_string(size) + " bytes, and " +
                         std::to_string(there) + " are left");
    }
    return Chunk{type, bytes};
}

Result<GltfContainer> open_glb(std::span<const std::byte> file) {
    ByteReader in(file);
    static_cast<void>(in.get<std::uint32_t>());
    const auto version = in.get<std::uint32_t>();
    const auto size = in.get<std::uint32_t>();
    if (version != 2 || in.failed()) {
        return bad_input("is a GLB of version " + std::to_string(version) + "; only 2 is read");
    }
    if (size != file.size()) {
        return bad_input("the GLB counts " + std::to_string(size) + " bytes, and the file has " +
                         std::to_string(file.size()));
    }
    const auto json = CD_TRY(next_chunk(in));
    if (json.type != json_chunk) {
        return bad_input("the first chunk of this GLB is not JSON");
    }
    GltfContainer container;
    container.json = text_of(json.bytes);
    // Drops zeros at the end, with which some programs pad the chunk instead of blanks.
    container.json = container.json.substr(0, container.json.find_last_not_of('\0') + 1);
    if (in.remaining() > 0) {
        const auto binary = CD_TRY(next_chunk(in));
        if (binary.type == binary_chunk) {
            container.chunk = binary.bytes;
        }
    }
    return container;
}

} // namespace

bool is_glb(std::span<const std::byte> file) {
    return text_of(file).starts_with(magic);
}

Result<GltfContainer> open_gltf(std::span<const std::byte> file) {
    return is_glb(file) ? open_glb(file) : GltfContainer{text_of(file), std::nullopt};
}

} // namespace cd
