#include "web/server/page_arrays.hpp"

#include "common/core/files/npy_header.hpp"
#include "common/core/limits/web.hpp"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace cd {

namespace {

template <class T>
Bytes npy(NpyType type, std::initializer_list<std::uint64_t> shape, std::span<const T> values) {
    Bytes bytes = make_npy_header(type, std::span(shape));
    const auto content = std::as_bytes(values);
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
}

} // namespace

Bytes classes_npy(std::span<const std::uint8_t> classes) {
    return npy(NpyType::U1, {classes.size()}, classes);
}

Bytes counts_npy(std::span<const std::uint32_t> counts) {
    return npy(NpyType::U4, {counts.size()}, counts);
}

Bytes distances_npy(std::span<const double> distances) {
    return npy(NpyType::F8, {distances.size()}, distances);
}

Bytes poses_npy(const PoseRows& poses) {
    const std::span<const double> numbers(poses.numbers);
    const std::uint64_t scenarios = numbers.size() / (12 * poses.poses_each);
    return poses.poses_each == 1 ? npy(NpyType::F8, {scenarios, 12}, numbers)
                                 : npy(NpyType::F8, {scenarios, poses.poses_each, 12}, numbers);
}

Bytes keys_npy(std::span<const MotionKeys> motions) {
    std::vector<double> numbers;
    numbers.reserve(28 * motions.size());
    for (const MotionKeys& each : motions) {
        for (const Pose* const pose : {&each.from.a, &each.from.b, &each.to.a, &each.to.b}) {
            const auto key = key_numbers(*pose);
            numbers.insert(numbers.end(), key.begin(), key.end());
        }
    }
    return npy(NpyType::F8, {motions.size(), 4, 7}, std::span<const double>(numbers));
}

Bytes bodies_npy(std::span<const ScenePlace> places) {
    std::vector<std::uint32_t> rows;
    rows.reserve(3 * places.size());
    for (const ScenePlace& each : places) {
        // A scene has at most some ten million steps (`unpack_steps`).
        rows.insert(rows.end(), {static_cast<std::uint32_t>(each.step), each.body_a, each.body_b});
    }
    return npy(NpyType::U4, {places.size(), 3}, std::span<const std::uint32_t>(rows));
}

Bytes steps_npy(std::span<const StepRow> steps) {
    std::vector<double> rows;
    rows.reserve(2 * steps.size());
    for (const StepRow& each : steps) {
        rows.insert(rows.end(), {static_cast<double>(each.first), each.time});
    }
    return npy(NpyType::F8, {steps.size(), 2}, std::span<const double>(rows));
}

Bytes map_npy(std::span<const TriangleContacts> map) {
    std::vector<std::uint64_t> rows;
    rows.reserve(2 * map.size());
    for (const TriangleContacts& each : map) {
        rows.insert(rows.end(), {each.triangle, each.scenarios});
    }
    return npy(NpyType::U8, {map.size(), 2}, std::span<const std::uint64_t>(rows));
}

Bytes parts_npy(const PartRuns& parts) {
    std::vector<std::uint32_t> rows;
    rows.reserve(2 * parts.runs().size());
    for (const PartRun& run : parts.runs()) {
        rows.insert(rows.end(), {run.begin, run.part});
    }
    return npy(NpyType::U4, {parts.runs().size(), 2}, std::span<const std::uint32_t>(rows));
}

Bytes closed_npy(const std::vector<bool>& are_closed) {
    const std::vector<std::uint8_t> bytes(are_closed.begin(), are_closed.end());
    return npy(NpyType::U1, {bytes.size()}, std::span<const std::uint8_t>(bytes));
}

BoundedArray pairs_npy(const ScenarioResult& result) {
    const std::uint64_t count = std::min<std::uint64_t>(result.pairs.size(), limits::page_rows_max);
    std::vector<std::uint32_t> rows;
    rows.reserve(3 * count);
    for (const ContactPair& pair : std::span(result.pairs).first(count)) {
        rows.insert(rows.end(), {pair.a, pair.b, static_cast<std::uint32_t>(pair.kind)});
    }
    return {npy(NpyType::U4, {count, 3}, std::span<const std::uint32_t>(rows)),
            count < result.pair_count + result.near_count};
}

BoundedArray points_npy(const ScenarioResult& result) {
    std::vector<double> rows;
    for (std::size_t pair = 0; pair + 1 < result.point_offsets.size(); ++pair) {
        for (std::uint32_t i = result.point_offsets[pair];
             i < result.point_offsets[pair + 1] && rows.size() < 4 * limits::page_rows_max;
             ++i) {
            const Vec3 point = result.point_origins[pair] + result.points[i];
            rows.insert(rows.end(), {static_cast<double>(pair), point.x(), point.y(), point.z()});
        }
    }
    const std::uint64_t count = rows.size() / 4;
    return {npy(NpyType::F8, {count, 4}, std::span<const double>(rows)),
            count < result.points.size() || result.is_cut()};
}

BoundedArray hits_npy(const ScenarioResult& result) {
    const std::uint64_t count = std::min<std::uint64_t>(result.hits.size(), limits::page_rows_max);
    std::vector<double> rows;
    rows.reserve(3 * count);
    for (const PairHit& hit : std::span(result.hits).first(count)) {
        rows.insert(rows.end(),
                    {hit.depth, static_cast<double>(hit.flags), static_cast<double>(hit.rank)});
    }
    return {npy(NpyType::F8, {count, 3}, std::span<const double>(rows)),
            count < result.hits.size() || result.is_cut()};
}

} // namespace cd
