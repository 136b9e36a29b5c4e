// A file of arrays that is read in place: mapped into memory, and checked as a whole before use.
#pragma once

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

/// What a file holds, and for what it was made: what was made for anything else is not opened.
struct SectionFileName {
    FileKind kind;
    Sha256 key;
};

/// Little-endian:
///
///     u64 magic    u32 version    u32 sections    u64 bytes of the file    32 bytes key
///     of each section: u64 offset    u64 bytes    u64 checksum
///     u64 checksum of all before
///     the sections, each at the next multiple of 64 after what is before, zeros between
///
/// The file appears under its name when it is whole.
[[nodiscard]] Status write_section_file(const std::filesystem::path& path,
                                        const SectionFileName& name,
                                        std::span<const Section> sections,
                                        Durability durability);

/// An open file of sections. Its pages are shared with other processes that map it, and come from
/// the disk as they are read. It may be renamed and removed meanwhile, but not written to.
class SectionFile {
  public:
    /// Reads all of the file and checks it. Errors: NotFound when there is no such file; Io naming
    /// it where it is damaged, or is of another kind, version or key, or has another number of
    /// sections.
    [[nodiscard]] static Result<std::shared_ptr<const SectionFile>>
    open(const std::filesystem::path& path, const SectionFileName& name, std::size_t sections);

    [[nodiscard]] Section section(std::size_t i) const { return sections_[i]; }

    /// The section as an array of `T`. Errors: Io if its size is no multiple of that of `T`.
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
