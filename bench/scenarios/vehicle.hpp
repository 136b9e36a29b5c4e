// Vehicles of any number of triangles, generated: what scaling is measured on.
#pragma once

#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <memory>

namespace cd::bench {

enum class VehicleKind { Car, Truck };

/// A car of 4.4 m or a truck of 8.9 m, in metres, x forward, z up, standing on z = 0. About
/// `triangles` triangles: body panels in two sheets, wheels with lugs and nuts, frame, pipes,
/// seats, slats, trims, rivets; so near-regular grids beside long thin triangles and tiny ones, and
/// parts that intersect where they meet, as in real models. The shapes do not depend on the number,
/// but for parts too small for it, which are left out. Floats; the same bits on every host.
[[nodiscard]] std::shared_ptr<const Mesh> make_vehicle(VehicleKind kind, std::uint64_t triangles);

} // namespace cd::bench
