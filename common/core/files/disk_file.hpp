// Files with random access. A new file gets its final name only once it is complete.
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

/// States whether `DiskFile::commit` flushes the file, so that the file survives a power loss.
enum class Durability : std::uint8_t { Synced, Unsynced };

/// A read-only memory mapping of a file. `DiskFile::map` reads ahead all pages, which are shared
/// with other processes. While mapped, the file may be renamed or removed, but not written to.
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

/// An open file. Reading and writing are safe from several threads at once. Every error names the
/// file; its code is Io unless a function states others.
class DiskFile {
  public:
    /// Opens a regular file to read. Errors: NotFound when there is no such file; Io.
    [[nodiscard]] static Result<DiskFile> open(const std::filesystem::path& path);
    /// Creates a temporary file beside `path` to write and read. The destructor removes the file
    /// unless `commit` has renamed it.
    [[nodiscard]] static Result<DiskFile> create_for(const std::filesystem::path& path);
    /// Opens a file to write and read; creates a missing file.
    [[nodiscard]] static Result<DiskFile> open_to_write(const std::filesystem::path& path);

    /// Locks `path` (created if missing) against other processes for this object's lifetime.
    /// Errors: Io, also when another process holds the lock.
    [[nodiscard]] static Result<DiskFile> lock(const std::filesystem::path& path);
    /// Locks an existing `path`. Errors: NotFound; Io, also when another process holds the lock.
    [[nodiscard]] static Result<DiskFile> lock_existing(const std::filesystem::path& path);

    DiskFile(DiskFile&& other) noexcept;
    DiskFile& operator=(DiskFile&& other) noexcept;
    ~DiskFile();

    [[nodiscard]] Status write_at(std::uint64_t offset, std::span<const std::byte> bytes) const;
    /// Reads exactly `size` bytes; allocates nothing if the file is shorter. Errors: Io.
    [[nodiscard]] Result<Bytes> read_at(std::uint64_t offset, std::uint64_t size) const;
    [[nodiscard]] Result<std::uint64_t> size() const;
    /// Returns true if `path()` still names this file, which was neither removed nor replaced.
    [[nodiscard]] bool has_its_name() const;

    /// Truncates the file, or extends it with zeros, to `size` bytes.
    [[nodiscard]] Status resize(std::uint64_t size) const;
    /// Flushes all written data to the disk.
    [[nodiscard]] Status sync() const;

    /// Maps the whole file. The mapping may outlive this object.
    [[nodiscard]] Result<FileMapping> map() const;

    /// Flushes the bytes if `durability` is Synced, then renames the file to `path()` atomically.
    [[nodiscard]] Status commit(Durability durability = Durability::Synced);
    /// Commits the file as `path`, another name in the same folder.
    [[nodiscard]] Status commit_as(const std::filesystem::path& path,
                                   Durability durability = Durability::Synced);

    /// The final name, even before the file is committed.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    DiskFile(int descriptor, std::filesystem::path path, std::filesystem::path temporary);
    [[nodiscard]] Status lock_it() const;
    void close();

    int descriptor_ = -1;
    std::filesystem::path path_;
    std::filesystem::path temporary_; ///< Empty when there is no temporary file to remove.
};

/// Separates the final name from the random suffix in the name of a temporary file.
inline constexpr std::string_view temporary_marker = ".tmp-";

/// Creates a directory and its missing parents; an existing one is no error. Errors: Io.
[[nodiscard]] Status make_directories(const std::filesystem::path& directory);
/// Creates an empty folder in TMPDIR, or in /tmp if TMPDIR is not set. The folder's name is `name`
/// and a random suffix. Errors: Io naming the parent folder and TMPDIR.
[[nodiscard]] Result<std::filesystem::path> make_temporary_folder(const std::string& name);
/// Flushes a folder's directory entries to the disk.
[[nodiscard]] Status sync_directory(const std::filesystem::path& directory);

/// Renames a damaged file to the first free name `PATH.damaged-N` and logs `why`. Errors: Io.
[[nodiscard]] Status set_aside(const std::filesystem::path& path, const std::string& why);

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
