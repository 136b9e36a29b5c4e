// The packed form of a contact map, as sent and stored.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Writes for each body, A first, the number of its touched triangles, the steps from one triangle
/// to the next minus 1, and the triangles' numbers of scenarios minus 1; all are varints,
/// compressed together.
[[nodiscard]] Bytes pack_map(const ContactMap& map);

/// Bounds on the contents of a map.
struct ContactMapBounds {
    std::uint64_t triangles_a = 0; ///< Number of triangles of the mesh of A.
    std::uint64_t triangles_b = 0;
    std::uint64_t scenarios = 0; ///< Number of scenarios that the map sums up.
};

/// Unpacks `pack_map`. The bytes are untrusted: triangles must ascend and exist in the meshes,
/// none may have more scenarios than `bounds`, and memory stays within what such a map can need.
/// Errors: BadFrame.
[[nodiscard]] Result<ContactMap> unpack_map(std::span<const std::byte> packed,
                                            const ContactMapBounds& bounds);

} // namespace cd
