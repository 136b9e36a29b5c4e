#include "tests/support/lattice_solids.hpp"

#include "tests/support/shapes.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace cd::tests {

namespace {

using Way = std::array<std::int64_t, 3>;

int below(std::mt19937_64& random, int bound) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(bound));
}

Vec3 to_vector(const LatticePoint& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

LatticePoint moved(LatticePoint point, std::size_t axis, int by) {
    point[axis] += by;
    return point;
}

/// Adds the face of a cube at the low or high end of an axis, wound outward, with either diagonal.
void add_face(std::vector<Vec3>& vertices,
              std::vector<Triangle>& triangles,
              const LatticePoint& low,
              std::size_t axis,
              bool is_high) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const LatticePoint corner = moved(low, axis, is_high ? 1 : 0);
    std::array<LatticePoint, 4> around{
        corner, moved(corner, u, 1), moved(moved(corner, u, 1), v, 1), moved(corner, v, 1)};
    if (!is_high) {
        std::reverse(around.begin(), around.end());
    }
    if ((corner[0] + corner[1] + corner[2]) % 2 != 0) {
        std::rotate(around.begin(), around.begin() + 1, around.end());
    }
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const LatticePoint& point : around) {
        vertices.push_back(to_vector(point));
    }
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
}

Way minus(const LatticePoint& l, const LatticePoint& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

Way cross(const Way& l, const Way& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

std::int64_t dot(const Way& l, const Way& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

std::vector<LatticePoint> moved(const std::vector<LatticePoint>& points,
                                const LatticeMotion& motion) {
    std::vector<LatticePoint> result;
    for (const LatticePoint& point : points) {
        result.push_back(motion.apply(point));
    }
    return result;
}

bool separates(const Way& axis,
               const std::vector<LatticePoint>& a,
               const std::vector<LatticePoint>& b) {
    if (axis == Way{0, 0, 0}) {
        return false;
    }
    std::int64_t most = dot(axis, minus(a[0], {}));
    std::int64_t least = dot(axis, minus(b[0], {}));
    for (const LatticePoint& point : a) {
        most = std::max(most, dot(axis, minus(point, {})));
    }
    for (const LatticePoint& point : b) {
        least = std::min(least, dot(axis, minus(point, {})));
    }
    return most <= least;
}

/// Returns the edge direction of every pair of corners.
std::vector<Way> edges_of(const std::vector<LatticePoint>& corners) {
    std::vector<Way> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            edges.push_back(minus(corners[j], corners[i]));
        }
    }
    return edges;
}

std::int64_t volume_of(const std::vector<LatticePoint>& c) {
    return dot(cross(minus(c[1], c[0]), minus(c[2], c[0])), minus(c[3], c[0]));
}

Tetrahedron make_tetrahedron(std::vector<LatticePoint> corners) {
    std::vector<Vec3> vertices;
    for (const LatticePoint& corner : corners) {
        vertices.push_back(to_vector(corner));
    }
    return {std::move(corners),
            make_mesh(std::move(vertices), {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}})};
}

} // namespace

LatticePoint LatticeMotion::apply(const LatticePoint& point) const {
    LatticePoint result = offset;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] += sign[i] * point[static_cast<std::size_t>(axis[i])];
    }
    return result;
}

Pose LatticeMotion::pose() const {
    Mat3 matrix = Mat3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        matrix(static_cast<Eigen::Index>(i), axis[i]) = sign[i];
    }
    return Pose::from_matrix(matrix, to_vector(offset));
}

LatticeMotion random_motion(std::mt19937_64& random, int reach, bool mirrors) {
    LatticeMotion motion;
    const int turn = below(random, 6);
    std::rotate(motion.axis.begin(), motion.axis.begin() + turn % 3, motion.axis.end());
    const bool swaps = turn >= 3;
    if (swaps) {
        std::swap(motion.axis[0], motion.axis[1]);
    }
    int handed = swaps ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
        motion.sign[i] = below(random, 2) == 0 ? 1 : -1;
        handed *= motion.sign[i];
        motion.offset[i] = below(random, 2 * reach + 1) - reach;
    }
    if (handed < 0 && !mirrors) {
        motion.sign[2] = -motion.sign[2];
    }
    return motion;
}

LatticeTurn random_turn(std::mt19937_64& random, int reach) {
    // Quarter turns reach all 24 rotations.
    constexpr std::array<Quaternion, 4> turns{
        Quaternion{1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}, {1, 0, 0, 0}};
    LatticeTurn turn;
    for (int i = 0; i < 4; ++i) {
        turn.quaternion = turns[random() % turns.size()] * turn.quaternion;
    }
    const Mat3 matrix = Pose::from_quaternion(turn.quaternion, Vec3::Zero()).rotation();
    for (int row = 0; row < 3; ++row) {
        const auto i = static_cast<std::size_t>(row);
        matrix.row(row).cwiseAbs().maxCoeff(&turn.motion.axis[i]);
        turn.motion.sign[i] = matrix(row, turn.motion.axis[i]) > 0 ? 1 : -1;
        turn.motion.offset[i] = below(random, 2 * reach + 1) - reach;
    }
    return turn;
}

CubeSolid cubes_at(std::vector<LatticePoint> cubes, int size) {
    const std::set<LatticePoint> filled(cubes.begin(), cubes.end());
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const LatticePoint& cube : filled) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const bool is_high : {false, true}) {
                if (!filled.contains(moved(cube, axis, is_high ? 1 : -1))) {
                    add_face(vertices, triangles, cube, axis, is_high);
                }
            }
        }
    }
    for (Vec3& vertex : vertices) {
        vertex *= size;
    }
    for (LatticePoint& cube : cubes) {
        for (int& coordinate : cube) {
            coordinate *= size;
        }
    }
    return {std::move(cubes), size, make_mesh(std::move(vertices), std::move(triangles))};
}

CubeSolid random_cubes(std::mt19937_64& random, int count, int size) {
    std::vector<LatticePoint> cubes{{0, 0, 0}};
    while (static_cast<int>(cubes.size()) < count) {
        const LatticePoint& from = cubes[random() % cubes.size()];
        const LatticePoint next = moved(from, random() % 3, below(random, 2) == 0 ? 1 : -1);
        if (std::find(cubes.begin(), cubes.end(), next) == cubes.end()) {
            cubes.push_back(next);
        }
    }
    CubeSolid solid = cubes_at(std::move(cubes), size);
    if (below(random, 2) == 0) {
        solid.mesh = reversed(solid.mesh);
    }
    return solid;
}

bool interiors_meet(const CubeSolid& a,
                    const LatticeMotion& motion_a,
                    const CubeSolid& b,
                    const LatticeMotion& motion_b) {
    const auto range = [](const LatticePoint& cube, int size, const LatticeMotion& motion) {
        const LatticePoint one = motion.apply(cube);
        const LatticePoint other = motion.apply({cube[0] + size, cube[1] + size, cube[2] + size});
        std::array<std::pair<int, int>, 3> ranges;
        for (std::size_t i = 0; i < 3; ++i) {
            ranges[i] = std::minmax(one[i], other[i]);
        }
        return ranges;
    };
    for (const LatticePoint& of_a : a.cubes) {
        const auto ranges_a = range(of_a, a.size, motion_a);
        for (const LatticePoint& of_b : b.cubes) {
            const auto ranges_b = range(of_b, b.size, motion_b);
            bool meet = true;
            for (std::size_t i = 0; i < 3; ++i) {
                meet = meet && ranges_a[i].first < ranges_b[i].second &&
                       ranges_b[i].first < ranges_a[i].second;
            }
            if (meet) {
                return true;
            }
        }
    }
    return false;
}

Tetrahedron random_tetrahedron(std::mt19937_64& random, int reach) {
    std::vector<LatticePoint> corners(4);
    do {
        for (LatticePoint& corner : corners) {
            corner = {below(random, reach + 1), below(random, reach + 1), below(random, reach + 1)};
        }
    } while (volume_of(corners) == 0);
    return make_tetrahedron(std::move(corners));
}

Tetrahedron random_relative(std::mt19937_64& random, const Tetrahedron& of) {
    std::vector<LatticePoint> corners(4);
    do {
        for (LatticePoint& corner : corners) {
            const LatticePoint& one = of.corners[random() % 4];
            const LatticePoint& other = of.corners[random() % 4];
            for (std::size_t i = 0; i < 3; ++i) {
                corner[i] = (one[i] + other[i]) / 2;
            }
        }
        corners[0][random() % 3] += below(random, 3) - 1;
        corners[1][random() % 3] += below(random, 3) - 1;
    } while (volume_of(corners) == 0);
    return make_tetrahedron(std::move(corners));
}

bool interiors_meet(const Tetrahedron& a,
                    const LatticeMotion& motion_a,
                    const Tetrahedron& b,
                    const LatticeMotion& motion_b) {
    const std::vector<LatticePoint> corners_a = moved(a.corners, motion_a);
    const std::vector<LatticePoint> corners_b = moved(b.corners, motion_b);
    std::vector<Way> edges_a = edges_of(corners_a);
    std::vector<Way> edges_b = edges_of(corners_b);
    std::vector<Way> edges = edges_a;
    edges.insert(edges.end(), edges_b.begin(), edges_b.end());
    for (const Way& l : edges) {
        for (const Way& r : edges) {
            // The loops produce both signs and both orders.
            if (separates(cross(l, r), corners_a, corners_b)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace cd::tests
