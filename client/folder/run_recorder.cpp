#include "client/folder/run_recorder.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_map.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr FileKind maps_kind{0x31'50'41'4d'44'43'00'00, 1}; // "\0\0CDMAP1"

template <class Writer, class... Kind>
Result<Writer> open_writer(const std::filesystem::path& path, Kind... kind) {
    std::error_code error;
    return std::filesystem::exists(path, error) ? Writer::resume(path, kind...)
                                                : Writer::create(path, kind...);
}

} // namespace

Result<RunRecorder> RunRecorder::open(const std::filesystem::path& folder,
                                      bool with_maps,
                                      std::chrono::milliseconds period) {
    auto records = open_writer<RecordWriter>(folder / "records");
    if (!records) {
        return records.error();
    }
    if (!with_maps) {
        return RunRecorder(std::move(records.value()), std::nullopt, period);
    }
    auto maps = open_writer<BlockFileWriter>(folder / "maps", maps_kind);
    if (!maps) {
        return maps.error();
    }
    // A block of `maps` is written before the records of its scenarios, so a killed run may have
    // left a block of `maps` without records.
    const std::uint64_t both = std::min(records.value().written(), maps.value().written().count());
    for (const Status& cut : {records.value().cut_before(both), maps.value().cut_before(both)}) {
        if (!cut) {
            return cut.error();
        }
    }
    return RunRecorder(std::move(records.value()), std::move(maps.value()), period);
}

Status RunRecorder::add(const DoneScenario& done) {
    first_waiting_ = waiting_ == 0 ? done.result.index : first_waiting_;
    ++waiting_;
    records_.add(done.result.index, done.record);
    if (maps_) {
        map_.add(done.found);
    }
    return records_.is_full() ? flush() : flush_if_due();
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
        if (Status written = maps_->add(first_waiting_, waiting_, packed); !written) {
            return written;
        }
    }
    waiting_ = 0;
    return records_.flush();
}

Status RunRecorder::finish() {
    if (Status flushed = flush(); !flushed) {
        return flushed;
    }
    if (maps_) {
        if (Status finished = maps_->finish(); !finished) {
            return finished;
        }
    }
    return records_.finish();
}

Status
write_maps(const std::filesystem::path& path, const ContactMap& map, std::uint64_t scenarios) {
    auto file = BlockFileWriter::create(path, maps_kind);
    if (!file) {
        return file.error();
    }
    if (Status added = file.value().add(0, scenarios, pack_map(map)); !added) {
        return added;
    }
    return file.value().finish();
}

Result<ContactMap> read_maps(const std::filesystem::path& path) {
    const auto file = BlockFile::open(path, maps_kind);
    if (!file) {
        return file.error();
    }
    ContactMapTotal total;
    for (std::size_t i = 0; i < file.value().blocks().size(); ++i) {
        const Result<Bytes> packed = file.value().read(i);
        if (!packed) {
            return packed.error();
        }
        const ContactMapBounds bounds{
            limits::mesh_triangles_max, limits::mesh_triangles_max, file.value().blocks()[i].count};
        const auto map = unpack_map(packed.value(), bounds);
        if (!map) {
            return Error{ErrorCode::Io, path.string() + " is damaged: " + map.error().detail};
        }
        total.add(map.value());
    }
    return total.map();
}

} // namespace cd
