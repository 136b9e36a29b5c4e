#include "tests/corpus/solids.hpp"

#include "tests/support/shapes.hpp"

#include <cmath>
#include <utility>

namespace cd::tests {

namespace {
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

Mesh without_last(const Mesh& mesh, std::size_t count) {
    std::vector<Triangle> triangles = mesh.triangles();
    triangles.resize(triangles.size() - count);
    return make_mesh(mesh.vertices(), std::move(triangles));
}

} // namespace cd::tests
