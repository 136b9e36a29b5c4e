// Generates vehicles of any number of triangles, for the demo and for scaling measurements.
#pragma once

#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <memory>

namespace cd {

enum class VehicleKind { Car, Truck };

/// Returns a car of 4.4 m or a truck of 8.9 m, in metres, x forward, z up, wheels on z = 0, with
/// about `triangles` triangles: body panels in two sheets, wheels with lugs and nuts, frame, pipes,
/// seats, slats, trims, rivets, in parts with names. As in real models, near-regular grids lie
/// beside long thin and tiny triangles, and adjoining parts intersect. The shapes do not depend on
/// the number, but sheets too small for it are omitted. Float coordinates; the same bits on every
/// host.
[[nodiscard]] std::shared_ptr<const Mesh> make_vehicle(VehicleKind kind, std::uint64_t triangles);

} // namespace cd
