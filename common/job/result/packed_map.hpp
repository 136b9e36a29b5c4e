// Packs contact maps for sending and storing.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Packs a map. Writes for each body, A first, the number of touched triangles, the step from each
/// triangle to the next minus 1, and each triangle's number of scenarios minus 1; then for each
/// body its parts likewise. Then come the number of pairs of parts, and for each: the step of its
/// part of A, that of its part of B (minus 1 if the part of A stays), scenarios - 1, its pairs of
/// triangles (in contact or near) - scenarios, those of the worst scenario - 1, first, worst -
/// first, last - first, flags (bit 0: it has a proper pair; bit 1: it has near pairs), and with bit
/// 1 the number of near pairs - 1 and that of the worst scenario; then the number of pairs left
/// out. All numbers are varints, compressed together.
[[nodiscard]] Bytes pack_map(const ContactMap& map);

struct ContactMapBounds {
    std::uint64_t triangles_a = 0; ///< Number of triangles of the mesh of A.
    std::uint64_t triangles_b = 0;
    std::uint64_t scenarios = 0; ///< Number of scenarios that the map sums up.
    /// With Question::Shots: the most crossings of a triangle, if more than `scenarios`; at most
    /// `limits::map_crossings_max`.
    std::uint64_t crossings = 0;
};

/// The bounds of any map that sums up so many scenarios, or the crossings in them.
[[nodiscard]] constexpr ContactMapBounds any_map(std::uint64_t scenarios = limits::scenarios_max) {
    return {limits::mesh_triangles_max,
            limits::mesh_triangles_max,
            scenarios,
            limits::map_crossings_max};
}

/// Unpacks the bytes of `pack_map`. The bytes are untrusted: triangles must ascend and exist in the
/// meshes, and no triangle and no part may have more scenarios or crossings than `bounds` allows.
/// The sums by part do not contradict themselves, but their parts and scenarios need not exist.
/// Memory is bounded by the largest valid map. Errors: BadFrame.
[[nodiscard]] Result<ContactMap> unpack_map(std::span<const std::byte> packed,
                                            const ContactMapBounds& bounds);

} // namespace cd
