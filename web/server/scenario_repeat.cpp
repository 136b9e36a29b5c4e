#include "web/server/scenario_repeat.hpp"

#include "common/core/limits/web.hpp"
#include "common/core/words.hpp"
#include "common/job/answer_poses.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "common/job/run_scenario.hpp"

#include <memory>
#include <string>
#include <utility>

namespace cd {

namespace {

/// The query whose results are drawn.
Query drawing_query(const Query& query) {
    Query drawn{Level::Contacts, limits::page_rows_max, query.ignored, false, query.clearance};
    if (query.question == Question::Shots) {
        drawn.level = Level::Pairs;
        drawn.question = query.question;
        drawn.first_hits = query.first_hits;
    }
    return drawn;
}

/// True if a run with the job's query has all that is drawn.
bool is_drawable(const Query& query, const ScenarioResult& result) {
    switch (query.question) {
    case Question::Distance:
        return !is_contact(result.kind) || result.nearest;
    case Question::Shots:
        return query.level == Level::Pairs && query.limit_pairs == 0;
    case Question::Motion:
        return false;
    case Question::Contacts:
        break;
    }
    return query.level == Level::Contacts && query.limit_pairs == 0;
}

/// Says what is proven of a motion: " in [3, 4] of 2^9 with 2 runs".
std::string motion_text(const MotionOutcome& motion) {
    return " in [" + std::to_string(motion.t0) + ", " + std::to_string(motion.t1) + "] of 2^" +
           std::to_string(motion.depth) + " with " + counted(motion.runs.size(), "run");
}

std::string answer_text(const ScenarioResult& result) {
    const bool is_shots = result.question == Question::Shots;
    return std::string(to_text(result.kind)) + " with " +
           counted(result.pair_count, is_shots ? "hit" : "pair") +
           (result.has_clearance ? " and " + counted(result.near_count, "near pair") : "") +
           (result.motion ? motion_text(*result.motion) : "") +
           (result.nearest ? " at distance " + exact_text(result.nearest->distance) : "");
}

ScenarioRun
run(const TreesByBody& trees, const Query& query, const Scenario& scenario, const StopCheck& stop) {
    return ScenarioRunner(trees, query, PairStage::Float, stop).run(scenario);
}

void compare(const ScenarioRun& again, const KeptRecord& record, ScenarioView& view) {
    if (again.is_stopped) {
        view.verify_note = "running it again takes too long here; cdctl verify does it";
        return;
    }
    view.verified = encode_result(again.result) == record.bytes;
    if (!*view.verified) {
        view.verify_note = "the record says " + answer_text(record.result) +
                           ", a second run here " + answer_text(again.result);
    }
}

std::string reason_not_to_compare(const std::optional<KeptRecord>& record) {
    if (!record) {
        return "it has no result yet";
    }
    if (record->result.kind == ScenarioClass::Undecided && !record->result.motion) {
        return "an earlier version left it undecided, which no run does again";
    }
    return record->result.kind == ScenarioClass::Failed ? "it failed in the run" : "";
}

std::string reason_not_to_draw(const ScenarioRun& run) {
    if (run.is_stopped) {
        return "finding all its contacts takes too long here; cdctl extract has the scenario";
    }
    return run.result.kind == ScenarioClass::Failed ? "it fails here: " + run.result.failure : "";
}

} // namespace

ScenarioView repeat_scenario(const TreesByBody& trees,
                             const Query& query,
                             const Scenario& scenario,
                             const std::optional<KeptRecord>& record,
                             const StopCheck& stop) {
    ScenarioView view;
    view.poses = scenario.poses;
    if (scenario.step) {
        view.scene = ScenePlace{*scenario.step, scenario.body_a, scenario.body_b};
    }
    if (scenario.to) {
        view.keys = MotionKeys{scenario.poses, *scenario.to};
    }
    view.verify_note = reason_not_to_compare(record);
    if (record) {
        view.result = record->result;
        view.listed = record->result.pairs.size();
        view.result->pairs = {};
        view.result->point_origins = {};
        view.result->point_offsets = {};
        view.result->points = {};
        view.result->near_distances = {};
        view.result->hits = {};
    }
    std::optional<ScenarioRun> again;
    if (view.verify_note.empty()) {
        again = run(trees, query, scenario, stop);
        compare(*again, *record, view);
    }
    if (!again && (query.question == Question::Distance || query.motion)) {
        again = run(trees, query, scenario, stop);
    }
    if (!again || (!again->is_stopped && !is_drawable(query, again->result))) {
        const Scenario drawn = again ? at_answer(scenario, again->result) : scenario;
        view.poses = drawn.poses;
        again = run(trees, drawing_query(query), drawn, stop);
    }
    view.draw_note = reason_not_to_draw(*again);
    if (view.draw_note.empty()) {
        list_witness(again->result);
        view.drawn = std::make_shared<const ScenarioResult>(std::move(again->result));
    }
    return view;
}

} // namespace cd
