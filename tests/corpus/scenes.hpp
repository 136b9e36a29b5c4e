// The hard scenes of whole meshes, by name (NUMERICS, section 4). The truth about them is the
// oracle's, never taken from how they were made.
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
    bool closed = true; ///< Known from how it was made.
};

struct Scene {
    std::string name;
    std::string category;
    Body a;
    Body b;
    PosePair poses;
};

/// All scenes, in a fixed order; none has more than some thousand triangles. The same bits with
/// every compiler and library.
[[nodiscard]] const std::vector<Scene>& corpus_scenes();

/// One of them, which must exist.
[[nodiscard]] const Scene& corpus_scene(std::string_view name);

} // namespace cd::tests
