#include "common/job/result/record_file.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace cd {

namespace {

constexpr FileKind kind{0x31'43'45'52'44'43'00'00, 1}; // "\0\0CDREC1"
constexpr std::uint64_t block_records_max = 4096;
/// A block is full once its uncompressed records have this many bytes.
constexpr std::uint64_t block_bytes_enough = 4u << 20;

/// Decodes the next record, preceded by its length. Errors: those of `decode_result`; Io if it is
/// cut short.
Result<ScenarioResult> next_record(ByteReader& in, std::span<const std::byte>& record) {
    record = in.get_bytes(in.get<std::uint32_t>());
    if (in.failed()) {
        return Error{ErrorCode::Io, "a record is cut short"};
    }
    return decode_result(record);
}

} // namespace

Result<RecordFile> RecordFile::open(const std::filesystem::path& path) {
    Result<BlockFile> file = BlockFile::open(path, kind);
    return file ? Result<RecordFile>(RecordFile(std::move(file.value()))) : file.error();
}

Result<RecordFile> RecordFile::open_unfinished(const std::filesystem::path& path) {
    Result<BlockFile> file = BlockFile::open_unfinished(path, kind);
    return file ? Result<RecordFile>(RecordFile(std::move(file.value()))) : file.error();
}

void RecordFile::keep_only(std::function<bool(const ScenarioResult&)> is_kept) {
    is_kept_ = std::move(is_kept);
    kept_block_.reset();
}

Status RecordFile::for_each_of(std::size_t block,
                               const std::function<Status(const RecordView&)>& take) const {
    const auto damaged = [&](std::string_view detail) {
        return Error{ErrorCode::Io, file_.path().string() + " is damaged: " + std::string(detail)};
    };
    const Bytes packed = CD_TRY(file_.read(block));
    const Result<Bytes> bytes = unpack_records(packed, limits::results_bytes_max);
    if (!bytes) {
        return damaged(bytes.error().detail);
    }
    const BlockPlace& place = file_.blocks()[block];
    // A block's scenarios may have gaps, so the table does not give the last one.
    const std::uint64_t end = block + 1 < blocks() ? file_.blocks()[block + 1].first
                                                   : std::numeric_limits<std::uint64_t>::max();
    ByteReader in(bytes.value());
    std::uint64_t least = place.first;
    std::uint64_t count = 0;
    for (; in.remaining() != 0; ++count) {
        std::span<const std::byte> record;
        Result<ScenarioResult> result = next_record(in, record);
        if (!result) {
            return damaged(result.error().detail);
        }
        const std::uint64_t index = result.value().index;
        if (index < least || (count == 0 && index != least)) {
            return damaged("records are out of their order");
        }
        if (index >= end) {
            return damaged("the scenarios of two blocks overlap");
        }
        least = index + 1;
        if (!is_kept_ || is_kept_(result.value())) {
            CD_TRY(take({record, result.value()}));
        }
    }
    return count == place.count ? Status(Done{}) : damaged("a block has another number of records");
}

Result<std::vector<KeptRecord>> RecordFile::read(std::size_t block) const {
    std::vector<KeptRecord> records;
    records.reserve(std::min(file_.blocks()[block].count, block_records_max));
    CD_TRY(for_each_of(block, [&](const RecordView& record) -> Status {
        records.push_back(
            {Bytes(record.bytes.begin(), record.bytes.end()), std::move(record.result)});
        return Done{};
    }));
    return records;
}

Result<const KeptRecord*> RecordFile::find(std::uint64_t scenario) {
    const KeptRecord* const none = nullptr;
    const auto block = file_.block_of(scenario);
    if (!block) {
        return none;
    }
    if (kept_block_ != block) {
        auto records = read(*block);
        if (!records) {
            return records.error();
        }
        kept_ = std::move(records.value());
        kept_block_ = block;
    }
    const auto found = std::ranges::lower_bound(
        kept_, scenario, {}, [](const KeptRecord& record) { return record.result.index; });
    return found != kept_.end() && found->result.index == scenario ? &*found : none;
}

Status RecordFile::for_each(const std::function<Status(const RecordView&)>& take) const {
    for (std::size_t block = 0; block < blocks(); ++block) {
        CD_TRY(for_each_of(block, take));
    }
    return Done{};
}

Result<RecordWriter> RecordWriter::create(const std::filesystem::path& path) {
    Result<BlockFileWriter> file = BlockFileWriter::create(path, kind);
    return file ? Result<RecordWriter>(RecordWriter(std::move(file.value()))) : file.error();
}

Result<RecordWriter> RecordWriter::resume(const std::filesystem::path& path) {
    Result<BlockFileWriter> file = BlockFileWriter::resume(path, kind);
    return file ? Result<RecordWriter>(RecordWriter(std::move(file.value()))) : file.error();
}

void RecordWriter::add(std::uint64_t scenario, std::span<const std::byte> record) {
    CD_CHECK(!is_full());
    first_ = count_ == 0 ? scenario : first_;
    ++count_;
    waiting_.put(static_cast<std::uint32_t>(record.size()));
    put_bytes(waiting_, record);
}

void RecordWriter::add_run(std::uint64_t first,
                           std::uint64_t count,
                           std::span<const std::byte> records) {
    CD_CHECK(!is_full(count));
    first_ = count_ == 0 ? first : first_;
    count_ += count;
    put_bytes(waiting_, records);
}

bool RecordWriter::is_full(std::uint64_t count) const {
    return count_ + count > block_records_max || waiting_.size() >= block_bytes_enough;
}

Status RecordWriter::flush() {
    if (count_ == 0) {
        return Done{};
    }
    const Bytes packed = pack_records(waiting_.bytes());
    const Status written = file_.add(first_, count_, packed);
    waiting_ = {};
    count_ = 0;
    return written;
}

Status RecordWriter::cut_before(std::uint64_t scenario) {
    return file_.cut_before(scenario);
}

Status RecordWriter::finish() {
    const Status flushed = flush();
    return flushed ? file_.finish() : flushed;
}

} // namespace cd
