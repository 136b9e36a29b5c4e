// Lines and triangles that floating point misjudges, by kind.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/shots/line_hit.hpp"

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace cd::tests {

/// Triangles of A and a segment of B.
struct ShotCase {
    std::vector<Corners> triangles;
    Segment line;
    PosePair poses;
};

using ShotMaker = std::function<ShotCase(std::mt19937_64&)>;

/// Maps the name of each kind to its maker: each kind of `pair_makers`, with an edge of B for the
/// segment, and kinds that are hard for lines alone.
[[nodiscard]] std::map<std::string, ShotMaker> shot_makers();

/// Makes a closed fan: triangles around the corner `hub`, each of which shares an edge with the
/// next. The rim has integer coordinates from -reach to reach.
[[nodiscard]] std::vector<Corners> make_fan(std::mt19937_64& random, const Vec3& hub, int reach);

} // namespace cd::tests
