#include "common/job/result/record_file.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

#include <algorithm>
#include <string>

namespace cd {

namespace {

constexpr FileKind kind{0x31'43'45'52'44'43'00'00, 1}; // "\0\0CDREC1"
constexpr std::uint64_t block_records_max = 4096;
/// A block is full once its uncompressed records have this many bytes.
constexpr std::uint64_t block_bytes_enough = 4u << 20;

/// Decodes records, each preceded by its length. Errors: those of `decode_result`; Io unless there
/// are `block.count` records, in ascending order from scenario `block.first`.
Result<std::vector<KeptRecord>> records_in(std::span<const std::byte> bytes,
                                           const BlockPlace& block) {
    std::vector<KeptRecord> records;
    ByteReader in(bytes);
    while (in.remaining() != 0) {
        const auto record = in.get_bytes(in.get<std::uint32_t>());
        if (in.failed()) {
            return Error{ErrorCode::Io, "a record is cut short"};
        }
        Result<ScenarioResult> result = decode_result(record);
        if (!result) {
            return result.error();
        }
        const std::uint64_t index = result.value().index;
        if (records.empty() ? index != block.first : index <= records.back().result.index) {
            return Error{ErrorCode::Io, "records are out of their order"};
        }
        records.push_back({Bytes(record.begin(), record.end()), std::move(result.value())});
    }
    if (records.size() != block.count) {
        return Error{ErrorCode::Io, "a block has another number of records"};
    }
    return records;
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

Result<std::vector<KeptRecord>> RecordFile::read(std::size_t block) const {
    const Result<Bytes> packed = file_.read(block);
    if (!packed) {
        return packed.error();
    }
    const auto damaged = [&](const Error& error) {
        return Error{ErrorCode::Io, file_.path().string() + " is damaged: " + error.detail};
    };
    const Result<Bytes> bytes = unpack_records(packed.value(), limits::results_bytes_max);
    if (!bytes) {
        return damaged(bytes.error());
    }
    auto records = records_in(bytes.value(), file_.blocks()[block]);
    if (!records) {
        return damaged(records.error());
    }
    // A block's scenarios may have gaps, so the table does not give the last one.
    if (block + 1 < blocks() &&
        records.value().back().result.index >= file_.blocks()[block + 1].first) {
        return damaged({ErrorCode::Io, "the scenarios of two blocks overlap"});
    }
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

Status RecordFile::for_each(const std::function<Status(const KeptRecord&)>& take) const {
    for (std::size_t block = 0; block < blocks(); ++block) {
        const auto records = read(block);
        if (!records) {
            return records.error();
        }
        for (const KeptRecord& record : records.value()) {
            if (Status taken = take(record); !taken) {
                return taken;
            }
        }
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
