// A common interface of engines that measure distances of triangles and of whole meshes.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

/// The distance of two meshes in the world (0, or less, in contact), and the two triangles that
/// have it; unspecified in contact.
struct MeshDistance {
    double distance;
    std::uint32_t a;
    std::uint32_t b;
};

/// Two meshes, and how far apart they are.
class DistanceMeshes {
  public:
    DistanceMeshes() = default;
    DistanceMeshes(const DistanceMeshes&) = delete;
    DistanceMeshes& operator=(const DistanceMeshes&) = delete;
    virtual ~DistanceMeshes() = default;

    /// Builds everything that is built once for two bodies.
    virtual void load(const std::shared_ptr<const Mesh>& a,
                      const std::shared_ptr<const Mesh>& b) = 0;
    [[nodiscard]] virtual MeshDistance distance(const PosePair& poses) = 0;
};

/// An engine with one setting.
struct DistanceEngine {
    std::string name;
    bool is_ours = false;
    std::function<std::unique_ptr<DistanceMeshes>()> make_meshes;
    /// Returns the distance of two triangles that share no point; empty if the engine's test of
    /// triangles is another engine's.
    std::function<double(const Corners& a, const Corners& b, const PosePair& poses)> of_pair;
};

/// Appends FCL with its trees of swept spheres, and of boxes and swept spheres, in doubles.
void add_fcl_distances(std::vector<DistanceEngine>& engines);

/// Returns our engine.
[[nodiscard]] DistanceEngine our_distances();

} // namespace cd::bench
