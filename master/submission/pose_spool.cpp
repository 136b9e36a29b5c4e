#include "master/submission/pose_spool.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <string>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x32'53'4f'50'44'43'00'00; // "\0\0CDPOS2"

} // namespace

AnnouncedPoses announced_by(const Submit& submit) {
    return {submit.scenarios,
            submit.bodies.size(),
            submit.poses.scene.has_value(),
            submit.query.question == Question::Motion};
}

Result<std::unique_ptr<PoseSpool>> PoseSpool::create(const std::filesystem::path& directory,
                                                     const AnnouncedPoses& job) {
    const std::uint64_t scenarios = job.scenarios;
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
    return std::unique_ptr<PoseSpool>(new PoseSpool(std::move(file.value()), job));
}

Result<std::unique_ptr<PoseSpool>> PoseSpool::open(const std::filesystem::path& path,
                                                   const AnnouncedPoses& job) {
    auto file = SpoolFile::open(path, {{magic}, job.scenarios});
    if (!file) {
        return file.error();
    }
    return std::unique_ptr<PoseSpool>(new PoseSpool(std::move(file.value()), job));
}

Status PoseSpool::check_run(const PackedScenarios& run,
                            std::uint64_t first,
                            std::vector<bool>& came) const {
    const std::uint64_t window = first - first % limits::order_window_scenarios;
    if (first == window) {
        came.assign(std::min(file_.scenarios() - window, limits::order_window_scenarios), false);
    }
    for (std::uint64_t i = 0; i < run.count(); ++i) {
        const Result<Scenario> scenario = run.at(i);
        if (!scenario) {
            return scenario.error();
        }
        const auto& [index, body_a, body_b, poses, step, to] = scenario.value();
        const std::string name = "scenario " + std::to_string(index);
        if (index < window || index - window >= came.size()) {
            return Error{ErrorCode::BadInput,
                         name + " where scenarios " + std::to_string(window) + " to " +
                             std::to_string(window + came.size() - 1) + " come"};
        }
        if (came[index - window]) {
            return Error{ErrorCode::BadInput, name + " comes a second time"};
        }
        if (!are_bodies_of_job(body_a, body_b, job_.bodies)) {
            return Error{ErrorCode::BadInput,
                         name + " names bodies " + std::to_string(body_a) + " and " +
                             std::to_string(body_b) + "; the job has 0 to " +
                             std::to_string(job_.bodies - 1) + ", and A comes before B"};
        }
        if (step.has_value() != job_.have_steps) {
            return Error{
                ErrorCode::BadInput,
                name + (step ? " has a step, and the job is no scene" : " of a scene has no step")};
        }
        if (to.has_value() != job_.are_motions) {
            return Error{ErrorCode::BadInput,
                         name + (to ? " moves, and the job asks for no motions"
                                    : " of a job of motions does not move")};
        }
        came[index - window] = true;
    }
    return Done{};
}

Status PoseSpool::append(const Bytes& packed) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t before = count_locked();
    const std::uint64_t left = file_.scenarios() - before;
    const std::uint64_t due = std::min(left, limits::pose_run_scenarios);
    const Result<PackedScenarios> run = PackedScenarios::open(packed, due);
    if (!run && run.error().code == ErrorCode::TooLarge && due == left) {
        return Error{ErrorCode::BadInput,
                     "more scenarios than the " + std::to_string(file_.scenarios()) +
                         " that were announced"};
    }
    if (!run) {
        return run.error();
    }
    if (run.value().count() != due) {
        return Error{ErrorCode::BadInput,
                     "a run of " + std::to_string(run.value().count()) + " scenarios where " +
                         std::to_string(due) + " come together"};
    }
    std::vector<bool> came = came_;
    if (Status sound = check_run(run.value(), before, came); !sound) {
        return sound;
    }
    if (Status written = file_.append(packed); !written) {
        return written;
    }
    came_ = std::move(came);
    return Done{};
}

Status PoseSpool::seal(const std::filesystem::path& path, Durability durability) {
    const std::lock_guard lock(mutex_);
    CD_CHECK(count_locked() == file_.scenarios());
    return file_.seal(path, durability);
}

Status PoseSpool::verify() const {
    std::vector<bool> came;
    for (std::uint64_t number = 0; number < file_.runs(); ++number) {
        const auto found = run(number);
        if (!found) {
            return found.error();
        }
        const Status sound = check_run(found.value(), number * limits::pose_run_scenarios, came);
        if (!sound) {
            return file_.damaged(sound.error().detail);
        }
    }
    return Done{};
}

std::uint64_t PoseSpool::count_locked() const {
    return std::min(file_.runs() * limits::pose_run_scenarios, file_.scenarios());
}

std::uint64_t PoseSpool::count() const {
    const std::lock_guard lock(mutex_);
    return count_locked();
}

bool PoseSpool::is_complete() const {
    return count() == file_.scenarios();
}

Result<PackedScenarios> PoseSpool::run(std::uint64_t number) const {
    SpoolFile::Run on_disk;
    {
        const std::lock_guard lock(mutex_);
        on_disk = file_.run(number);
    }
    Result<Bytes> packed = file_.read(on_disk);
    if (!packed) {
        return packed.error();
    }
    const std::uint64_t left = file_.scenarios() - number * limits::pose_run_scenarios;
    const std::uint64_t due = std::min(left, limits::pose_run_scenarios);
    Result<PackedScenarios> run = PackedScenarios::open(std::move(packed.value()), due);
    if (!run) {
        return file_.damaged(run.error().detail);
    }
    return run.value().count() == due ? std::move(run)
                                      : file_.damaged("a run is shorter than it was written");
}

} // namespace cd
