#include "client/folder/run_recorder.hpp"

#include "common/core/errors.hpp"
#include "common/job/result/packed_map.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr FileKind maps_kind{0x31'50'41'4d'44'43'00'00, 2}; // "\0\0CDMAP1"

template <class Writer, class... Kind>
Result<Writer> open_writer(const std::filesystem::path& path, Kind... kind) {
    std::error_code error;
    return std::filesystem::exists(path, error) ? Writer::resume(path, kind...)
                                                : Writer::create(path, kind...);
}

} // namespace

Result<RunRecorder> RunRecorder::open(const std::filesystem::path& folder,
                                      const std::shared_ptr<const BodyPartRuns>& parts,
                                      std::chrono::milliseconds period) {
    auto records = CD_TRY(open_writer<RecordWriter>(folder / "records"));
    if (parts == nullptr) {
        return RunRecorder(std::move(records), std::nullopt, parts, period);
    }
    auto maps = CD_TRY(open_writer<BlockFileWriter>(folder / "maps", maps_kind));
    // A block of `maps` is written before the block with its scenarios' records, so a killed run
    // may have left a block of `maps` without records.
    const std::uint64_t both = std::min(records.written(), maps.written().count());
    for (const Status& cut : {records.cut_before(both), maps.cut_before(both)}) {
        if (!cut) {
            return cut.error();
        }
    }
    return RunRecorder(std::move(records), std::move(maps), parts, period);
}

Status RunRecorder::add(const DoneScenario& done) {
    first_waiting_ = waiting_ == 0 ? done.result.index : first_waiting_;
    ++waiting_;
    records_.add(done.result.index, done.record);
    if (maps_) {
        map_.add(done.result, done.found);
    }
    return records_.is_full() ? flush() : flush_if_due();
}

Status RunRecorder::add(const DoneBlock& done) {
    if (maps_) {
        return done.for_each([&](const DoneScenario& one) { return add(one); });
    }
    if (records_.is_full(done.size())) {
        CD_TRY(flush());
    }
    first_waiting_ = waiting_ == 0 ? done.first() : first_waiting_;
    waiting_ += done.size();
    records_.add_run(done.first(), done.size(), done.records());
    return flush_if_due();
}

Status RunRecorder::flush_if_due() {
    const bool is_due = std::chrono::steady_clock::now() - flushed_ >= period_;
    return is_due ? flush() : Status(Done{});
}

Status RunRecorder::flush() {
    flushed_ = std::chrono::steady_clock::now();
    if (waiting_ == 0) {
        return Done{};
    }
    if (maps_) {
        const Bytes packed = pack_map(map_.take());
        CD_TRY(maps_->add(first_waiting_, waiting_, packed));
    }
    waiting_ = 0;
    return records_.flush();
}

Status RunRecorder::finish() {
    CD_TRY(flush());
    if (maps_) {
        CD_TRY(maps_->finish());
    }
    return records_.finish();
}

Status
write_maps(const std::filesystem::path& path, const ContactMap& map, std::uint64_t scenarios) {
    auto file = CD_TRY(BlockFileWriter::create(path, maps_kind));
    CD_TRY(file.add(0, scenarios, pack_map(map)));
    return file.finish();
}

Result<ContactMap> read_maps(const std::filesystem::path& path) {
    const auto file = CD_TRY(BlockFile::open(path, maps_kind));
    ContactMapTotal total;
    for (std::size_t i = 0; i < file.blocks().size(); ++i) {
        const Bytes packed = CD_TRY(file.read(i));
        const auto map = unpack_map(packed, any_map(file.blocks()[i].count));
        if (!map) {
            return Error{ErrorCode::Io, path.string() + " is damaged: " + map.error().detail};
        }
        total.add(map.value());
    }
    return total.map();
}

} // namespace cd
