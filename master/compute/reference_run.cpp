#include "master/compute/reference_run.hpp"

#include "common/job/run_scenario.hpp"
#include "master/compute/placed_scenario.hpp"

#include <algorithm>

namespace cd {

Result<ReferenceResult> reference_result(const JobMaterial& material,
                                         OrderedPoses& poses,
                                         std::uint64_t scenario,
                                         const StopCheck& stop) {
    const Result<PlacedScenario> read = read_one(poses, scenario);
    if (!read) {
        return read.error();
    }
    const ScenarioRunner runner(
        TreesByBody(material.trees), material.query, PairStage::Float, stop);
    ScenarioRun run;
    run.is_stopped = stop();
    if (!run.is_stopped) {
        run = runner.run(read.value().scenario);
    }
    if (run.is_stopped) {
        run.result = failed_result(
            read.value().scenario, material.query, {ErrorCode::Interrupted, "cancelled"});
    }
    ReferenceResult found;
    found.taken.add(run.result, read.value().position, {});
    found.is_stopped = run.is_stopped;
    return found;
}

Result<ContactMap> reference_map(const JobMaterial& material,
                                 OrderedPoses& poses,
                                 std::span<const std::uint64_t> scenarios) {
    const ScenarioRunner runner(TreesByBody(material.trees), material.query);
    ScenarioSession session(runner);
    ContactMapSum sum(material.parts);
    for (const std::uint64_t scenario : scenarios) {
        const Result<PlacedScenario> read = read_one(poses, scenario);
        if (!read) {
            return read.error();
        }
        const ScenarioRun run = session.run(read.value().scenario);
        sum.add(run.result, run.found);
    }
    return sum.take();
}

void ReferenceRuns::start(JobId job,
                          std::uint64_t scenario,
                          std::shared_ptr<const JobMaterial> material,
                          std::shared_ptr<OrderedPoses> poses,
                          Done done) {
    if (is_closed_) {
        return;
    }
    const auto run = std::make_shared<Run>();
    const auto place = runs_.emplace(std::pair(job, scenario), run);
    background_.block(
        [run, scenario, material = std::move(material), poses = std::move(poses)] {
            const auto stop = [&] { return run->is_stopped.load(); };
            return reference_result(*material, *poses, scenario, stop);
        },
        [this, place, run, done = std::move(done)](Result<ReferenceResult> found) {
            if (!run->is_closed) {
                runs_.erase(place);
                done(std::move(found));
            }
        });
}

bool ReferenceRuns::stop(JobId job, std::optional<std::uint64_t> scenario) {
    bool any = false;
    for (const auto& [place, run] : runs_) {
        if (place.first == job && (!scenario || place.second == *scenario)) {
            run->is_stopped = true;
            any = true;
        }
    }
    return any;
}

void ReferenceRuns::close() {
    is_closed_ = true;
    for (const auto& [place, run] : runs_) {
        run->is_stopped = true;
        run->is_closed = true;
    }
    runs_.clear();
}

} // namespace cd
