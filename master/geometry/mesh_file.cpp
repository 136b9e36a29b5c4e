#include "master/geometry/mesh_file.hpp"

#include "common/core/files/checked_file.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/host/log.hpp"

namespace cd {

namespace {

constexpr FileKind info_kind{0x31'4f'46'4e'49'44'43'00, 1}; // "\0CDINFO1"

} // namespace

std::filesystem::path mesh_path(const std::filesystem::path& state, const Sha256& hash) {
    return state / "meshes" / (to_hex(hash) + std::string(mesh_suffix));
}

Status write_info(const std::filesystem::path& path, const MeshInfo& info) {
    ByteWriter out;
    out.put_text(info.name);
    out.put(info.triangles);
    return write_checked(path, info_kind, out.bytes());
}

MeshInfo read_info(const std::filesystem::path& path) {
    const Result<Bytes> content = read_checked(path, info_kind);
    if (!content) {
        log_warning("mesh description not read: error=\"{}\"", content.error().detail);
        return {};
    }
    ByteReader in(content.value());
    MeshInfo info;
    info.name = in.get_text();
    info.triangles = in.get<std::uint64_t>();
    return info;
}

Result<std::shared_ptr<const Mesh>> read_mesh(const std::filesystem::path& path,
                                              const Sha256& hash) {
    const auto damaged = [&](const std::string& why) {
        return Error{ErrorCode::Io,
                     path.string() + " is damaged: " + why +
                         "; restore it, or move it away and submit a job with the mesh again"};
    };
    const Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return file.error();
    }
    const Result<std::uint64_t> size = file.value().size();
    if (!size) {
        return size.error();
    }
    const Result<Bytes> bytes = file.value().read_at(0, size.value());
    if (!bytes) {
        return bytes.error();
    }
    if (sha256(bytes.value()) != hash) {
        return damaged("its content does not have its name's hash");
    }
    Result<Mesh> mesh = Mesh::from_canonical_bytes(bytes.value());
    if (!mesh) {
        return damaged(mesh.error().detail);
    }
    return std::make_shared<const Mesh>(std::move(mesh.value()));
}

} // namespace cd
