#include "client/import/imported_bytes.hpp"

namespace cd {

Bytes to_bytes(const Result<ImportedMesh>& imported) {
    ByteWriter out;
    out.put(static_cast<std::uint8_t>(imported.has_value() ? 1 : 0));
    if (!imported) {
        out.put(static_cast<std::uint32_t>(imported.error().code));
        out.put_text(imported.error().detail);
        return out.take();
    }
    const ImportedMesh& value = imported.value();
    out.put(value.points_skipped);
    out.put(value.lines_skipped);
    out.put_text(value.declared.unit);
    out.put(value.declared.metres);
    out.put_text(value.declared.up);
    out.put(static_cast<std::uint8_t>(value.is_by_assimp ? 1 : 0));
    out.put(static_cast<std::uint32_t>(value.warnings.size()));
    for (const std::string& warning : value.warnings) {
        out.put_text(warning);
    }
    const Bytes mesh = value.mesh->canonical_bytes();
    out.put_array(std::span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(mesh.data()),
                                                mesh.size()));
    return out.take();
}

std::optional<Result<ImportedMesh>> imported_from_bytes(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint8_t>() == 0) {
        const auto code = static_cast<ErrorCode>(in.get<std::uint32_t>());
        const std::string detail = in.get_text();
        return in.complete() ? std::optional(Result<ImportedMesh>(Error{code, detail}))
                             : std::nullopt;
    }
    ImportedMesh value;
    value.points_skipped = in.get<std::uint64_t>();
    value.lines_skipped = in.get<std::uint64_t>();
    value.declared.unit = in.get_text();
    value.declared.metres = in.get<double>();
    value.declared.up = in.get_text();
    value.is_by_assimp = in.get<std::uint8_t>() != 0;
    const auto warnings = in.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < warnings && !in.failed(); ++i) {
        value.warnings.push_back(in.get_text());
    }
    if (in.failed()) {
        return std::nullopt;
    }
    auto mesh = Mesh::from_canonical_bytes(in.get_bytes(in.remaining()));
    if (!mesh) {
        return std::nullopt;
    }
    value.mesh = std::make_shared<const Mesh>(std::move(mesh.value()));
    return Result<ImportedMesh>(std::move(value));
}

} // namespace cd
