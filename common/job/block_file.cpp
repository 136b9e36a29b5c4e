#include "common/job/block_file.hpp"

#include "common/core/check.hpp"
#include "common/core/files/hash.hpp"

#include <algorithm>
#include <string>

namespace cd {

namespace {

constexpr std::uint64_t word = sizeof(std::uint64_t);
constexpr std::uint64_t header_bytes = 2 * word;
constexpr std::uint64_t block_header_bytes = 3 * word;
constexpr std::uint64_t row_bytes = 4 * word;
constexpr std::uint64_t footer_bytes = 4 * word;

/// Returns the file offset at which a block ends, after its header, content and checksum.
std::uint64_t end_of(const BlockEntry& block) {
    return block.offset + block_header_bytes + block.bytes + word;
}

Bytes header_of(FileKind kind) {
    ByteWriter out;
    out.put(kind.magic);
    out.put(kind.version);
    out.put(std::uint32_t{0});
    return out.take();
}

Status check_kind(const DiskFile& file, FileKind kind) {
    const Result<Bytes> header = file.read_at(0, header_bytes);
    if (!header) {
        return header.error();
    }
    ByteReader in(header.value());
    if (in.get<std::uint64_t>() != kind.magic) {
        return damaged_file(file.path(), "it is a file of another kind");
    }
    if (const auto version = in.get<std::uint32_t>(); version != kind.version) {
        return Error{ErrorCode::Io,
                     file.path().string() + " has version " + std::to_string(version) +
                         "; this program reads version " + std::to_string(kind.version)};
    }
    return Done{};
}

/// Returns true if `block` may follow the blocks `before`, which end at file offset `end`: `block`
/// begins there, and its scenarios come after theirs.
bool follows(const BlockEntry& block, std::uint64_t end, const std::vector<BlockEntry>& before) {
    const std::uint64_t first_min = before.empty() ? 0 : before.back().first + before.back().count;
    return block.offset == end && block.count != 0 && block.first >= first_min &&
           block.count <= UINT64_MAX - block.first;
}

} // namespace

Result<BlockFile> BlockFile::open(const std::filesystem::path& path, FileKind kind) {
    Result<DiskFile> opened = DiskFile::open(path);
    if (!opened) {
        return opened.error();
    }
    BlockFile file(std::move(opened.value()), kind);
    if (Status read = file.read_table(); !read) {
        return read.error();
    }
    return file;
}

Result<BlockFile> BlockFile::open_unfinished(const std::filesystem::path& path, FileKind kind) {
    Result<DiskFile> opened = DiskFile::open(path);
    if (!opened) {
        return opened.error();
    }
    BlockFile file(std::move(opened.value()), kind);
    if (Status scanned = file.scan(); !scanned) {
        return scanned.error();
    }
    return file;
}

void BlockFile::append(const BlockEntry& block) {
    blocks_.push_back(block);
    count_ += block.count;
}

std::uint64_t BlockFile::end() const {
    return blocks_.empty() ? header_bytes : end_of(blocks_.back());
}

Status BlockFile::read_table() {
    const Result<std::uint64_t> size = file_.size();
    if (!size) {
        return size.error();
    }
    if (size.value() < header_bytes + footer_bytes) {
        return damaged_file(path(), "it is cut short");
    }
    if (Status kind = check_kind(file_, kind_); !kind) {
        return kind;
    }
    const Result<Bytes> last = file_.read_at(size.value() - footer_bytes, footer_bytes);
    if (!last) {
        return last.error();
    }
    ByteReader footer(last.value());
    const auto blocks = footer.get<std::uint64_t>();
    const auto count = footer.get<std::uint64_t>();
    const auto sum = footer.get<std::uint64_t>();
    const std::uint64_t room = size.value() - header_bytes - footer_bytes;
    if (footer.get<std::uint64_t>() != kind_.magic || blocks > room / row_bytes) {
        return damaged_file(path(), "its table is missing; was it being written?");
    }
    const std::uint64_t table_begin = size.value() - footer_bytes - blocks * row_bytes;
    const Result<Bytes> table = file_.read_at(table_begin, blocks * row_bytes + 2 * word);
    if (!table) {
        return table.error();
    }
    if (checksum(table.value()) != sum) {
        return damaged_file(path(), "its table has a wrong checksum");
    }
    ByteReader in(table.value());
    for (std::uint64_t i = 0; i < blocks; ++i) {
        BlockEntry block;
        block.offset = in.get<std::uint64_t>();
        block.first = in.get<std::uint64_t>();
        block.count = in.get<std::uint64_t>();
        block.bytes = in.get<std::uint64_t>();
        if (!follows(block, end(), blocks_) || block.bytes > table_begin) {
            return damaged_file(path(), "its table is wrong");
        }
        append(block);
    }
    return end() == table_begin && count_ == count ? Status(Done{})
                                                   : damaged_file(path(), "its table is wrong");
}

std::optional<BlockEntry> BlockFile::whole_block_at(std::uint64_t offset,
                                                    std::uint64_t size) const {
    if (size - offset < block_header_bytes + word) {
        return std::nullopt;
    }
    const Result<Bytes> header = file_.read_at(offset, block_header_bytes);
    if (!header) {
        return std::nullopt;
    }
    ByteReader in(header.value());
    BlockEntry block;
    block.offset = offset;
    block.first = in.get<std::uint64_t>();
    block.count = in.get<std::uint64_t>();
    block.bytes = in.get<std::uint64_t>();
    const bool fits = block.bytes <= size - offset - block_header_bytes - word;
    if (!fits || !follows(block, offset, blocks_)) {
        return std::nullopt;
    }
    const Result<Bytes> whole = file_.read_at(offset, block_header_bytes + block.bytes + word);
    if (!whole) {
        return std::nullopt;
    }
    const auto content = std::span(whole.value()).first(block_header_bytes + block.bytes);
    ByteReader sum(std::span(whole.value()).subspan(content.size()));
    return sum.get<std::uint64_t>() == checksum(content) ? std::optional(block) : std::nullopt;
}

Status BlockFile::scan() {
    const Result<std::uint64_t> size = file_.size();
    if (!size) {
        return size.error();
    }
    if (size.value() < header_bytes) {
        return Done{};
    }
    if (Status kind = check_kind(file_, kind_); !kind) {
        return kind;
    }
    while (const auto block = whole_block_at(end(), size.value())) {
        append(*block);
    }
    return Done{};
}

std::optional<std::size_t> BlockFile::block_of(std::uint64_t scenario) const {
    const auto after = std::ranges::upper_bound(blocks_, scenario, {}, &BlockEntry::first);
    return after == blocks_.begin()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(after - blocks_.begin()) - 1);
}

Result<Bytes> BlockFile::read(std::size_t block) const {
    const BlockEntry& entry = blocks_[block];
    Result<Bytes> whole = file_.read_at(entry.offset, block_header_bytes + entry.bytes + word);
    if (!whole) {
        return whole.error();
    }
    const auto content = std::span(whole.value()).first(block_header_bytes + entry.bytes);
    ByteReader sum(std::span(whole.value()).subspan(content.size()));
    ByteReader header(content);
    const bool is_it = header.get<std::uint64_t>() == entry.first &&
                       header.get<std::uint64_t>() == entry.count &&
                       header.get<std::uint64_t>() == entry.bytes;
    if (!is_it || sum.get<std::uint64_t>() != checksum(content)) {
        return damaged_file(path(),
                            "the block of scenario " + std::to_string(entry.first) +
                                " has a wrong checksum");
    }
    const auto payload = content.subspan(block_header_bytes);
    return Bytes(payload.begin(), payload.end());
}

Result<BlockFileWriter> BlockFileWriter::create(const std::filesystem::path& path, FileKind kind) {
    Result<DiskFile> opened = DiskFile::open_to_write(path);
    if (!opened) {
        return opened.error();
    }
    for (const Status& done :
         {opened.value().resize(0), opened.value().write_at(0, header_of(kind))}) {
        if (!done) {
            return done.error();
        }
    }
    return BlockFileWriter(BlockFile(std::move(opened.value()), kind));
}

Result<BlockFileWriter> BlockFileWriter::resume(const std::filesystem::path& path, FileKind kind) {
    Result<BlockFile> scanned = BlockFile::open_unfinished(path, kind);
    if (!scanned) {
        return scanned.error();
    }
    Result<DiskFile> opened = DiskFile::open_to_write(path);
    if (!opened) {
        return opened.error();
    }
    BlockFile file = std::move(scanned.value());
    file.file_ = std::move(opened.value());
    for (const Status& done :
         {file.file_.write_at(0, header_of(kind)), file.file_.resize(file.end())}) {
        if (!done) {
            return done.error();
        }
    }
    return BlockFileWriter(std::move(file));
}

Status
BlockFileWriter::add(std::uint64_t first, std::uint64_t count, std::span<const std::byte> content) {
    const BlockEntry block{file_.end(), first, count, content.size()};
    CD_CHECK(follows(block, file_.end(), file_.blocks_));
    ByteWriter out;
    out.put(block.first);
    out.put(block.count);
    out.put(block.bytes);
    put_bytes(out, content);
    out.put(checksum(out.bytes()));
    if (Status written = file_.file_.write_at(block.offset, out.bytes()); !written) {
        return written;
    }
    file_.append(block);
    return Done{};
}

Status BlockFileWriter::cut_before(std::uint64_t scenario) {
    while (!file_.blocks_.empty() &&
           file_.blocks_.back().first + file_.blocks_.back().count > scenario) {
        file_.count_ -= file_.blocks_.back().count;
        file_.blocks_.pop_back();
    }
    return file_.file_.resize(file_.end());
}

Status BlockFileWriter::finish() {
    ByteWriter out;
    for (const BlockEntry& block : file_.blocks_) {
        out.put(block.offset);
        out.put(block.first);
        out.put(block.count);
        out.put(block.bytes);
    }
    out.put(std::uint64_t{file_.blocks_.size()});
    out.put(file_.count_);
    out.put(checksum(out.bytes()));
    out.put(file_.kind_.magic);
    if (Status written = file_.file_.write_at(file_.end(), out.bytes()); !written) {
        return written;
    }
    return file_.file_.sync();
}

} // namespace cd
