#include "tests/corpus/pair_makers.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace cd::tests {

namespace {

/// A plane with a lattice: integer multiples of two integer vectors, exact in doubles.
struct LatticePlane {
    Vec3 origin;
    Vec3 u;
    Vec3 v;

    [[nodiscard]] Vec3 at(int i, int j) const { return origin + i * u + j * v; }
};

LatticePlane random_plane(std::mt19937_64& random) {
    LatticePlane plane;
    do {
        plane.origin = lattice_point(random, 8);
        plane.u = lattice_point(random, 8);
        plane.v = lattice_point(random, 8);
    } while (plane.u.cross(plane.v) == Vec3::Zero());
    return plane;
}

/// Returns an integer from low to high, both included.
int whole(std::mt19937_64& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

bool coin(std::mt19937_64& random) {
    return random() % 2 == 0;
}

/// Returns 10^-k for k in [least, most].
double decade(std::mt19937_64& random, int least, int most) {
    constexpr std::array<double, 19> decades{1,
                                             1e-1,
                                             1e-2,
                                             1e-3,
                                             1e-4,
                                             1e-5,
                                             1e-6,
                                             1e-7,
                                             1e-8,
                                             1e-9,
                                             1e-10,
                                             1e-11,
                                             1e-12,
                                             1e-13,
                                             1e-14,
                                             1e-15,
                                             1e-16,
                                             1e-17,
                                             1e-18};
    return decades[static_cast<std::size_t>(whole(random, least, most))];
}

PosedPair coplanar_overlapping(std::mt19937_64& random) {
    const LatticePlane plane = random_plane(random);
    PosedPair pair;
    for (Corners* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) {
            const int i = whole(random, -4, 4);
            corner = plane.at(i, whole(random, -4, 4));
        }
    }
    return finished(random, pair);
}

/// A is above the line j = 0 with an edge on it, B below with one: they share a part of the line, a
/// point or nothing.
PosedPair coplanar_along_an_edge(std::mt19937_64& random) {
    const LatticePlane plane = random_plane(random);
    PosedPair pair;
    const int first = whole(random, -4, 2);
    pair.a[0] = plane.at(-2, 0);
    pair.a[1] = plane.at(2, 0);
    pair.b[0] = plane.at(first, 0);
    pair.b[1] = plane.at(whole(random, first + 1, 5), 0);
    const int above = whole(random, 1, 5);
    const int below = -whole(random, 1, 5);
    pair.a[2] = plane.at(whole(random, -5, 5), above);
    pair.b[2] = plane.at(whole(random, -5, 5), below);
    return finished(random, pair);
}

/// A's lowest point or edge is on the line j = 0; B hangs from a point of it.
PosedPair coplanar_at_a_vertex(std::mt19937_64& random) {
    const LatticePlane plane = random_plane(random);
    const bool at_edge = coin(random);
    PosedPair pair;
    pair.a[0] = plane.at(at_edge ? -3 : 0, 0);
    pair.a[1] = plane.at(3, at_edge ? 0 : whole(random, 1, 4));
    pair.a[2] = plane.at(whole(random, -4, 2), 5);
    pair.b[0] = plane.at(0, 0);
    const int left = whole(random, -4, 0);
    const int right = whole(random, 1, 5);
    pair.b[1] = plane.at(left, -whole(random, 1, 5));
    pair.b[2] = plane.at(right, -whole(random, 1, 5));
    return finished(random, pair);
}

PosedPair sharing(std::mt19937_64& random, std::size_t corners) {
    PosedPair pair{random_corners(random, 1), random_corners(random, 1), {}};
    for (std::size_t i = 0; i < corners; ++i) {
        pair.b[i] = pair.a[i];
    }
    return finished(random, pair);
}

/// A vertex of B is exactly on A's face, edge or corner: a mean of corners on a coarse lattice.
PosedPair vertex_on_face(std::mt19937_64& random) {
    PosedPair pair{scaled(lattice_corners(random, 6), 4), random_corners(random, 20), {}};
    const int first = whole(random, 0, 4);
    const int second = whole(random, 0, 4 - first);
    pair.b[0] = (first * pair.a[0] + second * pair.a[1] + (4 - first - second) * pair.a[2]) / 4;
    return finished(random, pair);
}

/// Edges meet in an inner lattice point, or, if `off`, miss it by ulps of some coordinates.
PosedPair edge_crossing_edge(std::mt19937_64& random, bool off) {
    const Vec3 meeting = lattice_point(random, 5);
    PosedPair pair;
    for (Corners* t : {&pair.a, &pair.b}) {
        const Vec3 along = lattice_point(random, 7);
        const int back = whole(random, 1, 3);
        (*t)[0] = meeting - back * along;
        (*t)[1] = meeting + whole(random, 1, 3) * along;
        (*t)[2] = random_point(random, 12);
    }
    if (off) {
        pair.b[0] = nudged(random, pair.b[0]);
    }
    return finished(random, pair);
}

/// B's corners are off A's plane by one distance each, up, down or not at all.
PosedPair near_coplanar(std::mt19937_64& random) {
    const LatticePlane plane = random_plane(random);
    const Vec3 normal = plane.u.cross(plane.v) * decade(random, 8, 16);
    PosedPair pair;
    for (Corners* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) {
            const int i = whole(random, -3, 3);
            corner = plane.at(i, whole(random, -3, 3));
        }
    }
    for (Vec3& corner : pair.b) {
        corner += whole(random, -1, 1) * normal;
    }
    return finished(random, pair);
}

/// A is in z = base. A vertex, an edge or all of B is a gap above or below it.
PosedPair gap_or_penetration(std::mt19937_64& random) {
    const double base = coin(random) ? 0 : 1;
    const double gap = (coin(random) ? 1 : -1) * decade(random, 6, 17);
    PosedPair pair{random_corners(random, 1), {}, {}};
    for (Vec3& corner : pair.a) {
        corner.z() = base;
    }
    const std::uint64_t low = 1 + random() % 3;
    for (std::size_t i = 0; i < 3; ++i) {
        pair.b[i] = i == 0 ? point_on(random, pair.a) : random_point(random, 1);
        pair.b[i].z() = base + (i < low ? gap : uniform(random, 0.1, 1));
    }
    return finished(random, pair);
}

/// Edges along x and y pass each other at a gap in z.
PosedPair edges_at_a_gap(std::mt19937_64& random) {
    const double base = coin(random) ? 0 : 1;
    const double gap = (coin(random) ? 1 : -1) * decade(random, 6, 17);
    PosedPair pair;
    pair.a = {Vec3(-1, 0, base), Vec3(1, uniform(random, -0.1, 0.1), base), Vec3(0, 0, base - 1)};
    pair.b = {Vec3(0, -1, base + gap),
              Vec3(uniform(random, -0.1, 0.1), 1, base + gap),
              Vec3(0, 0, base + 1)};
    return finished(random, pair);
}

/// Halves of two axis-parallel rectangles. A is in x = s; B in x = s computed differently.
PosedPair boxes_touching(std::mt19937_64& random, double unit) {
    const auto coordinate = [&](int least, int most) { return whole(random, least, most) * unit; };
    const auto half = [&](double x) {
        const double y0 = coordinate(0, 5);
        const double y1 = coordinate(6, 12);
        const double z0 = coordinate(0, 5);
        const double z1 = coordinate(6, 12);
        return coin(random) ? Corners{Vec3(x, y0, z0), Vec3(x, y1, z0), Vec3(x, y1, z1)}
                            : Corners{Vec3(x, y0, z0), Vec3(x, y1, z1), Vec3(x, y0, z1)};
    };
    const int first = whole(random, 1, 30);
    const int second = whole(random, 1, 30);
    PosedPair pair{half((first + second) * unit), half(first * unit + second * unit), {}};
    if (coin(random)) {
        // B reaches its position by a pose instead.
        for (Vec3& corner : pair.b) {
            corner.x() = second * unit;
        }
        pair.poses.b = translation_pose(first * unit, 0, 0);
        return pair;
    }
    return finished(random, pair);
}

PosedPair identical(std::mt19937_64& random) {
    PosedPair pair{random_corners(random, 1), {}, {}};
    pair.b = pair.a;
    return finished(random, pair);
}

} // namespace

PosedPair shuffled(std::mt19937_64& random, PosedPair pair) {
    for (Corners* t : {&pair.a, &pair.b}) {
        std::swap((*t)[0], (*t)[random() % 3]);
        std::swap((*t)[1], (*t)[1 + random() % 2]);
    }
    if (coin(random)) {
        std::swap(pair.a, pair.b);
        std::swap(pair.poses.a, pair.poses.b);
    }
    return pair;
}

PosedPair posed_together(std::mt19937_64& random, PosedPair pair) {
    switch (random() % 6) {
    case 0:
        pair.poses.a = make_pose(random, 10);
        break;
    case 1:
        pair.poses.a = make_matrix_pose(random, 10);
        break;
    case 2: {
        const Vec3 offset = random_point(random, 1e3);
        pair.poses.a = translation_pose(offset.x(), offset.y(), offset.z());
        break;
    }
    default:
        break;
    }
    pair.poses.b = pair.poses.a;
    return pair;
}

PosedPair finished(std::mt19937_64& random, PosedPair pair) {
    return posed_together(random, shuffled(random, std::move(pair)));
}
void add_contact_makers(PairMakers& makers) {
    makers["coplanar, overlapping"] = coplanar_overlapping;
    makers["coplanar, touching along an edge"] = coplanar_along_an_edge;
    makers["coplanar, touching at a vertex"] = coplanar_at_a_vertex;
    makers["shared vertex"] = [](auto& r) { return sharing(r, 1); };
    makers["shared edge"] = [](auto& r) { return sharing(r, 2); };
    makers["vertex on face"] = vertex_on_face;
    makers["edge crossing edge"] = [](auto& r) { return edge_crossing_edge(r, false); };
    makers["edge crossing edge, one ulp off"] = [](auto& r) { return edge_crossing_edge(r, true); };
    makers["near-coplanar 1e-8 to 1e-16"] = near_coplanar;
    makers["gaps and penetrations 1e-6 to 1e-17"] = gap_or_penetration;
    makers["edges at gaps 1e-6 to 1e-17"] = edges_at_a_gap;
    makers["boxes touching, dyadic"] = [](auto& r) { return boxes_touching(r, 0.125); };
    makers["boxes touching, decimal"] = [](auto& r) { return boxes_touching(r, 0.1); };
    makers["identical, posed together"] = identical;
}

} // namespace cd::tests
