#include "master/geometry/mesh_upload.hpp"

namespace cd {

MeshUpload::MeshUpload(DiskFile file,
                       const Sha256& mesh,
                       std::string name,
                       std::uint64_t bytes_total,
                       std::shared_ptr<std::atomic<std::size_t>> open_uploads)
    : file_(std::move(file)),
      mesh_(mesh),
      name_(std::move(name)),
      bytes_total_(bytes_total),
      open_uploads_(std::move(open_uploads)) {
    ++*open_uploads_;
}

MeshUpload::~MeshUpload() {
    --*open_uploads_;
}

Status MeshUpload::append(std::uint64_t offset, std::span<const std::byte> bytes) {
    if (offset != bytes_here_) {
        return Error{ErrorCode::BadInput,
                     "a piece of a mesh at byte " + std::to_string(offset) + " where byte " +
                         std::to_string(bytes_here_) + " comes next"};
    }
    if (bytes.size() > bytes_total_ - bytes_here_) {
        return Error{ErrorCode::BadInput,
                     "more bytes of a mesh than the " + std::to_string(bytes_total_) +
                         " that were announced"};
    }
    if (Status status = file_.write_at(offset, bytes); !status) {
        return status;
    }
    hash_.update(bytes);
    bytes_here_ += bytes.size();
    return Done{};
}

Result<std::shared_ptr<const Mesh>> MeshUpload::read() {
    if (!is_complete()) {
        return Error{ErrorCode::BadInput, "the mesh '" + name_ + "' is not complete"};
    }
    if (hash_.finish() != mesh_) {
        return Error{ErrorCode::BadInput,
                     "the mesh '" + name_ + "' does not have the hash that names it"};
    }
    const Result<Bytes> bytes = file_.read_at(0, bytes_total_);
    if (!bytes) {
        return bytes.error();
    }
    Result<Mesh> mesh = Mesh::from_canonical_bytes(bytes.value());
    if (!mesh) {
        return Error{mesh.error().code, "the mesh '" + name_ + "': " + mesh.error().detail};
    }
    // Rejects other encodings of an equal mesh, for example with a minus zero: each mesh must have
    // only one hash.
    if (mesh.value().hash() != mesh_) {
        return Error{ErrorCode::BadInput, "the mesh '" + name_ + "' is not in its canonical form"};
    }
    return std::make_shared<const Mesh>(std::move(mesh.value()));
}

} // namespace cd
