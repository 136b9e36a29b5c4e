#include "common/job/run_motion.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/job/answer_poses.hpp"
#include "common/motion/cells.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace cd {

namespace {

/// Returns the class of a motion at level any from its answer.
ScenarioClass class_of(const MotionAnswer& answer, bool touches_at_event) {
    if (answer.event()) {
        return touches_at_event ? ScenarioClass::Contact : ScenarioClass::Near;
    }
    const bool is_free = !answer.has_open_run() && answer.end != MotionEnd::Limit;
    return is_free ? ScenarioClass::Separate : ScenarioClass::Undecided;
}

double bound_of(const MotionAnswer& answer, ScenarioClass kind) {
    if (kind != ScenarioClass::Undecided) {
        return 0;
    }
    return answer.end == MotionEnd::Limit ? std::numeric_limits<double>::infinity()
                                          : answer.open_within;
}

/// Moves the answer into the result of a run, and its cells into the statistics.
void note_answer(MotionAnswer answer, bool touches_at_event, ScenarioRun& run) {
    run.statistics.effort += {answer.cells, answer.leaves, 0, 0};
    ScenarioResult& result = run.result;
    result.kind = class_of(answer, touches_at_event);
    result.distance_bound = bound_of(answer, result.kind);
    result.motion = std::move(answer);
}

} // namespace

std::vector<double> radii_for(const TreesByBody& trees, const Query& query) {
    std::vector<double> radii;
    if (query.question != Question::Motion) {
        return radii;
    }
    std::map<const ObbTree*, double> known;
    for (const ObbTree* tree : trees.all()) {
        const auto [radius, is_new] = known.try_emplace(tree);
        if (is_new) {
            radius->second = body_radius(tree->mesh().vertices());
        }
        radii.push_back(radius->second);
    }
    return radii;
}

Result<Motion> motion_of(const Scenario& scenario, const Query& query, const BodyRadii& radii) {
    CD_CHECK(query.motion);
    if (!scenario.to) {
        return bad_input("a scenario without a pose to move to");
    }
    return Motion::create(scenario.poses, *scenario.to, radii, query.motion->resolution);
}

double reach_of_motion(const Motion& motion, const Query& query) {
    return std::nextafter(motion.bound() + query.clearance.value_or(0),
                          std::numeric_limits<double>::infinity());
}

bool find_motion(ContactSearch& search,
                 const MovingTrees& trees,
                 const Motion& motion,
                 const Scenario& scenario,
                 const Query& query,
                 const RunOptions& options,
                 ScenarioRun& run) {
    TreeQuestions questions(search, trees, query.clearance);
    MotionAnswer answer = search_cells(motion,
                                       query.motion->until,
                                       query.clearance.value_or(0),
                                       questions.for_cells(options.stop));
    if (answer.is_stopped) {
        return false;
    }
    note_answer(std::move(answer), true, run);
    const PosePair poses = poses_of_answer(scenario, run.result);
    const bool is_event = run.result.motion->event().has_value();
    if (is_event && query.clearance && !questions.is_contact(poses)) {
        run.result.kind = ScenarioClass::Near;
    }
    run.statistics += questions.statistics();
    search.set_clearance(query.clearance.value_or(0));
    search.restart(poses);
    return !(options.stop && options.stop());
}

void note_free_motion(const Motion& motion, const Query& query, ScenarioRun& run) {
    const CellQuestions never{[](const PosePair&, double) { return false; },
                              [](const PosePair&) { return false; }};
    note_answer(
        search_cells(motion, query.motion->until, query.clearance.value_or(0), never), false, run);
}

} // namespace cd
