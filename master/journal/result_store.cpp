#include "master/journal/result_store.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

namespace cd {

namespace {

static_assert(limits::result_record_bytes_max <= std::numeric_limits<std::uint32_t>::max());
constexpr std::uint64_t magic = 0x31'47'45'53'52'44'43'00; // "\0CDRSEG1"
constexpr std::uint32_t version = 2;
constexpr std::uint64_t file_header_bytes =
    sizeof magic + sizeof version + 2 * sizeof(std::uint64_t);
constexpr std::uint64_t read_ahead_max = 1u << 18;

constexpr std::uint64_t places_together = 256;
using Places = std::array<RecordPlace, places_together>;

Bytes file_header(JobId job) {
    ByteWriter out;
    out.put(magic);
    out.put(version);
    out.put(job.value);
    out.put(checksum(out.bytes()));
    return out.take();
}

Error damaged(const std::filesystem::path& path, const std::string& why) {
    return {ErrorCode::Io, path.string() + " is damaged: " + why};
}

/// Reads records of a segment. Reads ahead while the records asked for are consecutive in the file.
class RecordReader {
  public:
    /// `end`: the committed end of the file.
    RecordReader(DiskFile file, const std::filesystem::path& path, std::uint64_t end)
        : file_(std::move(file)), path_(path), end_(end) {}

    /// Returns the record, which is valid until the next call. Errors: Io naming the scenario if
    /// its checksum is wrong.
    [[nodiscard]] Result<std::span<const std::byte>> read(std::uint64_t scenario,
                                                          const RecordPlace& place);

  private:
    [[nodiscard]] Status fetch(const RecordPlace& place);

    DiskFile file_;
    const std::filesystem::path& path_;
    std::uint64_t end_;
    Bytes bytes_; ///< Of the file from `begin_` on.
    std::uint64_t begin_ = 0;
    std::uint64_t next_ = 0; ///< End of the last record.
    std::uint64_t ahead_ = 0;
};

Status RecordReader::fetch(const RecordPlace& place) {
    const std::uint64_t bytes = place.length + record_footer_bytes;
    ahead_ = place.offset == next_ ? std::min(std::max(2 * ahead_, bytes), read_ahead_max) : 0;
    Result<Bytes> read = file_.read_at(
        place.offset, std::max(bytes, std::min(ahead_, end_ - std::min(end_, place.offset))));
    if (!read) {
        return read.error();
    }
    bytes_ = std::move(read.value());
    begin_ = place.offset;
    return Done{};
}

Result<std::span<const std::byte>> RecordReader::read(std::uint64_t scenario,
                                                      const RecordPlace& place) {
    const std::uint64_t end = ResultStore::end_of(place);
    if (place.offset < begin_ || end > begin_ + bytes_.size()) {
        CD_TRY(fetch(place));
    }
    next_ = end;
    const auto stored = std::span<const std::byte>(bytes_).subspan(
        place.offset - begin_, place.length + record_footer_bytes);
    const auto record = stored.first(place.length);
    if (ByteReader(stored.last(record_footer_bytes)).get<std::uint64_t>() !=
        record_footer(scenario, record)) {
        return damaged(
            path_, "the result of scenario " + std::to_string(scenario) + " has a wrong checksum");
    }
    return record;
}

} // namespace

struct ResultStore::State {
    State(std::filesystem::path where,
          JobId of,
          std::optional<DiskFile> segment,
          std::uint64_t count,
          std::uint64_t committed)
        : path(std::move(where)),
          job(of),
          file(std::move(segment)),
          scenarios(count),
          end(committed) {}

    mutable std::mutex mutex; ///< Guards the members that any thread reads.
    std::filesystem::path path;
    JobId job;
    std::optional<DiskFile> file; ///< Open for writing; empty before the first write.
    bool has_new_name = false;
    std::uint64_t scenarios = 0;
    std::uint64_t end = 0; ///< Committed end of the segment.
    std::uint64_t records = 0;
    /// Record locations in arrays of consecutive scenarios. Made on demand, because a client could
    /// announce a huge number of scenarios.
    std::unordered_map<std::uint64_t, std::unique_ptr<Places>> places;
    std::vector<const ResultBatch*> written; ///< Written and uncommitted records.
    std::uint64_t written_end = 0;

    [[nodiscard]] RecordPlace find(std::uint64_t scenario) const;
    /// Returns the array that has a scenario's location.
    [[nodiscard]] Places& places_of(std::uint64_t scenario);
    void set(Places& piece, std::uint64_t scenario, const RecordPlace& place);
    /// Opens the file for reading. Errors: Io if the file is of another kind or job, or lacks
    /// committed bytes.
    [[nodiscard]] Result<DiskFile> open() const;
    [[nodiscard]] Status make_file();
};

RecordPlace ResultStore::State::find(std::uint64_t scenario) const {
    const auto found = places.find(scenario / places_together);
    return found == places.end() ? RecordPlace{} : (*found->second)[scenario % places_together];
}

Places& ResultStore::State::places_of(std::uint64_t scenario) {
    std::unique_ptr<Places>& piece = places[scenario / places_together];
    if (piece == nullptr) {
        piece = std::make_unique<Places>();
    }
    return *piece;
}

void ResultStore::State::set(Places& piece, std::uint64_t scenario, const RecordPlace& place) {
    RecordPlace& kept = piece[scenario % places_together];
    records += kept.length == 0 ? 1 : 0;
    kept = place;
}

Result<DiskFile> ResultStore::State::open() const {
    Result<DiskFile> opened = DiskFile::open(path);
    if (!opened) {
        return Error{ErrorCode::Io, opened.error().detail};
    }
    const Result<std::uint64_t> size = opened.value().size();
    if (!size) {
        return size.error();
    }
    if (size.value() < end) {
        return damaged(
            path, "it has " + std::to_string(size.value()) + " bytes of " + std::to_string(end));
    }
    const Bytes header = CD_TRY(opened.value().read_at(0, file_header_bytes));
    if (header != file_header(job)) {
        return damaged(path, "its header is not that of the results of this job");
    }
    return opened;
}

// ---- The file -----------------------------------------------------------------------------------

ResultStore::ResultStore(std::unique_ptr<State> state) : state_(std::move(state)) {}
ResultStore::~ResultStore() = default;

std::unique_ptr<ResultStore>
ResultStore::create(const std::filesystem::path& path, JobId job, std::uint64_t scenarios) {
    return std::unique_ptr<ResultStore>(new ResultStore(
        std::make_unique<State>(path, job, std::nullopt, scenarios, file_header_bytes)));
}

std::unique_ptr<ResultStore> ResultStore::open_to_read(const std::filesystem::path& path,
                                                       JobId job,
                                                       std::uint64_t scenarios,
                                                       std::uint64_t end) {
    return std::unique_ptr<ResultStore>(
        new ResultStore(std::make_unique<State>(path, job, std::nullopt, scenarios, end)));
}

Result<std::unique_ptr<ResultStore>> ResultStore::open(const std::filesystem::path& path,
                                                       JobId job,
                                                       std::uint64_t scenarios,
                                                       std::uint64_t end) {
    if (end <= file_header_bytes) {
        return create(path, job, scenarios);
    }
    std::unique_ptr<ResultStore> store = open_to_read(path, job, scenarios, end);
    if (const Result<DiskFile> sound = store->state_->open();
        !sound) { // Fails if the file is missing or unusable.
        return sound.error();
    }
    Result<DiskFile> file = DiskFile::open_to_write(path);
    if (!file) {
        return file.error();
    }
    store->state_->file = std::move(file.value());
    return store;
}

void ResultStore::close() {
    const std::lock_guard lock(state_->mutex);
    state_->file.reset();
}

bool ResultStore::has_new_name() const {
    return state_->has_new_name;
}

void ResultStore::name_synced() {
    state_->has_new_name = false;
}

std::uint64_t ResultStore::first_end() {
    return file_header_bytes;
}

std::uint64_t ResultStore::end() const {
    return state_->end;
}

Status ResultStore::State::make_file() {
    Result<DiskFile> made = DiskFile::open_to_write(path);
    if (!made) {
        return made.error();
    }
    if (Status status = made.value().write_at(0, file_header(job)); !status) {
        return status;
    }
    has_new_name = true;
    const std::lock_guard lock(mutex);
    file = std::move(made.value());
    return Done{};
}

Status ResultStore::write(std::span<const ResultBatch* const> batches) {
    if (!state_->file) {
        CD_TRY(state_->make_file());
    }
    state_->written.assign(batches.begin(), batches.end());
    state_->written_end = state_->end;
    Bytes buffer; // Small batches are written together.
    const auto write = [&](std::span<const std::byte> bytes) {
        const Status status = state_->file->write_at(state_->written_end, bytes);
        state_->written_end += bytes.size();
        return status;
    };
    for (const ResultBatch* batch : batches) {
        for (const ResultRow& row : batch->rows()) {
            CD_CHECK(row.scenario < state_->scenarios);
            CD_CHECK(row.length != 0 && row.length <= limits::result_record_bytes_max);
        }
        buffer.insert(buffer.end(), batch->stored().begin(), batch->stored().end());
        if (buffer.size() >= limits::result_buffer_bytes_max) {
            CD_TRY(write(buffer));
            buffer.clear();
        }
    }
    return write(buffer);
}

Status ResultStore::sync() const {
    return state_->file->sync();
}

void ResultStore::commit() {
    const std::lock_guard lock(state_->mutex);
    Places* piece = nullptr;
    std::uint64_t number = 0; // Of the piece.
    for (const ResultBatch* batch : state_->written) {
        for (const ResultRow& row : batch->rows()) {
            if (piece == nullptr || row.scenario / places_together != number) {
                piece = &state_->places_of(row.scenario);
                number = row.scenario / places_together;
            }
            const RecordPlace place = place_at(state_->end, row.length);
            state_->set(*piece, row.scenario, place);
            state_->end = end_of(place);
        }
    }
    state_->written.clear();
}

void ResultStore::withdraw(std::uint64_t scenario) {
    const std::lock_guard lock(state_->mutex);
    if (state_->find(scenario).length != 0) {
        state_->set(state_->places_of(scenario), scenario, {});
        --state_->records;
    }
}

Status ResultStore::restore(std::uint64_t scenario, const RecordPlace& place) {
    const std::lock_guard lock(state_->mutex);
    const bool is_inside = scenario < state_->scenarios && place.length != 0 &&
                           place.length <= limits::result_record_bytes_max &&
                           place.offset >= file_header_bytes && place.offset <= state_->end &&
                           end_of(place) <= state_->end;
    if (!is_inside) {
        return damaged(state_->path,
                       "the result of scenario " + std::to_string(scenario) + " is not in it");
    }
    state_->set(state_->places_of(scenario), scenario, place);
    return Done{};
}

Status ResultStore::verify(const Visit& visit) const {
    const std::lock_guard lock(state_->mutex);
    // Pairs of offset and scenario.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> in_file_order;
    in_file_order.reserve(state_->records);
    for (const auto& [number, piece] : state_->places) {
        for (std::uint64_t i = 0; i < places_together; ++i) {
            if ((*piece)[i].length != 0) {
                in_file_order.emplace_back((*piece)[i].offset, number * places_together + i);
            }
        }
    }
    std::sort(in_file_order.begin(), in_file_order.end());
    if (in_file_order.empty()) {
        return Done{};
    }
    RecordReader reader(CD_TRY(state_->open()), state_->path, state_->end);
    for (const auto& [offset, scenario] : in_file_order) {
        const auto record = CD_TRY(reader.read(scenario, state_->find(scenario)));
        if (visit) {
            visit(scenario, record);
        }
    }
    return Done{};
}

// ---- Reading ------------------------------------------------------------------------------------

bool ResultStore::has(std::uint64_t scenario) const {
    const std::lock_guard lock(state_->mutex);
    return state_->find(scenario).length != 0;
}

std::uint64_t ResultStore::count() const {
    const std::lock_guard lock(state_->mutex);
    return state_->records;
}

Result<ResultsPart> ResultStore::read(std::uint64_t first,
                                      std::uint64_t count,
                                      std::uint64_t bytes_max,
                                      std::uint64_t sample) const {
    const std::lock_guard lock(state_->mutex);
    const std::uint64_t places = sample == 0 ? state_->scenarios : sample;
    const std::uint64_t begin = std::min(first, places);
    const std::uint64_t end = begin + std::min({count, places - begin, limits::results_scan_max});
    ByteWriter records;
    ResultsPart part;
    part.first = first;
    part.next = std::max(first, end);
    part.are_packed = false;
    std::optional<RecordReader>
        reader; // Made at the first record: a job without results has no file.
    for (std::uint64_t at = begin; at < end; ++at) {
        const std::uint64_t scenario = sampled_scenario(at, sample, state_->scenarios);
        const RecordPlace place = state_->find(scenario);
        if (place.length == 0) {
            continue;
        }
        if (part.count != 0 && records.size() + place.length > bytes_max) {
            part.next = at;
            break;
        }
        if (!reader) {
            reader.emplace(CD_TRY(state_->open()), state_->path, state_->end);
        }
        const auto record = CD_TRY(reader->read(scenario, place));
        records.put(static_cast<std::uint32_t>(place.length));
        put_bytes(records, record);
        if (part.held.empty() || part.held.back().first + part.held.back().count != at) {
            part.held.push_back({at, 0});
        }
        ++part.held.back().count;
        ++part.count;
    }
    part.records = records.take();
    return part;
}

} // namespace cd
