#include "tests/support/touching_bodies.hpp"

#include "tests/support/brink_boxes.hpp"
#include "tests/support/shapes.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::array<std::string_view, 5> body_kinds{
    "soups", "solids", "slivers and flat bodies", "coordinates that need doubles", "far origins"};
constexpr std::array<std::string_view, 4> contact_kinds{
    "corner on corner", "one unit in the last place", "parallel faces", "skew matrices"};

/// Returns the mesh with its vertices mapped.
template <class Map>
Mesh mapped(const Mesh& mesh, const Map& map) {
    std::vector<Vec3> vertices;
    for (const Vec3& vertex : mesh.vertices()) {
        vertices.push_back(map(vertex));
    }
    return make_mesh(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()});
}

Vec3 rounded(const Vec3& vertex) {
    return vertex.cast<float>().cast<double>();
}

Mesh make_solid(std::mt19937_64& random) {
    switch (random() % 3) {
    case 0:
        return make_sphere(1 + static_cast<int>(random() % 3));
    case 1:
        return make_gridded_box(Vec3(1, 0.5, 0.25), 2 + static_cast<int>(random() % 6));
    default:
        return make_torus(1, 0.25, 12, 8 + static_cast<int>(random() % 12));
    }
}

Mesh make_body(std::size_t kind, std::mt19937_64& random) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 24) - 12);
    switch (kind) {
    case 0:
        return mapped(make_triangle_soup(random, 1 + random() % 200),
                      [&](const Vec3& vertex) { return rounded(size * vertex); });
    case 1:
        return mapped(make_solid(random),
                      [&](const Vec3& vertex) { return rounded(size * vertex); });
    case 2: {
        const double thin = std::ldexp(1.0, -static_cast<int>(random() % 40));
        return mapped(make_solid(random), [&](const Vec3& vertex) {
            return rounded(size * Vec3(vertex.x(), vertex.y(), thin * vertex.z()));
        });
    }
    case 3:
        return mapped(make_solid(random), [&](const Vec3& vertex) {
            return Vec3(size * (vertex + Vec3(0.1, 0.2, 0.3)));
        });
    default: {
        const double far = std::ldexp(1.0, 4 + static_cast<int>(random() % 30));
        const Vec3 offset(uniform(random, -far, far), uniform(random, -far, far), far);
        return mapped(make_solid(random),
                      [&](const Vec3& vertex) { return Vec3(size * (vertex + offset)); });
    }
    }
}

/// Returns the vertex that is farthest along a direction.
Vec3 farthest_along(const Mesh& mesh, const Vec3& direction) {
    Vec3 best = mesh.vertices()[0];
    for (const Vec3& vertex : mesh.vertices()) {
        best = direction.dot(vertex) > direction.dot(best) ? vertex : best;
    }
    return best;
}

Pose rotation_of(std::size_t kind, std::mt19937_64& random) {
    if (kind == 2) {
        return Pose{};
    }
    if (kind == 3) {
        return with_translation(any_pose(random, 1), Vec3::Zero());
    }
    return with_translation(random() % 2 == 0 ? make_pose(random, 1) : make_matrix_pose(random, 1),
                            Vec3::Zero());
}

/// Moves each coordinate by up to three units in the last place.
Vec3 nudged(const Vec3& point, std::mt19937_64& random) {
    Vec3 moved = point;
    for (int k = 0; k < 3; ++k) {
        const double towards = random() % 2 == 0 ? -HUGE_VAL : HUGE_VAL;
        for (auto i = random() % 4; i > 0; --i) {
            moved[k] = std::nextafter(moved[k], towards);
        }
    }
    return moved;
}

} // namespace

std::string touching_category(std::size_t category) {
    return std::string(body_kinds[category / contact_kinds.size()]) + ", " +
           std::string(contact_kinds[category % contact_kinds.size()]);
}

TouchingBodies make_touching(std::size_t category, std::mt19937_64& random) {
    const std::size_t contact = category % contact_kinds.size();
    TouchingBodies made{make_body(category / contact_kinds.size(), random),
                        make_body(category / contact_kinds.size(), random),
                        {},
                        Vec3::Zero()};
    made.outwards = contact == 2 ? Vec3(random() % 2, 0, 1)
                                 : Vec3(uniform(random, -1, 1), uniform(random, -1, 1), 1);
    made.outwards.normalize();
    const Pose turn_a = rotation_of(contact, random);
    const Pose turn_b = rotation_of(contact, random);
    const Vec3 last =
        turn_a.apply(farthest_along(made.a, turn_a.rotation().transpose() * made.outwards));
    const Vec3 first =
        turn_b.apply(farthest_along(made.b, -(turn_b.rotation().transpose() * made.outwards)));
    const Vec3 place = contact == 1 || contact == 3 ? nudged(last, random) : last;
    made.poses = {turn_a, with_translation(turn_b, place - first)};
    return made;
}

} // namespace cd::tests
