#include "master/submission/pose_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <mutex>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'53'4f'50'44'43'00'00; // "\0\0CDPOS1"

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

std::uint64_t PoseSpool::count_locked() const {
    return is_sealed_ ? file_.scenarios()
                      : file_.runs() * limits::spool_run_scenarios + last_.size();
}

Error PoseSpool::too_many() const {
    return {ErrorCode::BadInput,
            "more scenarios than the " + std::to_string(file_.scenarios()) +
                " that were announced"};
}

Result<std::vector<Scenario>> PoseSpool::read_run(std::uint64_t run) const {
    SpoolFile::Run on_disk;
    {
        const std::lock_guard lock(mutex_);
        if (run == file_.runs()) {
            return last_;
        }
        on_disk = file_.run(run);
    }
    const Result<Bytes> packed = file_.read(on_disk);
    if (!packed) {
        return packed.error();
    }
    Result<std::vector<Scenario>> scenarios =
        unpack_scenarios(packed.value(), limits::spool_run_scenarios);
    return scenarios ? std::move(scenarios) : file_.damaged(scenarios.error().detail);
}

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
    auto file = SpoolFile::create(directory / "poses", {{magic}, scenarios});
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<PoseSpool>(new PoseSpool(std::move(file.value()), false));
}

Result<std::unique_ptr<PoseSpool>> PoseSpool::open(const std::filesystem::path& path,
                                                   std::uint64_t scenarios) {
    auto file = SpoolFile::open(path, {{magic}, scenarios});
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<PoseSpool>(new PoseSpool(std::move(file.value()), true));
}

Status PoseSpool::seal(const std::filesystem::path& path, Durability durability) {
    const std::lock_guard lock(mutex_);
    CD_CHECK(!is_sealed_ && count_locked() == file_.scenarios());
    if (!last_.empty()) {
        if (Status status = file_.append(pack_scenarios(last_)); !status) {
            return status;
        }
        last_.clear();
    }
    is_sealed_ = true;
    return file_.seal(path, durability);
}

Status PoseSpool::verify() const {
    for (std::size_t run = 0; run < file_.runs(); ++run) {
        if (const auto scenarios = read_run(run); !scenarios) {
            return scenarios.error();
        }
    }
    return Done{};
}

Status PoseSpool::append(std::span<const std::byte> packed) {
    const std::uint64_t left = file_.scenarios() - this->count();
    const Result<std::vector<Scenario>> scenarios =
        unpack_scenarios(packed, std::min(left, limits::poses_part_scenarios_max));
    if (!scenarios && scenarios.error().code == ErrorCode::TooLarge &&
        left <= limits::poses_part_scenarios_max) {
        return too_many();
    }
    if (!scenarios) {
        return scenarios.error();
    }
    const std::lock_guard lock(mutex_);
    const std::uint64_t count = count_locked();
    for (std::size_t i = 0; i < scenarios.value().size(); ++i) {
        if (Status status = check_scenario(scenarios.value()[i], count + i); !status) {
            return status;
        }
    }
    if (scenarios.value().size() > file_.scenarios() - count) {
        return too_many();
    }
    std::vector<Scenario> waiting = last_;
    waiting.insert(waiting.end(), scenarios.value().begin(), scenarios.value().end());
    std::span<const Scenario> rest = waiting;
    const std::size_t runs_before = file_.runs();
    while (rest.size() >= limits::spool_run_scenarios) {
        const Bytes run = pack_scenarios(rest.first(limits::spool_run_scenarios));
        if (Status status = file_.append(run); !status) {
            file_.keep(runs_before);
            return status;
        }
        rest = rest.subspan(limits::spool_run_scenarios);
    }
    last_.assign(rest.begin(), rest.end());
    return Done{};
}

std::uint64_t PoseSpool::count() const {
    const std::lock_guard lock(mutex_);
    return count_locked();
}

bool PoseSpool::is_complete() const {
    return count() == file_.scenarios();
}

Result<std::vector<Scenario>> PoseSpool::read(std::uint64_t first, std::uint64_t count) {
    CD_CHECK(first <= this->count());
    CD_CHECK(count <= this->count() - first);
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    for (const SpoolFile::Slice& slice : SpoolFile::slices(first, count)) {
        const Result<std::vector<Scenario>> run = read_run(slice.run);
        if (!run) {
            return run.error();
        }
        if (run.value().size() < slice.first + slice.count) {
            return file_.damaged("a run is shorter than it was written");
        }
        const auto from = run.value().begin() + static_cast<std::ptrdiff_t>(slice.first);
        scenarios.insert(scenarios.end(), from, from + static_cast<std::ptrdiff_t>(slice.count));
    }
    return scenarios;
}

} // namespace cd
