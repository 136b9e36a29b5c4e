// Files of ours: read and written in places, complete or not there at all.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace cd {

/// Whether a file that got its name is there after a loss of power, too.
enum class Durability : std::uint8_t { Synced, Unsynced };

/// The content of a file in memory, for reading. Pages come from the disk as they are read, and are
/// shared with other processes. The file may be renamed and removed meanwhile, not written to.
class FileMapping {
  public:
    explicit FileMapping(std::span<const std::byte> bytes) : bytes_(bytes) {}
    FileMapping(FileMapping&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
    FileMapping& operator=(FileMapping&& other) = delete;
    ~FileMapping();

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::span<const std::byte> bytes_;
};

/// An open file. Reading and writing are safe from several threads at once. Every error is Io and
/// names the file.
class DiskFile {
  public:
    /// To read. Errors: NotFound when there is no such file; Io.
    [[nodiscard]] static Result<DiskFile> open(const std::filesystem::path& path);
    /// To write and read: a temporary file beside `path`, gone with this object unless `commit`ted.
    [[nodiscard]] static Result<DiskFile> create_for(const std::filesystem::path& path);
    /// To write and read: the file of that name, made if missing.
    [[nodiscard]] static Result<DiskFile> open_to_write(const std::filesystem::path& path);

    /// Locks `path` (made if missing) against other processes while this lives. Errors: Io, also
    /// when another process holds it.
    [[nodiscard]] static Result<DiskFile> lock(const std::filesystem::path& path);
    /// Locks `path` without creating it. Errors: NotFound; Io, also when another process holds it.
    [[nodiscard]] static Result<DiskFile> lock_existing(const std::filesystem::path& path);

    DiskFile(DiskFile&& other) noexcept;
    DiskFile& operator=(DiskFile&& other) noexcept;
    ~DiskFile();

    [[nodiscard]] Status write_at(std::uint64_t offset, std::span<const std::byte> bytes) const;
    /// Exactly `size` bytes, or an error. Allocates only what the file really holds.
    [[nodiscard]] Result<Bytes> read_at(std::uint64_t offset, std::uint64_t size) const;
    [[nodiscard]] Result<std::uint64_t> size() const;
    /// Whether `path()` still names this file: it was neither removed nor replaced.
    [[nodiscard]] bool has_its_name() const;

    /// Cuts the file off, or fills it with zeros, so that it has this size.
    [[nodiscard]] Status resize(std::uint64_t size) const;
    /// Brings all that was written to the disk.
    [[nodiscard]] Status sync() const;

    /// All of it, also after this object is gone.
    [[nodiscard]] Result<FileMapping> map() const;

    /// Brings the bytes to the disk if they are to be synced, then gives the file its name, in one
    /// step.
    [[nodiscard]] Status commit(Durability durability = Durability::Synced);
    /// The same under another name in the same folder.
    [[nodiscard]] Status commit_as(const std::filesystem::path& path,
                                   Durability durability = Durability::Synced);

    /// The name, also while the file does not have it yet.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    DiskFile(int descriptor, std::filesystem::path path, std::filesystem::path temporary);
    [[nodiscard]] Status lock_it() const;
    void close();

    int descriptor_ = -1;
    std::filesystem::path path_;
    std::filesystem::path temporary_; ///< Empty when there is nothing to remove.
};

/// What temporary files are called, after the name that they are for.
inline constexpr std::string_view temporary_marker = ".tmp-";

[[nodiscard]] Status make_directories(const std::filesystem::path& directory);
/// Brings the names of a folder's files to the disk.
[[nodiscard]] Status sync_directory(const std::filesystem::path& directory);

/// Moves a damaged file out of the way, to the first free name `PATH.damaged-N`, and logs it.
[[nodiscard]] Status set_aside(const std::filesystem::path& path, const std::string& why);

/// Small files with a kind, a version and a checksum around their content.
struct FileKind {
    std::uint64_t magic = 0;
    std::uint32_t version = 0;
};
[[nodiscard]] Status
write_checked(const std::filesystem::path& path, FileKind kind, std::span<const std::byte> content);
/// Errors: NotFound; Io, also for what is damaged or of another kind or version.
[[nodiscard]] Result<Bytes> read_checked(const std::filesystem::path& path, FileKind kind);

void put_bytes(ByteWriter& out, std::span<const std::byte> bytes);
void put_hash(ByteWriter& out, const Sha256& hash);
[[nodiscard]] Sha256 get_hash(ByteReader& in);

} // namespace cd
