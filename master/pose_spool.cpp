#include "master/pose_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/disk_file.hpp"
#include "common/core/limits.hpp"

#include <algorithm>
#include <mutex>

namespace cd {

namespace {

/// What a job of two bodies can be asked.
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
    std::vector<std::uint64_t> run_ends; ///< In bytes, of each run on disk.
    std::vector<Scenario> last;          ///< Fewer than a run, not on disk.

    [[nodiscard]] std::uint64_t count() const {
        return run_ends.size() * limits::spool_run_scenarios + last.size();
    }
    [[nodiscard]] Status write_run(std::span<const Scenario> run);
    [[nodiscard]] Result<std::vector<Scenario>> read_run(std::uint64_t run) const;
};

Status PoseSpool::State::write_run(std::span<const Scenario> run) {
    const std::uint64_t offset = run_ends.empty() ? 0 : run_ends.back();
    const Bytes packed = pack_scenarios(run);
    if (Status status = file.write_at(offset, packed); !status) {
        return status;
    }
    run_ends.push_back(offset + packed.size());
    return Done{};
}

Result<std::vector<Scenario>> PoseSpool::State::read_run(std::uint64_t run) const {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    {
        const std::lock_guard lock(mutex);
        if (run == run_ends.size()) {
            return last;
        }
        begin = run == 0 ? 0 : run_ends[run - 1];
        end = run_ends[run];
    }
    const Result<Bytes> packed = file.read_at(begin, end - begin);
    if (!packed) {
        return packed.error();
    }
    Result<std::vector<Scenario>> scenarios = unpack_scenarios(packed.value());
    if (!scenarios) {
        return Error{ErrorCode::Io,
                     file.path().string() + " is damaged: " + scenarios.error().detail};
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
    Result<DiskFile> file = DiskFile::create_nameless(directory);
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<PoseSpool>(
        new PoseSpool(std::make_unique<State>(std::move(file.value()), scenarios)));
}

Status PoseSpool::append(std::span<const std::byte> packed) {
    const Result<std::vector<Scenario>> scenarios = unpack_scenarios(packed);
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
        return Error{ErrorCode::BadInput,
                     "more scenarios than the " + std::to_string(state_->announced) +
                         " that were announced"};
    }
    std::vector<Scenario> waiting = state_->last;
    waiting.insert(waiting.end(), scenarios.value().begin(), scenarios.value().end());
    std::span<const Scenario> rest = waiting;
    const std::size_t runs_before = state_->run_ends.size();
    while (rest.size() >= limits::spool_run_scenarios) {
        if (Status status = state_->write_run(rest.first(limits::spool_run_scenarios)); !status) {
            state_->run_ends.resize(runs_before);
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
        // Less than was written can only be damage.
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
