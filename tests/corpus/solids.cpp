#include "tests/corpus/solids.hpp"

#include "tests/support/shapes.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace cd::tests {

namespace {

using Quad = std::array<std::uint32_t, 4>;

/// Adds the two triangles of a quadrilateral, corners counter-clockwise from outside.
void add_quad(std::vector<Triangle>& triangles, const Quad& q) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
}

Vec3 middle_on_sphere(const Vec3& a, const Vec3& b) {
    const double x = a.x() + b.x();
    const double y = a.y() + b.y();
    const double z = a.z() + b.z();
    const double length = std::sqrt((x * x + y * y) + z * z);
    return {x / length, y / length, z / length};
}

/// Numbers vertices by grid position, each once.
class GridVertices {
  public:
    using Place = std::array<std::size_t, 3>;

    explicit GridVertices(std::array<std::vector<double>, 3> ticks) : ticks_(std::move(ticks)) {}

    std::uint32_t at(const Place& place) {
        const auto [found, is_new] =
            numbers_.emplace(place, static_cast<std::uint32_t>(vertices.size()));
        if (is_new) {
            vertices.emplace_back(ticks_[0][place[0]], ticks_[1][place[1]], ticks_[2][place[2]]);
        }
        return found->second;
    }

    std::vector<Vec3> vertices;

  private:
    std::array<std::vector<double>, 3> ticks_;
    std::map<Place, std::uint32_t> numbers_;
};

/// Adds the sides of a prism between rings of `size` vertices each, from the bottom up.
void add_sides(std::vector<Triangle>& triangles, std::uint32_t size, std::uint32_t rings) {
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t here = ring * size + i;
            const std::uint32_t next = ring * size + (i + 1) % size;
            add_quad(triangles, {here, next, next + size, here + size});
        }
    }
}

} // namespace

std::vector<Vec2> unit_circle(int doublings) {
    std::vector<Vec2> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int round = 0; round < doublings; ++round) {
        std::vector<Vec2> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2& next = points[(i + 1) % points.size()];
            const double x = points[i][0] + next[0];
            const double y = points[i][1] + next[1];
            const double length = std::sqrt(x * x + y * y);
            finer.push_back(points[i]);
            finer.push_back({x / length, y / length});
        }
        points = std::move(finer);
    }
    return points;
}

std::vector<double> ticks(double first, double step, int count) {
    std::vector<double> values;
    for (int i = 0; i <= count; ++i) {
        values.push_back(first + i * step);
    }
    return values;
}

Mesh make_ticked_box(const std::vector<double>& x,
                     const std::vector<double>& y,
                     const std::vector<double>& z) {
    const std::array<std::size_t, 3> cells{x.size() - 1, y.size() - 1, z.size() - 1};
    GridVertices grid({x, y, z});
    std::vector<Triangle> triangles;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        for (const bool top : {false, true}) {
            for (std::size_t i = 0; i < cells[u]; ++i) {
                for (std::size_t j = 0; j < cells[v]; ++j) {
                    const auto corner = [&](std::size_t du, std::size_t dv) {
                        GridVertices::Place place{};
                        place[axis] = top ? cells[axis] : 0;
                        place[u] = i + du;
                        place[v] = j + dv;
                        return grid.at(place);
                    };
                    Quad quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (!top) {
                        std::swap(quad[1], quad[3]);
                    }
                    add_quad(triangles, quad);
                }
            }
        }
    }
    return make_mesh(std::move(grid.vertices), std::move(triangles));
}

Mesh make_box_between(const Vec3& low, const Vec3& high) {
    return make_ticked_box({low.x(), high.x()}, {low.y(), high.y()}, {low.z(), high.z()});
}

Mesh make_round_sphere(int subdivisions) {
    std::vector<Vec3> vertices{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Triangle> triangles{
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int round = 0; round < subdivisions; ++round) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, is_new] =
                middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices.size()));
            if (is_new) {
                vertices.push_back(middle_on_sphere(vertices[a], vertices[b]));
            }
            return place->second;
        };
        std::vector<Triangle> finer;
        for (const Triangle& t : triangles) {
            const std::uint32_t ab = middle(t[0], t[1]);
            const std::uint32_t bc = middle(t[1], t[2]);
            const std::uint32_t ca = middle(t[2], t[0]);
            finer.insert(finer.end(),
                         {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_round_torus(double radius, double tube, int around, int across) {
    const std::vector<Vec2> ring = unit_circle(around);
    const std::vector<Vec2> section = unit_circle(across);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Vec2& direction : ring) {
        for (const Vec2& place : section) {
            const double r = radius + tube * place[0];
            vertices.emplace_back(r * direction[0], r * direction[1], tube * place[1]);
        }
    }
    const auto vertex = [&](std::size_t i, std::size_t j) {
        return static_cast<std::uint32_t>((i % ring.size()) * section.size() + j % section.size());
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t j = 0; j < section.size(); ++j) {
            add_quad(triangles,
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_gear(int doublings, double root, double tip, double height, int layers) {
    // Each tooth has eight directions: those next to its axis form the tip, and flanks fall to the
    // root.
    const std::vector<Vec2> directions = unit_circle(doublings + 1);
    const auto size = static_cast<std::uint32_t>(directions.size());
    std::vector<Vec3> vertices;
    for (int layer = 0; layer <= layers; ++layer) {
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t phase = i % 8;
            const double radius = phase <= 1 || phase == 7 ? tip : root;
            vertices.emplace_back(
                radius * directions[i][0], radius * directions[i][1], height * layer / layers);
        }
    }
    std::vector<Triangle> triangles;
    add_sides(triangles, size, static_cast<std::uint32_t>(layers) + 1);
    const auto bottom = static_cast<std::uint32_t>(vertices.size());
    vertices.emplace_back(0, 0, 0);
    vertices.emplace_back(0, 0, height);
    const std::uint32_t top_ring = static_cast<std::uint32_t>(layers) * size;
    for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t next = (i + 1) % size;
        triangles.push_back({bottom, next, i});
        triangles.push_back({bottom + 1, top_ring + i, top_ring + next});
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_prism(const std::vector<Vec2>& outline, double low, double high) {
    const auto size = static_cast<std::uint32_t>(outline.size());
    std::vector<Vec3> vertices;
    for (const double z : {low, high}) {
        for (const Vec2& corner : outline) {
            vertices.emplace_back(corner[0], corner[1], z);
        }
    }
    std::vector<Triangle> triangles;
    add_sides(triangles, size, 2);
    for (std::uint32_t i = 1; i + 1 < size; ++i) {
        triangles.push_back({0, i + 1, i});
        triangles.push_back({size, size + i, size + i + 1});
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_terrain(std::uint64_t seed, int n, double cell, const Vec3& corner) {
    std::mt19937_64 random(seed);
    std::vector<Vec3> vertices;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            const double height = 0.01 * static_cast<double>(random() % 100);
            vertices.emplace_back(
                corner.x() + i * cell, corner.y() + j * cell, corner.z() + height);
        }
    }
    const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            add_quad(triangles,
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh scaled(const Mesh& mesh, double factor) {
    std::vector<Vec3> vertices = mesh.vertices();
    for (Vec3& vertex : vertices) {
        vertex *= factor;
    }
    return make_mesh(std::move(vertices), mesh.triangles());
}

Mesh without_last(const Mesh& mesh, std::size_t count) {
    std::vector<Triangle> triangles = mesh.triangles();
    triangles.resize(triangles.size() - count);
    return make_mesh(mesh.vertices(), std::move(triangles));
}

} // namespace cd::tests
