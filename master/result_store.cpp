#include "master/result_store.hpp"

#include "common/core/check.hpp"
#include "common/core/disk_file.hpp"
#include "common/core/hash.hpp"
#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <unordered_map>

namespace cd {

namespace {

static_assert(limits::result_record_bytes_max <= std::numeric_limits<std::uint32_t>::max());
constexpr std::uint64_t header_bytes = 2 * sizeof(std::uint64_t); // Length and checksum.

/// Where a record stands; a length of 0 is no record.
struct RecordPlace {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
};

constexpr std::uint64_t places_together = 256;
using Places = std::array<RecordPlace, places_together>;

} // namespace

struct ResultStore::State {
    State(DiskFile segment, std::uint64_t count) : file(std::move(segment)), scenarios(count) {}

    mutable std::mutex mutex;
    DiskFile file;
    std::uint64_t scenarios = 0;
    std::uint64_t written = 0; ///< Bytes of the file.
    ByteWriter buffer;         ///< What comes after them.
    std::uint64_t records = 0;
    /// In pieces, made when first needed: the number of scenarios is a client's word.
    std::unordered_map<std::uint64_t, std::unique_ptr<Places>> places;

    [[nodiscard]] RecordPlace find(std::uint64_t scenario) const;
    [[nodiscard]] RecordPlace& find_or_add(std::uint64_t scenario);
    [[nodiscard]] Status flush();
    [[nodiscard]] Result<Bytes> read(std::uint64_t scenario, const RecordPlace& place) const;
};

RecordPlace ResultStore::State::find(std::uint64_t scenario) const {
    const auto found = places.find(scenario / places_together);
    return found == places.end() ? RecordPlace{} : (*found->second)[scenario % places_together];
}

RecordPlace& ResultStore::State::find_or_add(std::uint64_t scenario) {
    std::unique_ptr<Places>& piece = places[scenario / places_together];
    if (piece == nullptr) {
        piece = std::make_unique<Places>();
    }
    return (*piece)[scenario % places_together];
}

Status ResultStore::State::flush() {
    if (Status status = file.write_at(written, buffer.bytes()); !status) {
        return status;
    }
    written += buffer.size();
    buffer = ByteWriter();
    return Done{};
}

Result<Bytes> ResultStore::State::read(std::uint64_t scenario, const RecordPlace& place) const {
    Result<Bytes> bytes = file.read_at(place.offset, header_bytes + place.length);
    if (!bytes) {
        return bytes;
    }
    ByteReader in(bytes.value());
    const auto length = in.get<std::uint64_t>();
    const auto sum = in.get<std::uint64_t>();
    const std::span<const std::byte> record = std::span(bytes.value()).subspan(header_bytes);
    if (length != place.length || sum != checksum(record)) {
        return Error{ErrorCode::Io,
                     file.path().string() + " is damaged: the result of scenario " +
                         std::to_string(scenario) + " has a wrong checksum"};
    }
    return Bytes(record.begin(), record.end());
}

ResultStore::ResultStore(std::unique_ptr<State> state) : state_(std::move(state)) {}
ResultStore::~ResultStore() = default;

Result<std::unique_ptr<ResultStore>> ResultStore::create(const std::filesystem::path& directory,
                                                         std::uint64_t scenarios) {
    if (const Status status = make_directories(directory); !status) {
        return status.error();
    }
    Result<DiskFile> file = DiskFile::create_nameless(directory);
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<ResultStore>(
        new ResultStore(std::make_unique<State>(std::move(file.value()), scenarios)));
}

Status ResultStore::add(std::uint64_t scenario, std::span<const std::byte> record) {
    CD_CHECK(scenario < state_->scenarios);
    CD_CHECK(!record.empty());
    if (record.size() > limits::result_record_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "the result of scenario " + std::to_string(scenario) + " takes " +
                         std::to_string(record.size()) +
                         " bytes; ask for a lower level or set "
                         "limit_pairs"};
    }
    const std::lock_guard lock(state_->mutex);
    RecordPlace& place = state_->find_or_add(scenario);
    CD_CHECK(place.length == 0);
    if (state_->buffer.size() >= limits::result_buffer_bytes_max) {
        if (Status status = state_->flush(); !status) {
            return status;
        }
    }
    place = {state_->written + state_->buffer.size(), record.size()};
    state_->buffer.put(place.length);
    state_->buffer.put(checksum(record));
    put_bytes(state_->buffer, record);
    ++state_->records;
    return Done{};
}

bool ResultStore::has(std::uint64_t scenario) const {
    const std::lock_guard lock(state_->mutex);
    return state_->find(scenario).length != 0;
}

std::uint64_t ResultStore::count() const {
    const std::lock_guard lock(state_->mutex);
    return state_->records;
}

Result<ResultsPart>
ResultStore::read(std::uint64_t first, std::uint64_t count, std::uint64_t bytes_max) const {
    const std::lock_guard lock(state_->mutex);
    if (const Status status = state_->flush(); !status) {
        return status.error();
    }
    const std::uint64_t begin = std::min(first, state_->scenarios);
    const std::uint64_t end = begin + std::min(count, state_->scenarios - begin);
    ByteWriter records;
    ResultsPart part;
    part.first = first;
    for (std::uint64_t scenario = begin; scenario < end; ++scenario) {
        const RecordPlace place = state_->find(scenario);
        const bool fits =
            part.count == 0 || (records.size() + place.length <= bytes_max &&
                                part.count < std::numeric_limits<std::uint32_t>::max());
        if (place.length == 0 || !fits) {
            break;
        }
        const Result<Bytes> record = state_->read(scenario, place);
        if (!record) {
            return record.error();
        }
        records.put(static_cast<std::uint32_t>(place.length));
        put_bytes(records, record.value());
        ++part.count;
    }
    part.records = pack_records(records.bytes());
    return part;
}

} // namespace cd
