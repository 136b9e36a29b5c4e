// The nearest points of two bodies, as a record has them.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/geometry/types.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace cd {

/// The nearest pair of two bodies that share no point: of all pairs whose distance, correctly
/// rounded, is the least, the first one in sorted order.
struct NearestWitness {
    double distance = 0; ///< In the world, correctly rounded.
    std::uint32_t a = 0; ///< Triangles of the meshes.
    std::uint32_t b = 0;
    std::uint8_t feature = 0;    ///< Between which features the points are (nearest_points.hpp).
    Vec3 origin = Vec3::Zero();  ///< In the world.
    Vec3 point_a = Vec3::Zero(); ///< The nearest point of A, relative to the origin.
    Vec3 point_b = Vec3::Zero();

    friend bool operator==(const NearestWitness&, const NearestWitness&) = default;
};

/// Encodes a witness, or that there is none (result.hpp).
void put_witness(ByteWriter& out, const std::optional<NearestWitness>& nearest);
/// Decodes the bytes of `put_witness`. Errors: BadFrame.
[[nodiscard]] Status get_witness(ByteReader& in, std::optional<NearestWitness>& nearest);
/// Returns the number of bytes that `put_witness` writes.
[[nodiscard]] std::size_t bytes_of_witness(const std::optional<NearestWitness>& nearest);

} // namespace cd
