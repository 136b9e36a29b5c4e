// Arrays of the page in NumPy's format (NPY 1.0, little-endian, C order).
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Encodes classes as u1 (n,).
[[nodiscard]] Bytes classes_npy(std::span<const std::uint8_t> classes);
/// Encodes counts as u4 (n,).
[[nodiscard]] Bytes counts_npy(std::span<const std::uint32_t> counts);
/// Encodes distances as f8 (n,).
[[nodiscard]] Bytes distances_npy(std::span<const double> distances);
/// Encodes poses as f8 (n,12), or (n,2,12) if there are two a scenario.
[[nodiscard]] Bytes poses_npy(const PoseRows& poses);
/// Encodes motions as f8 (n,4,7): `key_numbers` of A and of B at the begin, then at the end.
[[nodiscard]] Bytes keys_npy(std::span<const MotionKeys> motions);
/// Encodes steps and bodies of scenarios as u4 (n,3): step, number of body A, of body B.
[[nodiscard]] Bytes bodies_npy(std::span<const ScenePlace> places);
/// Encodes steps as f8 (n,2): first scenario, time.
[[nodiscard]] Bytes steps_npy(std::span<const StepRow> steps);
/// Encodes a body's contact map as u8 (k,2): triangle, scenarios.
[[nodiscard]] Bytes map_npy(std::span<const TriangleContacts> map);
/// Encodes runs of triangles of one part as u4 (k,2): first triangle, number of the part.
[[nodiscard]] Bytes parts_npy(const PartRuns& parts);
/// Encodes which parts of a body are closed as u1 (k,), by their numbers.
[[nodiscard]] Bytes closed_npy(const std::vector<bool>& are_closed);

/// An array of at most `limits::page_rows_max` rows.
struct BoundedArray {
    Bytes npy;
    bool is_cut = false; ///< Rows are missing.
};
/// Encodes the listed pairs as u4 (m,3): triangle of A, triangle of B, class.
[[nodiscard]] BoundedArray pairs_npy(const ScenarioResult& result);
/// Encodes shared points, and the nearest points of near pairs, as f8 (k,4): position of the pair
/// in the list; x, y, z in the world.
[[nodiscard]] BoundedArray points_npy(const ScenarioResult& result);
/// Encodes the hit of each listed pair as f8 (m,3): depth, flags (`hit_flag`), rank. There are none
/// unless B is a bundle of lines.
[[nodiscard]] BoundedArray hits_npy(const ScenarioResult& result);

} // namespace cd
