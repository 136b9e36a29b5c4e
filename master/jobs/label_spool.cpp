#include "master/jobs/label_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'42'41'4c'44'43'00'00; // "\0\0CDLAB1"
constexpr std::uint64_t footer_bytes = 6 * sizeof(std::uint64_t);

Bytes encode(const PoseLabels& labels) {
    ByteWriter out;
    out.put_array(std::span<const std::int64_t>(labels.integers));
    for (const std::string& text : labels.texts) {
        out.put_text(text);
    }
    out.put_array(std::span<const double>(labels.times));
    return out.take();
}

/// Returns false if the bytes are not labels of `scenarios` scenarios in these columns.
bool decode(std::span<const std::byte> bytes,
            LabelColumns columns,
            std::size_t scenarios,
            PoseLabels& labels) {
    ByteReader in(bytes);
    const bool has_integers = columns.ids == IdKind::Integer;
    labels.integers = in.get_array<std::int64_t>(has_integers ? scenarios : 0);
    for (std::size_t i = 0; columns.ids == IdKind::Text && i < scenarios && !in.failed(); ++i) {
        labels.texts.push_back(in.get_text());
    }
    labels.times = in.get_array<double>(columns.has_times ? scenarios : 0);
    return in.complete();
}

Error damaged(const DiskFile& file, const std::string& why) {
    return {ErrorCode::Io, file.path().string() + " is damaged: " + why};
}

} // namespace

struct LabelSpool::State {
    State(DiskFile spool, LabelColumns which, std::uint64_t scenarios)
        : file(std::move(spool)), columns(which), announced(scenarios) {}

    DiskFile file;
    LabelColumns columns;
    std::uint64_t announced = 0;         ///< Announced scenarios.
    std::uint64_t count = 0;             ///< Scenarios with labels received.
    std::vector<std::uint64_t> run_ends; ///< Offset of the end of each run on disk.
    std::vector<std::uint64_t> run_sums; ///< Checksum of each run on disk.
    PoseLabels last;                     ///< Labels of the unfinished run, not on disk yet.
    std::size_t last_count = 0;

    [[nodiscard]] std::uint64_t runs_in_all() const {
        return (announced + limits::spool_run_scenarios - 1) / limits::spool_run_scenarios;
    }
    [[nodiscard]] Status write_last();
    [[nodiscard]] Status write_index();
    [[nodiscard]] Status read_index();
    [[nodiscard]] Result<PoseLabels> read_run(std::uint64_t run) const;
};

Status LabelSpool::State::write_last() {
    const std::uint64_t offset = run_ends.empty() ? 0 : run_ends.back();
    const Bytes bytes = encode(last);
    if (Status status = file.write_at(offset, bytes); !status) {
        return status;
    }
    run_ends.push_back(offset + bytes.size());
    run_sums.push_back(checksum(bytes));
    last = {};
    last_count = 0;
    return Done{};
}

/// Writes the runs' ends and checksums, then the magic number, the columns, the numbers of
/// scenarios and runs, and the checksum of all these.
Status LabelSpool::State::write_index() {
    ByteWriter out;
    out.put_array(std::span<const std::uint64_t>(run_ends));
    out.put_array(std::span<const std::uint64_t>(run_sums));
    out.put(magic);
    out.put(static_cast<std::uint64_t>(columns.ids));
    out.put(std::uint64_t{columns.has_times});
    out.put(announced);
    out.put(std::uint64_t{run_ends.size()});
    out.put(checksum(out.bytes()));
    return file.write_at(run_ends.empty() ? 0 : run_ends.back(), out.bytes());
}

Status LabelSpool::State::read_index() {
    const Result<std::uint64_t> size = file.size();
    if (!size) {
        return size.error();
    }
    const std::uint64_t runs = runs_in_all();
    const std::uint64_t index_bytes = 2 * sizeof(std::uint64_t) * runs + footer_bytes;
    if (size.value() < index_bytes) {
        return damaged(file, "it is too short");
    }
    const std::uint64_t begin = size.value() - index_bytes;
    const Result<Bytes> bytes = file.read_at(begin, index_bytes);
    if (!bytes) {
        return bytes.error();
    }
    ByteReader in(bytes.value());
    run_ends = in.get_array<std::uint64_t>(runs);
    run_sums = in.get_array<std::uint64_t>(runs);
    const bool is_ours = in.get<std::uint64_t>() == magic &&
                         in.get<std::uint64_t>() == static_cast<std::uint64_t>(columns.ids) &&
                         in.get<std::uint64_t>() == std::uint64_t{columns.has_times} &&
                         in.get<std::uint64_t>() == announced && in.get<std::uint64_t>() == runs;
    const std::uint64_t sum =
        checksum(std::span(bytes.value()).first(index_bytes - sizeof(std::uint64_t)));
    const bool fits = std::is_sorted(run_ends.begin(), run_ends.end()) &&
                      (run_ends.empty() ? begin == 0 : run_ends.back() == begin);
    if (!is_ours || in.get<std::uint64_t>() != sum || !fits) {
        return damaged(file, "its index has a wrong checksum, or is of another job");
    }
    count = announced;
    return Done{};
}

Result<PoseLabels> LabelSpool::State::read_run(std::uint64_t run) const {
    const std::uint64_t begin = run == 0 ? 0 : run_ends[run - 1];
    const Result<Bytes> bytes = file.read_at(begin, run_ends[run] - begin);
    if (!bytes) {
        return bytes.error();
    }
    const std::uint64_t scenarios = std::min<std::uint64_t>(
        limits::spool_run_scenarios, announced - run * limits::spool_run_scenarios);
    PoseLabels labels;
    if (checksum(bytes.value()) != run_sums[run] ||
        !decode(bytes.value(), columns, scenarios, labels)) {
        return damaged(file, "a run of labels has a wrong checksum");
    }
    return labels;
}

LabelSpool::LabelSpool(std::unique_ptr<State> state) : state_(std::move(state)) {}
LabelSpool::~LabelSpool() = default;

Result<std::unique_ptr<LabelSpool>> LabelSpool::create(const std::filesystem::path& directory,
                                                       LabelColumns columns,
                                                       std::uint64_t scenarios) {
    Result<DiskFile> file = DiskFile::create_for(directory / "labels");
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<LabelSpool>(
        new LabelSpool(std::make_unique<State>(std::move(file.value()), columns, scenarios)));
}

Result<std::unique_ptr<LabelSpool>>
LabelSpool::open(const std::filesystem::path& path, LabelColumns columns, std::uint64_t scenarios) {
    Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return Error{ErrorCode::Io, file.error().detail};
    }
    auto state = std::make_unique<State>(std::move(file.value()), columns, scenarios);
    if (const Status read = state->read_index(); !read) {
        return read.error();
    }
    return std::unique_ptr<LabelSpool>(new LabelSpool(std::move(state)));
}

Status LabelSpool::append(const PoseLabels& labels, std::size_t scenarios) {
    State& state = *state_;
    if (!state.columns.fit(labels, scenarios)) {
        return Error{ErrorCode::BadInput,
                     "ids or times of scenarios that are not those that were announced"};
    }
    const bool is_long = std::ranges::any_of(labels.texts, [](const std::string& text) {
        return text.size() > limits::label_bytes_max;
    });
    if (is_long) {
        return Error{ErrorCode::BadInput,
                     "the id of a scenario is longer than " +
                         std::to_string(limits::label_bytes_max) + " bytes"};
    }
    if (scenarios > state.announced - state.count) {
        return Error{ErrorCode::BadInput, "labels of more scenarios than were announced"};
    }
    for (std::size_t taken = 0; taken < scenarios;) {
        const std::size_t room = limits::spool_run_scenarios - state.last_count;
        const std::size_t count = std::min(scenarios - taken, room);
        state.last.append(labels.slice(taken, count));
        state.last_count += count;
        taken += count;
        if (state.last_count == limits::spool_run_scenarios) {
            if (Status status = state.write_last(); !status) {
                return status;
            }
        }
    }
    state.count += scenarios;
    return Done{};
}

Status LabelSpool::seal(const std::filesystem::path& path, Durability durability) {
    State& state = *state_;
    CD_CHECK(state.count == state.announced);
    if (state.last_count != 0) {
        if (Status status = state.write_last(); !status) {
            return status;
        }
    }
    if (Status status = state.write_index(); !status) {
        return status;
    }
    return state.file.commit_as(path, durability);
}

Status LabelSpool::verify() const {
    for (std::uint64_t run = 0; run < state_->run_ends.size(); ++run) {
        if (const auto labels = state_->read_run(run); !labels) {
            return labels.error();
        }
    }
    return Done{};
}

Result<PoseLabels> LabelSpool::read(std::uint64_t first, std::uint64_t count) const {
    CD_CHECK(first <= state_->announced && count <= state_->announced - first);
    PoseLabels labels;
    for (std::uint64_t taken = 0; taken < count;) {
        const std::uint64_t next = first + taken;
        const std::uint64_t run = next / limits::spool_run_scenarios;
        const Result<PoseLabels> read = state_->read_run(run);
        if (!read) {
            return read.error();
        }
        const std::uint64_t skipped = next % limits::spool_run_scenarios;
        const std::uint64_t there = std::min<std::uint64_t>(
            limits::spool_run_scenarios, state_->announced - run * limits::spool_run_scenarios);
        const std::uint64_t here = std::min(there - skipped, count - taken);
        labels.append(read.value().slice(skipped, here));
        taken += here;
    }
    return labels;
}

} // namespace cd
