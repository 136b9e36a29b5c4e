#include "client/document/run_overview.hpp"

#include "common/core/errors.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "common/job/result/severity.hpp"
#include "web/server/scenario_repeat.hpp"

#include <algorithm>
#include <utility>

namespace cd {

RunOverview::RunOverview(GroupSum groups, std::uint64_t scenarios)
    : groups_(std::move(groups)), classes_(scenarios, no_result) {}

Result<RunOverview> RunOverview::read(const RecordFile& records,
                                      GroupSum groups,
                                      std::uint64_t scenarios,
                                      const StopCheck& stop,
                                      const std::optional<SceneHead>& scene) {
    const std::size_t bodies = groups.bodies();
    RunOverview overview(std::move(groups), scenarios);
    ResultMerger merger(scenarios, scene);
    CD_TRY(records.for_each([&](const RecordView& record) {
        if (stop && stop()) {
            return Status(interrupted());
        }
        const ScenarioResult& result = record.result;
        if (std::max(result.body_a, result.body_b) >= bodies || result.index >= scenarios) {
            return Status(bad_input("the run has no such scenario or body as the record of "
                                    "scenario " +
                                    std::to_string(result.index) + " names"));
        }
        static_cast<void>(merger.add(result, digest_of_record(record.bytes)));
        overview.add(result);
        return Status(Done{});
    }));
    overview.summary_ = merger.summary();
    overview.digest_ = merger.digest();
    return overview;
}

Status
RunOverview::restrict_to(const BodyChoice& bodies, PoseSource& poses, const StopCheck& stop) {
    constexpr std::uint64_t scenarios_at_once = 1u << 16;
    for (std::uint64_t first = 0; first < classes_.size(); first += scenarios_at_once) {
        if (stop && stop()) {
            return interrupted();
        }
        const std::uint64_t count =
            std::min<std::uint64_t>(scenarios_at_once, classes_.size() - first);
        for (const Scenario& scenario : CD_TRY(poses.read(first, count))) {
            if (!bodies.has(scenario.body_a, scenario.body_b)) {
                classes_[scenario.index] = left_out;
            }
        }
    }
    bodies_ = bodies.text();
    digest_.reset();
    summary_.total -= static_cast<std::uint64_t>(std::ranges::count(classes_, left_out));
    return Done{};
}

Status RunOverview::add_pairs_to_worst(const PreparedJob& job,
                                       std::chrono::milliseconds run_max,
                                       const StopCheck& stop) {
    for (ScenarioResult& result : worst_) {
        const auto scenarios = CD_TRY(job.poses->read(result.index, 1));
        const auto until = std::chrono::steady_clock::now() + run_max;
        const ScenarioView again = repeat_scenario(
            TreesByBody(job.trees),
            job.query,
            scenarios.front(),
            std::nullopt, // Without the record, it is run once, for its pairs alone.
            [&] { return std::chrono::steady_clock::now() >= until || (stop && stop()); });
        if (stop && stop()) {
            return interrupted();
        }
        if (again.drawn != nullptr) {
            result.pairs = again.drawn->pairs;
            result.point_origins = again.drawn->point_origins;
            result.point_offsets = again.drawn->point_offsets;
            result.points = again.drawn->points;
        }
    }
    return Done{};
}

void RunOverview::add(const ScenarioResult& result) {
    classes_[result.index] = static_cast<std::uint8_t>(result.kind);
    groups_.add(result);
    if (is_hit(result.kind)) {
        add_to_worst(result);
    }
    if (result.nearest) {
        add_distance(result);
    }
    if (result.kind == ScenarioClass::Failed && failures_.size() < failures_max) {
        failures_.push_back({result.index, result.failure});
    }
}

void RunOverview::add_distance(const ScenarioResult& result) {
    distances_.push_back(result.nearest->distance);
    const auto is_farther = [&](const ScenarioResult& each) {
        return each.nearest->distance > result.nearest->distance;
    };
    const auto place = std::ranges::find_if(nearest_, is_farther);
    if (place == nearest_.end() && nearest_.size() == nearest_max) {
        return;
    }
    list_witness(*nearest_.insert(place, result));
    nearest_.resize(std::min(nearest_.size(), nearest_max));
}

std::vector<ScenarioResult> RunOverview::pictured() const {
    std::vector<ScenarioResult> results = worst_;
    results.insert(results.end(), nearest_.begin(), nearest_.end());
    return results;
}

void RunOverview::add_to_worst(const ScenarioResult& result) {
    const auto is_better = [&](const ScenarioResult& each) {
        return badness_of(each) < badness_of(result);
    };
    const auto place = std::ranges::find_if(worst_, is_better);
    if (place == worst_.end() && worst_.size() == worst_max) {
        return;
    }
    worst_.insert(place, result);
    worst_.resize(std::min(worst_.size(), worst_max));
}

} // namespace cd
