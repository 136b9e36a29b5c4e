#include "client/import/foreign/assimp_import.hpp"

#include "client/import/foreign/assimp_scene.hpp"
#include "client/import/foreign/child_call.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"

#include <optional>
#include <span>
#include <system_error>

namespace cd {

namespace {

ChildLimits limits_for(std::uint64_t file_bytes) {
    ChildLimits limits;
    limits.memory_bytes =
        limits::reader_memory_bytes_min + limits::reader_memory_per_file_byte * file_bytes;
    limits.processor_time = timing::reader_seconds_min +
                            std::chrono::seconds(file_bytes / limits::reader_file_bytes_per_second);
    limits.real_time = limits::reader_real_seconds_each * limits.processor_time;
    return limits;
}

/// Encodes the result of an import, which the child process passes to its parent.
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

/// Decodes what `to_bytes` wrote; returns nothing for incomplete bytes.
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

std::string explain(ChildEnd end, const ChildLimits& limits) {
    switch (end) {
    case ChildEnd::OutOfMemory:
        return "the reader wants more than " + std::to_string(limits.memory_bytes >> 20) +
               " MiB of memory";
    case ChildEnd::OutOfTime:
        return "the reader did not end within " + std::to_string(limits.processor_time.count()) +
               " s";
    default:
        return "the reader crashed";
    }
}

} // namespace

Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                        const ImportOptions& options) {
    std::error_code error;
    const std::uint64_t file_bytes = std::filesystem::file_size(path, error);
    const ChildLimits limits = limits_for(error ? 0 : file_bytes);
    const auto read = [&] { return to_bytes(read_with_assimp(path, options)); };
    const auto answer = call_in_child(read, limits, options.is_stopped);
    if (!answer) {
        return Error{answer.error().code, path.string() + ": " + answer.error().detail};
    }
    if (answer.value().end == ChildEnd::Stopped) {
        return Error{ErrorCode::Interrupted, path.string() + ": stopped while it was read"};
    }
    if (answer.value().end == ChildEnd::Answered) {
        if (auto imported = imported_from_bytes(answer.value().bytes)) {
            return std::move(*imported);
        }
    }
    return bad_input(path.string() + ": " + explain(answer.value().end, limits) + " (assimp " +
                     assimp_version() + "); convert the file to glTF, OBJ, PLY or STL");
}

} // namespace cd
