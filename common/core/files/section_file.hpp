// A memory-mapped file of arrays that is checked as a whole before use.
#pragma once

#include "common/core/files/checked_file.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace cd {

/// The bytes of one array.
using Section = std::span<const std::byte>;

/// A file's kind, and the hash of the input that the file was made from. A file opens only if both
/// match.
struct SectionFileName {
    FileKind kind;
    Sha256 key;
};

/// Writes a little-endian file of the sections, with XXH3 checksums:
///
///     u64 magic    u32 version    u32 sections    u64 bytes of the file    32 bytes key
///     per section: u64 offset    u64 bytes    u64 checksum
///     u64 checksum of all bytes before
///     the sections, each aligned to 64 bytes, zeros between
///
/// The file gets its name only once it is complete. Errors: Io.
[[nodiscard]] Status write_section_file(const std::filesystem::path& path,
                                        const SectionFileName& name,
                                        std::span<const Section> sections,
                                        Durability durability);

/// An open file of sections, mapped into memory that other processes share. While open, the file
/// may be renamed or removed, but not written to.
class SectionFile {
  public:
    /// Maps and checks the whole file. Errors: NotFound if there is no such file; Io naming a file
    /// that is damaged or whose kind, version, key or number of sections differs.
    [[nodiscard]] static Result<std::shared_ptr<const SectionFile>>
    open(const std::filesystem::path& path, const SectionFileName& name, std::size_t sections);

    [[nodiscard]] Section section(std::size_t i) const { return sections_[i]; }

    /// Views section `i` as an array of `T`. Errors: Io if its size is no multiple of `sizeof(T)`.
    template <class T>
    [[nodiscard]] Result<std::span<const T>> array(std::size_t i) const {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);
        const Section bytes = section(i);
        if (bytes.size() % sizeof(T) != 0) {
            return Error{ErrorCode::Io, "section " + std::to_string(i) + " has a wrong size"};
        }
        return std::span(reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T));
    }

  private:
    explicit SectionFile(FileMapping mapping) : mapping_(std::move(mapping)) {}
    [[nodiscard]] Status check(const SectionFileName& name, std::size_t sections);

    FileMapping mapping_;
    std::vector<Section> sections_;
};

} // namespace cd
