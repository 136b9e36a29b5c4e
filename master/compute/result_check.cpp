#include "master/compute/result_check.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/settle.hpp"
#include "master/base/mutation.hpp"
#include "master/compute/hit_check.hpp"
#include "master/compute/motion_check.hpp"
#include "master/compute/placed_scenario.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace cd {

namespace {

/// A scenario of a task, without its poses.
struct TaskScenario {
    std::uint64_t position = 0; ///< In the job's hand-out order.
    ScenarioBodies bodies;
    const Analysis* analysis = nullptr; ///< Null in a range.
};

/// Finds a task's scenarios by index.
class TaskIndex {
  public:
    explicit TaskIndex(const TaskContent& task) : task_(task) {
        for (const auto& analysis : task.analyses) {
            analyses_.emplace(analysis->scenario.index, analysis.get());
        }
    }

    [[nodiscard]] std::optional<TaskScenario> find(std::uint64_t index) const {
        if (task_.range) {
            const auto position = task_.range->position_of(index);
            return position ? std::optional(TaskScenario{
                                  *position, task_.range->bodies_at(*position), nullptr})
                            : std::nullopt;
        }
        const auto found = analyses_.find(index);
        if (found == analyses_.end()) {
            return std::nullopt;
        }
        const Analysis& analysis = *found->second;
        const Scenario& scenario = analysis.scenario;
        return TaskScenario{
            analysis.position, {scenario.body_a, scenario.body_b, scenario.step}, &analysis};
    }

    [[nodiscard]] Scenario with_poses(const TaskScenario& found) const {
        return found.analysis != nullptr ? found.analysis->scenario
                                         : task_.range->scenario_at(found.position);
    }

  private:
    const TaskContent& task_;
    std::unordered_map<std::uint64_t, const Analysis*> analyses_;
};

/// Whether the pairs of a result have triangles of its bodies.
bool are_triangles_of(const JobMaterial& material,
                      const ScenarioResult& result,
                      std::span<const ContactPair> pairs) {
    const std::uint64_t count_a = material.triangles_of(result.body_a);
    const std::uint64_t count_b = material.triangles_of(result.body_b);
    return std::all_of(pairs.begin(), pairs.end(), [&](const ContactPair& pair) {
        return pair.a < count_a && pair.b < count_b;
    });
}

/// Returns what is wrong with the level, bodies, question or clearance of a decoded result; null if
/// nothing.
const char* problem_of_question(const Query& query,
                                const ScenarioBodies& bodies,
                                const ScenarioResult& result) {
    if (result.level != query.level || result.body_a != bodies.a || result.body_b != bodies.b) {
        return "is not of the level or bodies asked for";
    }
    if (result.step != bodies.step) {
        return "is of another step than its scenario";
    }
    if (result.question != query.question) {
        return "answers another question than the one asked";
    }
    if (result.has_clearance != query.clearance.has_value()) {
        return result.has_clearance ? "has a clearance that was not asked for"
                                    : "lacks the clearance asked for";
    }
    const bool may_be_undecided = query.question == Question::Motion;
    return result.kind == ScenarioClass::Undecided && !may_be_undecided
               ? "is undecided, which its query does not allow"
               : nullptr;
}

/// Returns what is wrong with the pairs and numbers of a decoded result; null if nothing.
const char* problem_of_pairs(const JobMaterial& material, const ScenarioResult& result) {
    const std::uint64_t pairs_max =
        std::min(material.triangles_of(result.body_a) * material.triangles_of(result.body_b),
                 limits::result_pairs_max);
    if (result.pair_count > pairs_max || result.near_count > pairs_max - result.pair_count) {
        return "has more pairs than the bodies";
    }
    if (!are_triangles_of(material, result, result.pairs)) {
        return "has pairs of triangles that the bodies do not have";
    }
    const auto ignored = ignored_of(material.query.ignored, result.body_a, result.body_b);
    if (!ignored.empty() && std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
            return is_ignored(ignored, pair.a, pair.b);
        })) {
        return "has pairs of ignored triangles";
    }
    const bool is_far = std::ranges::any_of(result.near_distances, [&](double distance) {
        return distance > *material.query.clearance;
    });
    return is_far ? "has pairs farther apart than the clearance" : nullptr;
}

/// Returns what is wrong with the distance of a decoded result; null if nothing. With ignored
/// triangles separate bodies may have none, since all pairs may be ignored.
const char* problem_of_distance(const JobMaterial& material, const ScenarioResult& result) {
    const Query& query = material.query;
    const auto ignored = ignored_of(query.ignored, result.body_a, result.body_b);
    if (!result.nearest) {
        const bool is_apart =
            result.kind == ScenarioClass::Separate || result.kind == ScenarioClass::Inside;
        const bool needs_one =
            query.question == Question::Distance && is_apart && !query.up_to && ignored.empty();
        return needs_one ? "lacks the distance" : nullptr;
    }
    const NearestWitness& nearest = *result.nearest;
    const ContactPair pair{nearest.a, nearest.b, PairClass::Near};
    if (!are_triangles_of(material, result, {&pair, 1})) {
        return "has a distance of triangles that the bodies do not have";
    }
    if (is_ignored(ignored, nearest.a, nearest.b)) {
        return "has a distance of ignored triangles";
    }
    return query.up_to && nearest.distance > *query.up_to ? "has a distance above up_to" : nullptr;
}

/// Returns what is wrong with the answer of a decoded result to its scenario; null if nothing.
/// `scenario` is needed for motions, and may be null for other questions.
const char* problem_of_answer(const JobMaterial& material,
                              const Scenario* scenario,
                              const ScenarioResult& result) {
    const char* problem = problem_of_pairs(material, result);
    if (problem == nullptr && result.question == Question::Shots) {
        return problem_of_hits(material, result);
    }
    if (problem == nullptr && result.question == Question::Motion) {
        return problem_of_motion(material, *scenario, result);
    }
    return problem != nullptr ? problem : problem_of_distance(material, result);
}

/// Checks the answer of a decoded result to its scenario, and settles it. Returns what is wrong;
/// null if nothing.
const char* settle(const JobMaterial& material,
                   const Scenario& scenario,
                   ScenarioResult& result,
                   InsideStatistics& cost) {
    const char* const problem = problem_of_answer(material, &scenario, result);
    if (problem == nullptr) {
        cost += material.settler->settle(scenario, result);
    }
    return problem;
}

/// Does what `settle` does, for a result that needs no poses (`Settler::is_work`).
const char* set_flags(const JobMaterial& material, ScenarioResult& result) {
    material.settler->set_flags(result);
    return problem_of_answer(material, nullptr, result);
}

/// Checks and settles a record, and adds it to `taken`. Leaves the decoded result in `result`.
Status take_record(const JobMaterial& material,
                   const TaskIndex& scenarios,
                   std::span<const std::byte> bytes,
                   ScenarioResult& result,
                   TakenResults& taken) {
    CD_TRY(decode_result(bytes, result));
    const auto found = scenarios.find(result.index);
    if (!found) {
        return Error{ErrorCode::BadFrame,
                     "a result of scenario " + std::to_string(result.index) +
                         ", which is not in the task"};
    }
    const auto wrong = [&](const char* problem) {
        return Error{ErrorCode::BadFrame,
                     "the result of scenario " + std::to_string(result.index) + " " + problem};
    };
    if (const char* problem = problem_of_question(material.query, found->bodies, result)) {
        return wrong(problem);
    }
    // Reading the poses for every result would cost the master an eighth more at level count.
    const bool needs_poses =
        result.question == Question::Motion || material.settler->is_work(result);
    const char* const problem =
        needs_poses ? settle(material, scenarios.with_poses(*found), result, taken.cost.inside)
                    : set_flags(material, result);
    if (problem != nullptr) {
        return wrong(problem);
    }
    taken.results.add_settled(result, bytes);
    taken.positions_of_rows.push_back(mutated(Mutation::IndexTakenForPosition) ? result.index
                                                                               : found->position);
    if (found->analysis != nullptr) {
        taken.cost += found->analysis->cost;
    }
    return Done{};
}

/// Checks that the sums by part can be those of the results: parts and scenarios must exist, and
/// each of the `scenarios` with pairs must be counted for parts of both bodies.
Status check_parts(const BodyPartRuns& bodies,
                   std::span<const ScenarioResult> results,
                   std::uint64_t scenarios,
                   const PartContacts& contacts) {
    const Error wrong{ErrorCode::BadFrame, "sums by part that are not those of the results"};
    for (std::size_t side = 0; side < bodies.size(); ++side) {
        std::uint64_t sum = 0;
        for (const PartScenarios& part : contacts.parts[side]) {
            if (part.part >= bodies[side].count()) {
                return wrong;
            }
            sum += part.scenarios;
        }
        if (sum < scenarios) {
            return wrong;
        }
    }
    std::unordered_set<std::uint64_t> indices;
    for (const ScenarioResult& one : results) {
        indices.insert(one.index);
    }
    const auto is_right = [&](const PartPairContacts& pair) {
        return pair.a < bodies[0].count() && pair.b < bodies[1].count() &&
               indices.contains(pair.worst) && indices.contains(pair.first) &&
               indices.contains(pair.last);
    };
    return std::ranges::all_of(contacts.pairs, is_right) ? Status(Done{}) : wrong;
}

/// Checks that each of the `scenarios` with pairs marks triangles of both bodies.
Status check_triangles(std::uint64_t scenarios, const ContactMap& map) {
    for (const auto& body : map.bodies) {
        std::uint64_t sum = 0;
        for (const TriangleContacts& triangle : body) {
            sum += triangle.scenarios;
        }
        if (sum < scenarios) {
            return Error{ErrorCode::BadFrame, "a map that lacks scenarios"};
        }
    }
    return Done{};
}

/// Unpacks and checks the map of a message: it must be about its scenarios with pairs alone, and
/// have what is asked for.
Result<ContactMap> checked_map(const JobMaterial& material,
                               std::span<const ScenarioResult> results,
                               std::span<const std::byte> packed) {
    const bool are_shots = material.query.question == Question::Shots;
    std::uint64_t pairs = 0;
    std::uint64_t scenarios = 0;
    for (const ScenarioResult& one : results) {
        pairs += one.pair_count + one.near_count;
        scenarios += one.pair_count + one.near_count > 0 ? 1 : 0;
    }
    ContactMapBounds bounds{0, 0, scenarios};
    if (material.query.maps) {
        bounds.triangles_a = material.triangles_of(0); // A job with maps has two bodies.
        bounds.triangles_b = material.triangles_of(1);
        bounds.crossings = are_shots ? std::min(pairs, limits::map_crossings_max) : 0;
    }
    Result<ContactMap> map = unpack_map(packed, bounds);
    if (!map) {
        return map.error();
    }
    if (material.query.maps) {
        const Status marked = are_shots ? check_crossings(material.query, results, map.value())
                                        : check_triangles(scenarios, map.value());
        if (!marked) {
            return marked.error();
        }
    }
    if (material.parts == nullptr) {
        map.value().parts = {};
        return map;
    }
    const std::uint64_t counted =
        are_shots ? crossed_scenarios(material.query, results) : scenarios;
    const Status summed = check_parts(*material.parts, results, counted, map.value().parts);
    return summed ? std::move(map) : summed.error();
}

/// Returns the map of a message. Sums without triangles that cannot be those of the results are
/// made anew of the pairs that these list, so that a wrong result is a dispute, not a bad message.
Result<ContactMap> take_map(const JobMaterial& material,
                            std::span<const ScenarioResult> results,
                            std::span<const std::byte> packed) {
    if (!material.query.maps && material.parts == nullptr) {
        return packed.empty() ? Result<ContactMap>(ContactMap{})
                              : Error{ErrorCode::BadFrame, "a map that was not asked for"};
    }
    Result<ContactMap> map = checked_map(material, results, packed);
    if (map || material.query.maps) {
        return map;
    }
    ContactMapSum sum(material.parts);
    for (const ScenarioResult& one : results) {
        sum.add(one, {});
    }
    return sum.take();
}

} // namespace

void TakenResults::add(const ScenarioResult& result,
                       std::uint64_t position,
                       const JobStatistics& spent) {
    results.add(result);
    positions_of_rows.push_back(position);
    cost += spent;
}

Result<TakenResults> take_results(const TaskContent& task, const Results& results) {
    const JobMaterial& material = *task.material;
    Bytes unpacked;
    const auto records = CD_TRY(received_records(results.records, results.are_packed, unpacked));
    const TaskIndex scenarios(task);
    TakenResults taken;
    // The worker's count may be forged, so the task's size limits the allocation.
    const auto count = std::min<std::uint64_t>(results.count, task.count());
    taken.results.reserve(count, records.size());
    taken.positions_of_rows.reserve(count);
    const bool sums_pairs = material.query.maps || material.parts != nullptr;
    std::vector<ScenarioResult> decoded; // For the map, if there is one.
    ScenarioResult result;
    ByteReader reader(records);
    for (std::uint32_t i = 0; i < results.count; ++i) {
        const auto record = reader.get_bytes(reader.get<std::uint32_t>());
        if (reader.failed()) {
            break;
        }
        CD_TRY(take_record(material, scenarios, record, result, taken));
        if (sums_pairs) {
            decoded.push_back(std::move(result));
        }
    }
    if (!reader.complete()) {
        return Error{ErrorCode::BadFrame, "results that are not as many as announced"};
    }
    taken.map = CD_TRY(take_map(material, decoded, results.map));
    taken.positions = PositionSet::of(taken.positions_of_rows);
    return taken;
}

Result<TakenResults> take_late_results(JobId job,
                                       std::shared_ptr<const JobMaterial> material,
                                       OrderedPoses& poses,
                                       const Results& results) {
    Bytes unpacked;
    const auto records = CD_TRY(received_records(results.records, results.are_packed, unpacked));
    TaskContent content{job, std::move(material), {}, {}};
    std::unordered_set<std::uint64_t> seen; // Ensures that each scenario's pose is read only once.
    ByteReader reader(records);
    for (std::uint32_t i = 0; i < results.count && !reader.failed(); ++i) {
        const Result<ScenarioResult> result =
            decode_result(reader.get_bytes(reader.get<std::uint32_t>()));
        if (!result) {
            return result.error();
        }
        const std::uint64_t index = result.value().index;
        if (index >= poses.count()) {
            return Error{ErrorCode::BadFrame, "a result of a scenario that the job does not have"};
        }
        if (!seen.insert(index).second) {
            return Error{ErrorCode::BadFrame, "two results of one scenario in a message"};
        }
        const Result<PlacedScenario> placed = read_one(poses, index);
        if (!placed) {
            return placed.error();
        }
        Analysis known;
        known.scenario = placed.value().scenario;
        known.position = placed.value().position;
        content.analyses.push_back(std::make_shared<const Analysis>(std::move(known)));
    }
    return take_results(content, results);
}

} // namespace cd
