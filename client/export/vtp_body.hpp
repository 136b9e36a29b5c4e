// A body's mesh as a surface for VTK.
#pragma once

#include "client/export/vtp_file.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/types.hpp"

#include <memory>
#include <span>

namespace cd {

/// Returns a mesh as a surface. `points` are its vertices, moved or not, and are written as `type`;
/// both must outlive the surface. The cell array `part` has for each triangle the number of its
/// part in the texts `part_names`, or -1; the cell array `triangle` has the triangle's number.
[[nodiscard]] VtpData vtp_body(const std::shared_ptr<const Mesh>& mesh,
                               std::span<const Vec3> points,
                               NpyType type = NpyType::F8);

} // namespace cd
