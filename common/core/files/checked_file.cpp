// Implements `write_checked` and `read_checked`: small files with a kind, a version and a checksum.
#include "common/core/files/disk_file.hpp"

namespace cd {

namespace {

constexpr std::size_t checked_header_bytes = sizeof(std::uint64_t) + sizeof(std::uint32_t);

Error damaged(const std::filesystem::path& path, const std::string& why) {
    return {ErrorCode::Io, path.string() + " is damaged: " + why};
}

} // namespace

Status write_checked(const std::filesystem::path& path,
                     FileKind kind,
                     std::span<const std::byte> content) {
    Result<DiskFile> file = DiskFile::create_for(path);
    if (!file) {
        return file.error();
    }
    ByteWriter header;
    header.put(kind.magic);
    header.put(kind.version);
    ByteWriter footer;
    footer.put(checksum(content));
    std::uint64_t offset = 0;
    for (const std::span<const std::byte> piece : {std::span<const std::byte>(header.bytes()),
                                                   content,
                                                   std::span<const std::byte>(footer.bytes())}) {
        if (const Status status = file.value().write_at(offset, piece); !status) {
            return status.error();
        }
        offset += piece.size();
    }
    return file.value().commit();
}

Result<Bytes> read_checked(const std::filesystem::path& path, FileKind kind) {
    const Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return file.error();
    }
    const Result<std::uint64_t> size = file.value().size();
    if (!size) {
        return size.error();
    }
    if (size.value() < checked_header_bytes + sizeof(std::uint64_t)) {
        return damaged(path, "it is cut short");
    }
    const std::uint64_t content_bytes = size.value() - checked_header_bytes - sizeof(std::uint64_t);
    const Result<Bytes> header = file.value().read_at(0, checked_header_bytes);
    Result<Bytes> content = file.value().read_at(checked_header_bytes, content_bytes);
    const Result<Bytes> footer =
        file.value().read_at(checked_header_bytes + content_bytes, sizeof(std::uint64_t));
    for (const Result<Bytes>* piece : {&header, &std::as_const(content), &footer}) {
        if (!*piece) {
            return piece->error();
        }
    }
    ByteReader head(header.value());
    if (head.get<std::uint64_t>() != kind.magic) {
        return damaged(path, "it is a file of another kind");
    }
    if (const auto version = head.get<std::uint32_t>(); version != kind.version) {
        return damaged(path,
                       "its version is " + std::to_string(version) + ", expected " +
                           std::to_string(kind.version));
    }
    if (ByteReader(footer.value()).get<std::uint64_t>() != checksum(content.value())) {
        return damaged(path, "its checksum is wrong");
    }
    return content;
}

void put_bytes(ByteWriter& out, std::span<const std::byte> bytes) {
    out.put_array(std::span(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void put_hash(ByteWriter& out, const Sha256& hash) {
    put_bytes(out, hash.bytes);
}

Sha256 get_hash(ByteReader& in) {
    Sha256 hash;
    for (std::byte& byte : hash.bytes) {
        byte = static_cast<std::byte>(in.get<std::uint8_t>());
    }
    return hash;
}

} // namespace cd
