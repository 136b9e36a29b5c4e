#include "common/core/files/section_file.hpp"

#include "common/core/files/bytes.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t alignment = 64;

/// Returns the offset of a section of `size` bytes if the preceding section ends at `end`.
constexpr std::uint64_t begin_of_section(std::uint64_t end, std::uint64_t size) {
    return size == 0 ? end : (end + alignment - 1) / alignment * alignment;
}

constexpr std::uint64_t header_bytes(std::uint64_t sections) {
    constexpr std::uint64_t fixed = 8 + 4 + 4 + 8 + sizeof(Sha256);
    return fixed + sections * (8 + 8 + 8) + 8;
}

bool are_zeros(Section bytes) {
    return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0}; });
}

Error damaged(const std::string& why) {
    return {ErrorCode::Io, why};
}

} // namespace

Status write_section_file(const std::filesystem::path& path,
                          const SectionFileName& name,
                          std::span<const Section> sections,
                          Durability durability) {
    ByteWriter table;
    std::vector<std::uint64_t> offsets;
    std::uint64_t end = header_bytes(sections.size());
    for (const Section& section : sections) {
        offsets.push_back(begin_of_section(end, section.size()));
        end = offsets.back() + section.size();
        table.put(offsets.back());
        table.put(static_cast<std::uint64_t>(section.size()));
        table.put(checksum(section));
    }
    ByteWriter header;
    header.put(name.kind.magic);
    header.put(name.kind.version);
    header.put(static_cast<std::uint32_t>(sections.size()));
    header.put(end);
    put_hash(header, name.key);
    put_bytes(header, table.bytes());
    header.put(checksum(header.bytes()));

    Result<DiskFile> file = DiskFile::create_for(path);
    if (!file) {
        return file.error();
    }
    // Gaps between sections are not written, so they read as zeros.
    if (Status written = file.value().write_at(0, header.bytes()); !written) {
        return written;
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (Status written = file.value().write_at(offsets[i], sections[i]); !written) {
            return written;
        }
    }
    return file.value().commit(durability);
}

Result<std::shared_ptr<const SectionFile>> SectionFile::open(const std::filesystem::path& path,
                                                             const SectionFileName& name,
                                                             std::size_t sections) {
    const Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return file.error();
    }
    Result<FileMapping> mapping = file.value().map();
    if (!mapping) {
        return mapping.error();
    }
    const std::shared_ptr<SectionFile> opened(new SectionFile(std::move(mapping.value())));
    if (const Status checked = opened->check(name, sections); !checked) {
        return damaged_file(path, checked.error().detail);
    }
    return std::shared_ptr<const SectionFile>(opened);
}

Status SectionFile::check(const SectionFileName& name, std::size_t sections) {
    const Section mapped = mapping_.bytes();
    ByteReader in(mapped);
    if (in.get<std::uint64_t>() != name.kind.magic) {
        return damaged("it is a file of another kind");
    }
    if (const auto version = in.get<std::uint32_t>(); version != name.kind.version) {
        return damaged("its version is " + std::to_string(version) + ", expected " +
                       std::to_string(name.kind.version));
    }
    const auto count = in.get<std::uint32_t>();
    const auto bytes = in.get<std::uint64_t>();
    const std::uint64_t header = header_bytes(sections);
    if (count != sections || bytes != mapped.size() || mapped.size() < header) {
        return damaged("it is cut short or too long");
    }
    if (get_hash(in) != name.key) {
        return damaged("it was made for something else");
    }
    std::vector<std::uint64_t> checksums;
    std::uint64_t end = header;
    for (std::size_t i = 0; i < sections; ++i) {
        const auto offset = in.get<std::uint64_t>();
        const auto size = in.get<std::uint64_t>();
        checksums.push_back(in.get<std::uint64_t>());
        if (offset != begin_of_section(end, size) || offset > bytes || size > bytes - offset ||
            !are_zeros(mapped.subspan(end, offset - end))) {
            return damaged("its sections are not where they belong");
        }
        end = offset + size;
        sections_.push_back(mapped.subspan(offset, size));
    }
    if (in.get<std::uint64_t>() != checksum(mapped.first(header - 8)) || end != bytes) {
        return damaged("the checksum of its header is wrong");
    }
    for (std::size_t i = 0; i < sections; ++i) {
        if (checksum(sections_[i]) != checksums[i]) {
            return damaged("the checksum of section " + std::to_string(i) + " is wrong");
        }
    }
    return Done{};
}

} // namespace cd
