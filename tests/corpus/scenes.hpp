// The hard scenes of whole meshes, by name: bodies that rest, fit or pass along each other, and
// coordinates at the limits of doubles. Their truth comes from the oracle, never from their
// construction.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cd::tests {

struct Body {
    std::shared_ptr<const Mesh> mesh;
    bool closed = true; ///< Known from its construction.
};

struct Scene {
    std::string name;
    std::string category;
    Body a;
    Body b;
    PosePair poses;
};

/// Returns all scenes in a fixed order, bit-identical with every compiler and library; each has at
/// most some thousand triangles.
[[nodiscard]] const std::vector<Scene>& corpus_scenes();

/// Returns the scene of that name, which must exist.
[[nodiscard]] const Scene& corpus_scene(std::string_view name);

} // namespace cd::tests
