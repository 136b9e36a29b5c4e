// Small files with a kind, a version and a checksum.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <span>

namespace cd {

/// The magic number and the format version at the start of a file.
struct FileKind {
    std::uint64_t magic = 0;
    std::uint32_t version = 0;
};
/// Writes a file of header, `content` and checksum, which gets its name when complete. Errors: Io.
[[nodiscard]] Status
write_checked(const std::filesystem::path& path, FileKind kind, std::span<const std::byte> content);
/// Reads a file of `write_checked`. Errors: NotFound; Io, also for damage, other kind or version.
[[nodiscard]] Result<Bytes> read_checked(const std::filesystem::path& path, FileKind kind);

void put_bytes(ByteWriter& out, std::span<const std::byte> bytes);
void put_hash(ByteWriter& out, const Sha256& hash);
[[nodiscard]] Sha256 get_hash(ByteReader& in);

} // namespace cd
