// A map of contacts as it travels and as it is kept.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Of each body, A first, the number of its triangles, the steps from one to the
/// next less 1, and their scenarios less 1; all of it varints, compressed together.
[[nodiscard]] Bytes pack_map(const ContactMap& map);

/// What a map can hold.
struct ContactMapBounds {
    std::uint64_t triangles_a = 0; ///< Of the meshes.
    std::uint64_t triangles_b = 0;
    std::uint64_t scenarios = 0; ///< That the map is the sum of.
};

/// The inverse. The bytes may be hostile: triangles ascend and are below the meshes' numbers, none
/// has more than `scenarios`, and nothing is allocated beyond what that allows. Errors: BadFrame.
[[nodiscard]] Result<ContactMap> unpack_map(std::span<const std::byte> packed,
                                            const ContactMapBounds& bounds);

} // namespace cd
