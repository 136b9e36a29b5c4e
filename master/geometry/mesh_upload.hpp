// A mesh that comes in pieces from a client, until it is known to be one.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace cd {

/// Holds the bytes in a temporary file that goes when this does. One thread at a time.
class MeshUpload {
  public:
    /// `open_uploads` counts those that exist. Used by the GeometryStore.
    MeshUpload(DiskFile file,
               const Sha256& mesh,
               std::string name,
               std::uint64_t bytes_total,
               std::shared_ptr<std::atomic<std::size_t>> open_uploads);
    MeshUpload(const MeshUpload&) = delete;
    MeshUpload& operator=(const MeshUpload&) = delete;
    ~MeshUpload();

    [[nodiscard]] const Sha256& mesh() const { return mesh_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::uint64_t bytes_total() const { return bytes_total_; }

    /// The pieces must follow one another. Blocks for the write. Errors: BadInput for a gap, a
    /// repetition or more than was announced; Io.
    [[nodiscard]] Status append(std::uint64_t offset, std::span<const std::byte> bytes);
    /// All announced bytes are there.
    [[nodiscard]] bool is_complete() const { return bytes_here_ == bytes_total_; }

    /// The mesh that the bytes are. Once. Errors: BadInput when incomplete, of another hash, or no
    /// valid mesh in canonical form; Io.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> read();
    /// Gives the file its name.
    [[nodiscard]] Status commit() { return file_.commit(); }

  private:
    DiskFile file_;
    Sha256 mesh_;
    std::string name_;
    std::uint64_t bytes_total_ = 0;
    std::uint64_t bytes_here_ = 0;
    Sha256Stream hash_;
    std::shared_ptr<std::atomic<std::size_t>> open_uploads_;
};

} // namespace cd
