#include "common/geometry/topology.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>

namespace cd {

namespace {

/// For each vertex the smallest index of a vertex with the same coordinates.
std::vector<std::uint32_t> joined_vertices(const std::vector<Vec3>& vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const Vec3& v = vertices[i];
        return std::array{v.x(), v.y(), v.z()};
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
        const auto left = key(l);
        const auto right = key(r);
        return left != right ? left < right : l < r;
    });
    std::vector<std::uint32_t> joined(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool repeats = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
        joined[order[i]] = repeats ? joined[order[i - 1]] : order[i];
    }
    return joined;
}

bool repeats_a_corner(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

bool is_degenerate(const Mesh& mesh, std::uint32_t triangle, const Triangle& joined) {
    if (repeats_a_corner(joined)) {
        return true;
    }
    const Corners c = mesh.corners(triangle);
    const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
    return normal == Vec3::Zero();
}

std::uint64_t count_duplicates(std::vector<Triangle> triangles) {
    for (Triangle& triangle : triangles) {
        std::sort(triangle.begin(), triangle.end());
    }
    std::sort(triangles.begin(), triangles.end());
    std::uint64_t duplicates = 0;
    for (std::size_t i = 1; i < triangles.size(); ++i) {
        duplicates += triangles[i] == triangles[i - 1] ? 1u : 0u;
    }
    return duplicates;
}

struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    bool is_forward = false; ///< The triangle runs from low to high.

    friend auto operator<=>(const Edge&, const Edge&) = default;
};

void count_edges(std::vector<Edge> edges, Topology& topology) {
    std::sort(edges.begin(), edges.end());
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin;
        while (end < edges.size() && edges[end].low == edges[begin].low &&
               edges[end].high == edges[begin].high) {
            ++end;
        }
        const std::size_t uses = end - begin;
        topology.boundary_edges += uses == 1 ? 1u : 0u;
        topology.non_manifold_edges += uses > 2 ? 1u : 0u;
        const bool same_way = uses == 2 && edges[begin].is_forward == edges[begin + 1].is_forward;
        topology.inconsistent_edges += same_way ? 1u : 0u;
        begin = end;
    }
}

/// Sets that grow together: union by the smaller index, with path halving.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = find(i);
        const std::uint32_t b = find(j);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

std::vector<std::uint32_t> first_of_each_component(const std::vector<Triangle>& triangles,
                                                   std::size_t vertices) {
    DisjointSets sets(vertices);
    for (const Triangle& triangle : triangles) {
        sets.join(triangle[0], triangle[1]);
        sets.join(triangle[0], triangle[2]);
    }
    std::vector<bool> seen(vertices, false);
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t set = sets.find(triangles[i][0]);
        if (!seen[set]) {
            seen[set] = true;
            firsts.push_back(i);
        }
    }
    return firsts;
}

} // namespace

Topology analyse_topology(const Mesh& mesh) {
    const std::vector<std::uint32_t> joined = joined_vertices(mesh.vertices());
    std::vector<Triangle> triangles = mesh.triangles();
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    Topology topology;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        Triangle& triangle = triangles[i];
        for (std::uint32_t& vertex : triangle) {
            vertex = joined[vertex];
        }
        topology.degenerate += is_degenerate(mesh, i, triangle) ? 1u : 0u;
        if (repeats_a_corner(triangle)) {
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k];
            const std::uint32_t to = triangle[(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    }
    count_edges(std::move(edges), topology);
    topology.component_triangles = first_of_each_component(triangles, mesh.vertices().size());
    topology.duplicate = count_duplicates(std::move(triangles));
    return topology;
}

} // namespace cd
