// An upload of a mesh in pieces, from its start until the mesh is validated.
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

/// Keeps the bytes in a temporary file, which the destructor deletes unless `commit` has renamed
/// it. One thread at a time.
class MeshUpload {
  public:
    /// Only GeometryStore calls this. `open_uploads` counts the existing uploads.
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

    /// Appends the next piece; pieces must be contiguous. Blocks for the disk. Errors: BadInput for
    /// a gap, a repetition, or more bytes than announced; Io.
    [[nodiscard]] Status append(std::uint64_t offset, std::span<const std::byte> bytes);
    /// Returns whether all announced bytes have arrived.
    [[nodiscard]] bool is_complete() const { return bytes_here_ == bytes_total_; }

    /// Reads and validates the mesh. Call once. Errors: BadInput if the upload is incomplete, has a
    /// wrong hash, or is no valid mesh in canonical form; Io.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> read();
    /// Renames the temporary file to its final name.
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
