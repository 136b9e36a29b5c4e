#include "master/jobs/pose_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <mutex>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'53'4f'50'44'43'00'00; // "\0\0CDPOS1"
constexpr std::uint64_t footer_bytes = 4 * sizeof(std::uint64_t);

Error damaged(const DiskFile& file, const std::string& why) {
    return {ErrorCode::Io, file.path().string() + " is damaged: " + why};
}

/// Checks a scenario of a job with two bodies.
Status check_scenario(const Scenario& scenario, std::uint64_t expected) {
    if (scenario.index != expected) {
        return Error{ErrorCode::BadInput,
                     "scenario " + std::to_string(scenario.index) + " where scenario " +
                         std::to_string(expected) + " comes next"};
    }
    if (scenario.body_a != 0 || scenario.body_b != 1) {
        return Error{ErrorCode::BadInput,
                     "scenario " + std::to_string(scenario.index) + " names bodies " +
                         std::to_string(scenario.body_a) + " and " +
                         std::to_string(scenario.body_b) + "; the job has 0 and 1"};
    }
    return Done{};
}

} // namespace

struct PoseSpool::State {
    State(DiskFile spool, std::uint64_t scenarios) : file(std::move(spool)), announced(scenarios) {}

    mutable std::mutex mutex;
    DiskFile file;
    std::uint64_t announced = 0;
    std::vector<std::uint64_t> run_ends; ///< End of each run on disk, in bytes.
    std::vector<std::uint64_t> run_sums; ///< Checksum of each run on disk.
    std::vector<Scenario> last;          ///< Fewer than a run; not on disk yet.
    bool is_sealed = false;              ///< Only a sealed file may end with a short run.

    [[nodiscard]] std::uint64_t count() const {
        return is_sealed ? announced : run_ends.size() * limits::spool_run_scenarios + last.size();
    }
    [[nodiscard]] Error too_many() const {
        return {ErrorCode::BadInput,
                "more scenarios than the " + std::to_string(announced) + " that were announced"};
    }
    [[nodiscard]] Status write_run(std::span<const Scenario> run);
    [[nodiscard]] Status write_index();
    [[nodiscard]] Status read_index();
    [[nodiscard]] Result<std::vector<Scenario>> read_run(std::uint64_t run) const;
};

Status PoseSpool::State::write_run(std::span<const Scenario> run) {
    const std::uint64_t offset = run_ends.empty() ? 0 : run_ends.back();
    const Bytes packed = pack_scenarios(run);
    if (Status status = file.write_at(offset, packed); !status) {
        return status;
    }
    run_ends.push_back(offset + packed.size());
    run_sums.push_back(checksum(packed));
    return Done{};
}

/// Writes the runs' ends and checksums, then the file kind, the numbers of scenarios and runs, and
/// the checksum of all these.
Status PoseSpool::State::write_index() {
    ByteWriter out;
    out.put_array(std::span<const std::uint64_t>(run_ends));
    out.put_array(std::span<const std::uint64_t>(run_sums));
    out.put(magic);
    out.put(announced);
    out.put(std::uint64_t{run_ends.size()});
    out.put(checksum(out.bytes()));
    return file.write_at(run_ends.empty() ? 0 : run_ends.back(), out.bytes());
}

Status PoseSpool::State::read_index() {
    const Result<std::uint64_t> size = file.size();
    if (!size) {
        return size.error();
    }
    const std::uint64_t runs =
        (announced + limits::spool_run_scenarios - 1) / limits::spool_run_scenarios;
    const std::uint64_t index_bytes = 2 * runs * sizeof(std::uint64_t) + footer_bytes;
    if (size.value() < index_bytes) {
        return damaged(file, "it is cut short");
    }
    const std::uint64_t begin = size.value() - index_bytes;
    const Result<Bytes> bytes = file.read_at(begin, index_bytes);
    if (!bytes) {
        return bytes.error();
    }
    ByteReader in(bytes.value());
    run_ends = in.get_array<std::uint64_t>(runs);
    run_sums = in.get_array<std::uint64_t>(runs);
    const bool is_whole = in.get<std::uint64_t>() == magic &&
                          in.get<std::uint64_t>() == announced && in.get<std::uint64_t>() == runs &&
                          in.get<std::uint64_t>() ==
                              checksum(std::span(bytes.value()).first(index_bytes - sizeof runs));
    const bool fits = std::is_sorted(run_ends.begin(), run_ends.end()) &&
                      (run_ends.empty() ? begin == 0 : run_ends.back() == begin);
    if (!is_whole || !fits) {
        return damaged(file, "its index has a wrong checksum, or is of another job");
    }
    is_sealed = true;
    return Done{};
}

Result<std::vector<Scenario>> PoseSpool::State::read_run(std::uint64_t run) const {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::uint64_t sum = 0;
    {
        const std::lock_guard lock(mutex);
        if (run == run_ends.size()) {
            return last;
        }
        begin = run == 0 ? 0 : run_ends[run - 1];
        end = run_ends[run];
        sum = run_sums[run];
    }
    const Result<Bytes> packed = file.read_at(begin, end - begin);
    if (!packed) {
        return packed.error();
    }
    if (checksum(packed.value()) != sum) {
        return damaged(file, "a run of poses has a wrong checksum");
    }
    Result<std::vector<Scenario>> scenarios =
        unpack_scenarios(packed.value(), limits::spool_run_scenarios);
    if (!scenarios) {
        return damaged(file, scenarios.error().detail);
    }
    return scenarios;
}

PoseSpool::PoseSpool(std::unique_ptr<State> state) : state_(std::move(state)) {}
PoseSpool::~PoseSpool() = default;

Result<std::unique_ptr<PoseSpool>> PoseSpool::create(const std::filesystem::path& directory,
                                                     std::uint64_t scenarios) {
    if (scenarios > limits::scenarios_max) {
        return Error{ErrorCode::TooLarge,
                     "a job of " + std::to_string(scenarios) + " scenarios; at most " +
                         std::to_string(limits::scenarios_max) + " are allowed"};
    }
    if (const Status status = make_directories(directory); !status) {
        return status.error();
    }
    Result<DiskFile> file = DiskFile::create_for(directory / "poses");
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<PoseSpool>(
        new PoseSpool(std::make_unique<State>(std::move(file.value()), scenarios)));
}

Result<std::unique_ptr<PoseSpool>> PoseSpool::open(const std::filesystem::path& path,
                                                   std::uint64_t scenarios) {
    Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return Error{ErrorCode::Io, file.error().detail};
    }
    auto state = std::make_unique<State>(std::move(file.value()), scenarios);
    if (const Status read = state->read_index(); !read) {
        return read.error();
    }
    return std::unique_ptr<PoseSpool>(new PoseSpool(std::move(state)));
}

Status PoseSpool::seal(const std::filesystem::path& path, Durability durability) {
    CD_CHECK(is_complete());
    const std::lock_guard lock(state_->mutex);
    CD_CHECK(!state_->is_sealed);
    if (!state_->last.empty()) {
        if (Status status = state_->write_run(state_->last); !status) {
            return status;
        }
        state_->last.clear();
    }
    if (Status status = state_->write_index(); !status) {
        return status;
    }
    state_->is_sealed = true;
    return state_->file.commit_as(path, durability);
}

Status PoseSpool::verify() const {
    const std::size_t runs = state_->run_ends.size();
    for (std::size_t run = 0; run < runs; ++run) {
        if (const auto scenarios = state_->read_run(run); !scenarios) {
            return scenarios.error();
        }
    }
    return Done{};
}

Status PoseSpool::append(std::span<const std::byte> packed) {
    const std::uint64_t left = state_->announced - this->count();
    const Result<std::vector<Scenario>> scenarios =
        unpack_scenarios(packed, std::min(left, limits::poses_part_scenarios_max));
    if (!scenarios && scenarios.error().code == ErrorCode::TooLarge &&
        left <= limits::poses_part_scenarios_max) {
        return state_->too_many();
    }
    if (!scenarios) {
        return scenarios.error();
    }
    const std::lock_guard lock(state_->mutex);
    const std::uint64_t count = state_->count();
    for (std::size_t i = 0; i < scenarios.value().size(); ++i) {
        if (Status status = check_scenario(scenarios.value()[i], count + i); !status) {
            return status;
        }
    }
    if (scenarios.value().size() > state_->announced - count) {
        return state_->too_many();
    }
    std::vector<Scenario> waiting = state_->last;
    waiting.insert(waiting.end(), scenarios.value().begin(), scenarios.value().end());
    std::span<const Scenario> rest = waiting;
    const std::size_t runs_before = state_->run_ends.size();
    while (rest.size() >= limits::spool_run_scenarios) {
        if (Status status = state_->write_run(rest.first(limits::spool_run_scenarios)); !status) {
            state_->run_ends.resize(runs_before);
            state_->run_sums.resize(runs_before);
            return status;
        }
        rest = rest.subspan(limits::spool_run_scenarios);
    }
    state_->last.assign(rest.begin(), rest.end());
    return Done{};
}

std::uint64_t PoseSpool::count() const {
    const std::lock_guard lock(state_->mutex);
    return state_->count();
}

bool PoseSpool::is_complete() const {
    return count() == state_->announced;
}

Result<std::vector<Scenario>> PoseSpool::read(std::uint64_t first, std::uint64_t count) {
    CD_CHECK(first <= this->count());
    CD_CHECK(count <= this->count() - first);
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    while (scenarios.size() < count) {
        const std::uint64_t next = first + scenarios.size();
        const Result<std::vector<Scenario>> run =
            state_->read_run(next / limits::spool_run_scenarios);
        if (!run) {
            return run.error();
        }
        const std::uint64_t skipped = next % limits::spool_run_scenarios;
        // A shorter run than was written is damaged.
        if (run.value().size() <= skipped) {
            return Error{ErrorCode::Io, state_->file.path().string() + " is damaged"};
        }
        const std::uint64_t taken =
            std::min<std::uint64_t>(run.value().size() - skipped, count - scenarios.size());
        const auto from = run.value().begin() + static_cast<std::ptrdiff_t>(skipped);
        scenarios.insert(scenarios.end(), from, from + static_cast<std::ptrdiff_t>(taken));
    }
    return scenarios;
}

} // namespace cd
