// Exact reference for two posed meshes, by brute force in integers.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"
#include "tests/support/exact_world.hpp"

#include <vector>

namespace cd::tests {

/// Handles meshes of up to some thousand triangles. Shares no code with the engine.
class SceneOracle {
  public:
    SceneOracle(const Mesh& a, const Mesh& b, const PosePair& poses);

    /// Returns every pair that shares a point, with its class, sorted.
    [[nodiscard]] const std::vector<ContactPair>& contact_pairs() const { return pairs_; }

    /// Classifies by the definition. If surfaces meet, the class is Cross or Touch, as interiors do
    /// or do not; otherwise it is Inside if one body lies within the other, or else Separate.
    /// `closed`: both surfaces are closed and do not cross themselves. Others have no interior.
    [[nodiscard]] ScenarioClass scenario_class(bool closed) const;

  private:
    [[nodiscard]] bool interiors_overlap() const;

    std::vector<ExactTriangle> a_;
    std::vector<ExactTriangle> b_;
    /// For body A, one triangle of each set connected by vertex numbers.
    std::vector<std::uint32_t> pieces_a_;
    std::vector<std::uint32_t> pieces_b_;
    std::vector<ContactPair> pairs_;
};

} // namespace cd::tests
