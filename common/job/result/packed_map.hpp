// Packs contact maps for sending and storing.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Packs a map. Writes for each body, A first, the number of touched triangles, the step from each
/// triangle to the next minus 1, and each triangle's number of scenarios minus 1. All numbers are
/// varints, compressed together.
[[nodiscard]] Bytes pack_map(const ContactMap& map);

struct ContactMapBounds {
    std::uint64_t triangles_a = 0; ///< Number of triangles of the mesh of A.
    std::uint64_t triangles_b = 0;
    std::uint64_t scenarios = 0; ///< Number of scenarios that the map sums up.
};

/// Unpacks the bytes of `pack_map`. The bytes are untrusted: triangles must ascend and exist in the
/// meshes, and no triangle may have more scenarios than `bounds` allows. Memory is bounded by the
/// largest valid map. Errors: BadFrame.
[[nodiscard]] Result<ContactMap> unpack_map(std::span<const std::byte> packed,
                                            const ContactMapBounds& bounds);

} // namespace cd
