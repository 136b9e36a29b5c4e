#include "client/import/gltf/gltf_buffers.hpp"

#include "client/import/gltf/uri.hpp"

#include <utility>

namespace cd {

namespace {

Error bad(const std::string& what) {
    return {ErrorCode::BadInput, what};
}

} // namespace

Result<std::span<const std::byte>> GltfBuffers::open_uri(const std::string& uri,
                                                         const std::filesystem::path& folder) {
    if (uri.starts_with("data:")) {
        auto bytes = decode_data_uri(uri);
        if (!bytes) {
            return bytes.error();
        }
        return std::span<const std::byte>(decoded_.emplace_back(std::move(bytes.value())));
    }
    const auto name = relative_file(uri);
    if (!name) {
        return name.error();
    }
    const auto file = DiskFile::open(folder / name.value());
    if (!file) {
        return file.error();
    }
    auto mapping = file.value().map();
    if (!mapping) {
        return mapping.error();
    }
    return files_.emplace_back(std::move(mapping.value())).bytes();
}

Result<GltfBuffers> GltfBuffers::load(const std::vector<GltfBuffer>& buffers,
                                      const std::optional<std::span<const std::byte>>& chunk,
                                      const std::filesystem::path& folder) {
    GltfBuffers loaded;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const GltfBuffer& buffer = buffers[i];
        const std::string place = "buffer " + std::to_string(i) + ": ";
        if (!buffer.uri && (i != 0 || !chunk)) {
            return bad(place + "it has no bytes: neither a uri nor a chunk of a GLB");
        }
        const auto bytes =
            buffer.uri ? loaded.open_uri(*buffer.uri, folder) : Result(chunk.value());
        if (!bytes) {
            return bad(place + bytes.error().detail);
        }
        if (bytes.value().size() < buffer.bytes) {
            return bad(place + "it counts " + std::to_string(buffer.bytes) + " bytes, and " +
                       std::to_string(bytes.value().size()) + " are there");
        }
        loaded.bytes_.push_back(bytes.value().first(buffer.bytes));
    }
    return loaded;
}

std::uint64_t GltfBuffers::size() const {
    std::uint64_t size = 0;
    for (const auto& bytes : bytes_) {
        size += bytes.size();
    }
    return size;
}

} // namespace cd
