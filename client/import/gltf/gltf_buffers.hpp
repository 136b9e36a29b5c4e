// The bytes of a glTF file's buffers.
#pragma once

#include "client/import/gltf/gltf_document.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/disk_file.hpp"

#include <filesystem>
#include <list>
#include <span>
#include <vector>

namespace cd {

/// Gives access to buffers in the GLB's binary chunk, in `data:` URIs and in files in `folder` or
/// below it. No other file of the host is opened, and nothing is fetched.
class GltfBuffers {
  public:
    /// `chunk` has to outlive the buffers. Errors: BadInput naming the buffer, for one that is
    /// missing, shorter than its byteLength, or outside of `folder`.
    [[nodiscard]] static Result<GltfBuffers>
    load(const std::vector<GltfBuffer>& buffers,
         const std::optional<std::span<const std::byte>>& chunk,
         const std::filesystem::path& folder);

    [[nodiscard]] std::span<const std::byte> bytes(std::size_t buffer) const {
        return bytes_[buffer];
    }
    [[nodiscard]] std::uint64_t size() const; ///< Total of all buffers.

  private:
    [[nodiscard]] Result<std::span<const std::byte>> open_uri(const std::string& uri,
                                                              const std::filesystem::path& folder);

    std::vector<std::span<const std::byte>> bytes_;
    std::list<Bytes> decoded_;
    std::list<FileMapping> files_;
};

} // namespace cd
