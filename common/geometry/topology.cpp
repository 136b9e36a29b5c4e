#include "common/geometry/topology.hpp"

#include "common/core/limits/engine.hpp"
#include "common/geometry/topology_stop.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// Items grouped into buckets, stored contiguously.
template <class T>
struct Buckets {
    std::vector<std::size_t> begins; ///< Bucket i spans begins[i] to begins[i + 1].
    std::vector<T> items;

    [[nodiscard]] std::size_t count() const { return begins.size() - 1; }
    [[nodiscard]] std::span<T> operator[](std::size_t i) {
        return std::span(items).subspan(begins[i], begins[i + 1] - begins[i]);
    }
};

/// Groups items into `count` buckets. `for_each` calls its argument with (bucket, item) for each
/// item, in the same order in both passes. The items of a bucket end up in reverse order.
template <class T, class ForEach>
Buckets<T> make_buckets(std::size_t count, const ForEach& for_each) {
    Buckets<T> buckets;
    buckets.begins.assign(count + 1, 0);
    for_each([&](std::size_t bucket, const T&) { ++buckets.begins[bucket]; });
    // Turns counts into bucket ends. Each insertion moves an end towards the begin of its bucket.
    std::partial_sum(buckets.begins.begin(), buckets.begins.end(), buckets.begins.begin());
    buckets.items.resize(buckets.begins.back());
    for_each(
        [&](std::size_t bucket, const T& item) { buckets.items[--buckets.begins[bucket]] = item; });
    return buckets;
}

/// Sorts a bucket. Insertion sort is faster for few items, which most buckets have.
template <class T>
void sort_bucket(std::span<T> items) {
    constexpr std::size_t few = 16;
    if (items.size() > few) {
        std::sort(items.begin(), items.end());
        return;
    }
    for (std::size_t i = 1; i < items.size(); ++i) {
        const T item = items[i];
        std::size_t k = i;
        for (; k > 0 && item < items[k - 1]; --k) {
            items[k] = items[k - 1];
        }
        items[k] = item;
    }
}

/// Hashes a vertex. Equal coordinates have equal hashes; no result depends on their values.
std::uint64_t hash_of(const Vec3& v) {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
        // -0 equals 0; adding 0 makes both 0.
        hash = (hash ^ std::bit_cast<std::uint64_t>(v[k] + 0.0)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    return hash;
}

/// Returns for each vertex the smallest index of a vertex with equal coordinates.
std::vector<std::uint32_t> joined_vertices(const std::vector<Vec3>& vertices) {
    const std::size_t bucket_count = std::bit_ceil(vertices.size());
    auto buckets = make_buckets<std::uint32_t>(bucket_count, [&](const auto& put) {
        for (std::uint32_t i = 0; i < vertices.size(); ++i) {
            put(hash_of(vertices[i]) & (bucket_count - 1), i);
        }
    });
    const auto key = [&](std::uint32_t i) {
        const Vec3& v = vertices[i];
        return std::tuple(v.x(), v.y(), v.z(), i);
    };
    std::vector<std::uint32_t> joined(vertices.size());
    for (std::size_t bucket = 0; bucket < buckets.count(); ++bucket) {
        const std::span<std::uint32_t> order = buckets[bucket];
        if (order.size() > 1) {
            std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
                return key(l) < key(r);
            });
        }
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool repeats = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
            joined[order[i]] = repeats ? joined[order[i - 1]] : order[i];
        }
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

std::uint64_t count_duplicates(const std::vector<Triangle>& triangles, std::size_t vertices) {
    using Others = std::array<std::uint32_t, 2>;
    auto by_least = make_buckets<Others>(vertices, [&](const auto& put) {
        for (Triangle triangle : triangles) {
            sort_bucket(std::span<std::uint32_t>(triangle));
            put(triangle[0], Others{triangle[1], triangle[2]});
        }
    });
    std::uint64_t duplicates = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const std::span<Others> bucket = by_least[vertex];
        sort_bucket(bucket);
        for (std::size_t i = 1; i < bucket.size(); ++i) {
            duplicates += bucket[i] == bucket[i - 1] ? 1u : 0u;
        }
    }
    return duplicates;
}

/// A triangle's use of an edge: twice the edge's higher vertex, plus 1 if the triangle runs towards
/// that vertex. Vertex indices are below 2^31 (limits::mesh_vertices_max).
using EdgeUse = std::uint32_t;

/// Counts the defective edges among all edges with one lower vertex, given the uses of these edges.
void count_edges(std::span<EdgeUse> uses, Topology& topology) {
    sort_bucket(uses);
    for (std::size_t begin = 0; begin < uses.size();) {
        std::size_t end = begin + 1;
        while (end < uses.size() && uses[end] / 2 == uses[begin] / 2) {
            ++end;
        }
        topology.boundary_edges += end - begin == 1 ? 1u : 0u;
        topology.non_manifold_edges += end - begin > 2 ? 1u : 0u;
        const bool same_way = end - begin == 2 && uses[begin] == uses[begin + 1];
        topology.inconsistent_edges += same_way ? 1u : 0u;
        begin = end;
    }
}

void count_edges(const std::vector<Triangle>& triangles, std::size_t vertices, Topology& topology) {
    auto by_low = make_buckets<EdgeUse>(vertices, [&](const auto& put) {
        for (const Triangle& triangle : triangles) {
            if (repeats_a_corner(triangle)) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t from = triangle[k];
                const std::uint32_t to = triangle[(k + 1) % 3];
                put(std::min(from, to), 2 * std::max(from, to) + (from < to ? 1u : 0u));
            }
        }
    });
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        count_edges(by_low[vertex], topology);
    }
}

/// Union-find with path halving; the smallest index represents a set.
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

std::optional<Topology> analyse_topology(const Mesh& mesh, const std::atomic<bool>& stop) {
    const std::size_t vertices = mesh.vertices().size();
    const std::vector<std::uint32_t> joined = joined_vertices(mesh.vertices());
    if (stop) {
        return std::nullopt;
    }
    std::vector<Triangle> triangles = mesh.triangles();
    Topology topology;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (std::uint32_t& vertex : triangles[i]) {
            vertex = joined[vertex];
        }
        topology.degenerate += is_degenerate(mesh, i, triangles[i]) ? 1u : 0u;
    }
    count_edges(triangles, vertices, topology);
    if (stop) {
        return std::nullopt;
    }
    topology.component_triangles = first_of_each_component(triangles, vertices);
    if (stop) {
        return std::nullopt;
    }
    topology.duplicate = count_duplicates(triangles, vertices);
    return topology;
}

Topology analyse_topology(const Mesh& mesh) {
    const std::atomic<bool> never = false;
    return std::move(*analyse_topology(mesh, never));
}

std::vector<std::uint32_t> first_of_own_component(const Mesh& mesh,
                                                  std::span<const std::uint32_t> kinds) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles().size());
    const std::vector<std::uint32_t> joined = joined_vertices(mesh.vertices());
    const auto kind_of = [&](std::uint32_t i) { return kinds.empty() ? 0 : kinds[i]; };
    auto by_vertex = make_buckets<std::uint32_t>(joined.size(), [&](const auto& put) {
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const std::uint32_t vertex : mesh.triangles()[i]) {
                put(joined[vertex], i);
            }
        }
    });
    DisjointSets sets(count);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> around; // (kind, triangle) pairs.
    for (std::size_t vertex = 0; vertex < by_vertex.count(); ++vertex) {
        around.clear();
        for (const std::uint32_t i : by_vertex[vertex]) {
            around.emplace_back(kind_of(i), i);
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = 1; k < around.size(); ++k) {
            if (around[k].first == around[k - 1].first) {
                sets.join(around[k].second, around[k - 1].second);
            }
        }
    }
    std::vector<std::uint32_t> firsts(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        firsts[i] = sets.find(i);
    }
    return firsts;
}

} // namespace cd
