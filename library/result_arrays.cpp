#include "library/result_arrays.hpp"

#include "common/job/result/drawn_witness.hpp"

#include <limits>
#include <utility>

namespace cdcluster {

namespace {

constexpr std::size_t window_scenarios = 65536;
/// A window ends early above this size, so that many pairs a scenario do not fill the memory.
constexpr std::size_t window_pairs = std::size_t{1} << 21;

Point point_of(const cd::Vec3& point) {
    return {point[0], point[1], point[2]};
}

/// Makes a list of offsets that begins with 0.
void begin_offsets(std::vector<std::uint64_t>& offsets) {
    if (offsets.empty()) {
        offsets.push_back(0);
    }
}

std::vector<std::uint64_t> counts_of(const std::vector<cd::TriangleContacts>& map,
                                     std::size_t triangles) {
    std::vector<std::uint64_t> counts(triangles);
    for (const cd::TriangleContacts& each : map) {
        counts.at(each.triangle) = each.scenarios;
    }
    return counts;
}

} // namespace

ResultArrays::ResultArrays(EachWindow each_window,
                           std::vector<std::string> body_names,
                           std::uint64_t first)
    : each_window_(std::move(each_window)), body_names_(std::move(body_names)) {
    begin_window(first);
}

void ResultArrays::begin_window(std::uint64_t first) {
    window_ = {};
    window_.first = first;
    window_.body_names = body_names_;
}

void ResultArrays::pass_window() {
    const std::uint64_t next =
        window_.index.empty() ? window_.first + window_.size() : window_.index.back() + 1;
    each_window_(std::exchange(window_, {}));
    begin_window(next);
}

/// Notes the index of the next result, if an earlier scenario has no result.
void ResultArrays::number(std::uint64_t index) {
    const std::uint64_t expected = window_.first + window_.size();
    if (window_.index.empty() && index == expected) {
        return;
    }
    for (std::uint64_t i = window_.first + window_.index.size(); i < expected; ++i) {
        window_.index.push_back(i);
    }
    window_.index.push_back(index);
}

void ResultArrays::add_pairs(const cd::ScenarioResult& result) {
    begin_offsets(window_.offsets);
    for (const cd::ContactPair& pair : result.pairs) {
        window_.pairs.push_back({pair.a, pair.b});
        window_.pair_class.push_back(static_cast<PairClass>(pair.kind));
    }
    window_.offsets.push_back(window_.pairs.size());
    for (const cd::PairHit& hit : result.hits) {
        window_.hit_depth.push_back(hit.depth);
        window_.hit_flags.push_back(hit.flags);
        window_.hit_rank.push_back(hit.rank);
    }
}

void ResultArrays::add_points(const cd::ScenarioResult& result) {
    begin_offsets(window_.point_offsets);
    for (std::size_t pair = 0; pair < result.pairs.size(); ++pair) {
        cd::for_each_point(result, pair, [&](const cd::Vec3& point) {
            window_.points.push_back(point_of(point));
        });
        window_.point_offsets.push_back(window_.points.size());
    }
    if (result.has_clearance) {
        const std::vector<double> distances = cd::pair_distances(result);
        window_.pair_distance.insert(
            window_.pair_distance.end(), distances.begin(), distances.end());
    }
}

void ResultArrays::add_distance(const cd::ScenarioResult& result) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (!result.nearest) {
        window_.distance.push_back(nan);
        window_.witness.push_back({});
        window_.witness_points.push_back({Point{nan, nan, nan}, Point{nan, nan, nan}});
        return;
    }
    const auto [a, b] = cd::witness_points(*result.nearest);
    window_.distance.push_back(result.nearest->distance);
    window_.witness.push_back({result.nearest->a, result.nearest->b});
    window_.witness_points.push_back({point_of(a), point_of(b)});
}

void ResultArrays::add_motion(const cd::ScenarioResult& result) {
    const cd::MotionOutcome motion = result.motion.value_or(cd::MotionOutcome{});
    Motions& to = window_.motion;
    begin_offsets(to.run_offsets);
    to.end.push_back(static_cast<std::uint8_t>(motion.end));
    to.depth.push_back(static_cast<std::uint8_t>(motion.depth));
    to.t0.push_back(motion.t0);
    to.t1.push_back(motion.t1);
    for (const cd::CellRun& run : motion.runs) {
        to.runs.push_back({static_cast<std::uint32_t>(run.state),
                           run.first,
                           run.count,
                           run.event_first,
                           run.event_last});
    }
    to.run_offsets.push_back(to.runs.size());
}

void ResultArrays::add(const cd::ScenarioResult& result, std::span<const cd::ContactPair> found) {
    number(result.index);
    window_.kind.push_back(static_cast<ScenarioClass>(result.kind));
    window_.count.push_back(result.pair_count);
    window_.surfaces_only.push_back(result.surfaces_only ? 1 : 0);
    if (result.has_clearance) {
        window_.near_count.push_back(result.near_count);
    }
    if (result.kind == cd::ScenarioClass::Failed) {
        window_.failures.push_back({result.index, result.failure});
    }
    if (result.level >= cd::Level::Pairs) {
        add_pairs(result);
    }
    if (result.level == cd::Level::Contacts) {
        add_points(result);
    }
    if (result.question == cd::Question::Distance) {
        add_distance(result);
    }
    if (result.question == cd::Question::Motion) {
        add_motion(result);
    }
    if (result.step) {
        const bool knows_steps = scene_ && scene_->steps != nullptr;
        window_.step.push_back(knows_steps ? scene_->steps->step_of(result.index) : *result.step);
        if (const auto bundle = knows_steps ? scene_->bundle_of(result) : std::nullopt) {
            window_.bundle.push_back(*bundle);
        }
        window_.body_a.push_back(result.body_a);
        window_.body_b.push_back(result.body_b);
    }
    if (map_) {
        map_->add(result, found);
    }
    const bool is_full = window_.size() >= window_scenarios || window_.pairs.size() >= window_pairs;
    if (each_window_ && is_full) {
        pass_window();
    }
}

std::optional<cd::ContactMap> ResultArrays::take_map() {
    return map_ ? std::optional(map_->take()) : std::nullopt;
}

Results ResultArrays::finish(const std::optional<cd::Sha256>& digest,
                             std::array<std::size_t, 2> triangles,
                             const std::optional<cd::ContactMap>& map) {
    if (each_window_ && window_.size() > 0) {
        pass_window();
    }
    Results whole = std::move(window_);
    whole.digest = digest ? cd::to_hex(*digest) : "";
    if (map) {
        whole.map_a = counts_of(map->bodies[0], triangles[0]);
        whole.map_b = counts_of(map->bodies[1], triangles[1]);
    }
    return whole;
}

std::vector<std::string> names_of(const cd::ExportContext& context) {
    std::vector<std::string> names;
    for (const cd::ExportBody& body : context.bodies) {
        names.push_back(body.name);
    }
    return names;
}

std::array<std::size_t, 2>
triangles_of(const std::vector<std::shared_ptr<const cd::Mesh>>& meshes) {
    return {meshes.at(0)->triangles().size(), meshes.at(1)->triangles().size()};
}

} // namespace cdcluster
