#include "bench/floor_kernels.hpp"

#include "common/geometry/highway_targets.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/floor_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway compiles the code below once per target.
#include <hwy/highway.h>

#ifndef CD_FLOOR_KERNELS_ONCE
#define CD_FLOOR_KERNELS_ONCE
namespace cd::bench {

constexpr std::size_t boxes_a_node = 16;
/// Floats per triangle: nine coordinates and three of padding.
constexpr std::size_t numbers_a_triangle = 12;

struct BoxNode {
    alignas(64) float low[3][boxes_a_node];
    alignas(64) float high[3][boxes_a_node];
};

/// Pose of B in A's frame.
struct FloorPose {
    float rotation[3][3];
    float sizes[3][3]; ///< Absolute values of the rotation matrix.
    float translation[3];
    float margin;
};

/// Pairs of triangle indices, in two arrays.
struct FloorPairs {
    std::int32_t* a;
    std::int32_t* b;
};

} // namespace cd::bench
#endif

HWY_BEFORE_NAMESPACE();
namespace cd::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, boxes_a_node>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

/// Transforms a node's boxes into the other frame.
template <bool kFromA>
HWY_INLINE void see(const BoxNode& node, const FloorPose& pose, BoxNode& seen) {
    const Floats d;
    for (std::size_t i = 0; i < boxes_a_node; i += hn::Lanes(d)) {
        V middle[3];
        V half[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const V low = hn::Load(d, node.low[k] + i);
            const V high = hn::Load(d, node.high[k] + i);
            middle[k] = hn::Mul(hn::Set(d, 0.5F), hn::Add(low, high));
            half[k] = hn::Mul(hn::Set(d, 0.5F), hn::Sub(high, low));
            if constexpr (kFromA) {
                middle[k] = hn::Sub(middle[k], hn::Set(d, pose.translation[k]));
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            V at = hn::Set(d, kFromA ? 0 : pose.translation[k]);
            V reach = hn::Set(d, pose.margin);
            for (std::size_t c = 0; c < 3; ++c) {
                const float entry = kFromA ? pose.rotation[c][k] : pose.rotation[k][c];
                const float size = kFromA ? pose.sizes[c][k] : pose.sizes[k][c];
                at = hn::MulAdd(hn::Set(d, entry), middle[c], at);
                reach = hn::MulAdd(hn::Set(d, size), half[c], reach);
            }
            hn::Store(hn::Sub(at, reach), d, seen.low[k] + i);
            hn::Store(hn::Add(at, reach), d, seen.high[k] + i);
        }
    }
}

/// Writes the lanes that the mask selects, with garbage after them; returns their number.
template <class D>
HWY_INLINE std::size_t keep(hn::Vec<D> values, hn::Mask<D> mask, D d, hn::TFromD<D>* to) {
    // Compresses in a register: some processors compress into memory ten times as slowly.
    hn::StoreU(hn::Compress(values, mask), d, to);
    return hn::CountTrue(d, mask);
}

/// Writes the pairs of overlapping boxes of A and B; returns their number.
std::size_t
pair_boxes(const BoxNode& a, const BoxNode& b, const FloorPose& pose, std::uint32_t* to) {
    const Floats d;
    const hn::RebindToUnsigned<Floats> du;
    BoxNode seen_a;
    BoxNode seen_b;
    see<true>(a, pose, seen_a);
    see<false>(b, pose, seen_b);
    const auto steps = hn::Iota(du, 0);
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < boxes_a_node; lane += hn::Lanes(d)) {
        for (std::size_t i = 0; i < boxes_a_node; ++i) {
            M found = hn::FirstN(d, hn::Lanes(d));
            for (std::size_t k = 0; k < 3; ++k) {
                const auto meet = [&](const BoxNode& rows, const BoxNode& lanes) HWY_ATTR {
                    const V low = hn::Load(d, lanes.low[k] + lane);
                    const V high = hn::Load(d, lanes.high[k] + lane);
                    found = hn::And(found, hn::Le(low, hn::Set(d, rows.high[k][i])));
                    found = hn::And(found, hn::Ge(high, hn::Set(d, rows.low[k][i])));
                };
                meet(a, seen_b);
                meet(seen_a, b);
            }
            const auto pairs =
                hn::Add(steps, hn::Set(du, static_cast<std::uint32_t>(boxes_a_node * i + lane)));
            count += keep(pairs, hn::RebindMask(du, found), du, to + count);
        }
    }
    return count;
}

HWY_INLINE V dot(const V* x, const V* y) {
    return hn::MulAdd(x[2], y[2], hn::MulAdd(x[1], y[1], hn::Mul(x[0], y[0])));
}

HWY_INLINE void cross(const V* x, const V* y, V* to) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        to[k] = hn::MulSub(x[i], y[j], hn::Mul(x[j], y[i]));
    }
}

HWY_INLINE V sum_of_sizes(const V* x) {
    return hn::Add(hn::Abs(x[0]), hn::Add(hn::Abs(x[1]), hn::Abs(x[2])));
}

/// Returns whether all corners of `other` are certainly on one side of the plane of `one`.
HWY_INLINE M is_beside(const V one[3][3], const V other[3][3], float margin) {
    const Floats d;
    V p[3];
    V q[3];
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = hn::Sub(one[1][k], one[0][k]);
        q[k] = hn::Sub(one[2][k], one[0][k]);
    }
    V normal[3];
    cross(p, q, normal);
    V side[3];
    V reach = hn::Zero(d);
    for (std::size_t c = 0; c < 3; ++c) {
        V from[3];
        for (std::size_t k = 0; k < 3; ++k) {
            from[k] = hn::Sub(other[c][k], one[0][k]);
        }
        side[c] = dot(normal, from);
        reach = hn::Max(reach, sum_of_sizes(from));
    }
    const V edges = hn::Mul(sum_of_sizes(p), sum_of_sizes(q));
    const V error = hn::Mul(hn::Set(d, margin), hn::MulAdd(edges, reach, edges));
    const V least = hn::Min(side[0], hn::Min(side[1], side[2]));
    const V most = hn::Max(side[0], hn::Max(side[1], side[2]));
    return hn::Or(hn::Gt(least, error), hn::Lt(most, hn::Neg(error)));
}

/// Keeps those of `count` pairs in which neither triangle lies beside the other's plane; returns
/// their number. `count` is a multiple of sixteen.
std::size_t pick_across(const float* triangles_a,
                        const float* triangles_b,
                        const FloorPairs& pairs,
                        std::size_t count,
                        const FloorPose& pose,
                        const FloorPairs& to) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto ids_a = hn::LoadU(di, pairs.a + i);
        const auto ids_b = hn::LoadU(di, pairs.b + i);
        const auto numbers = hn::Set(di, std::int32_t{numbers_a_triangle});
        const auto at_a = hn::Mul(ids_a, numbers);
        const auto at_b = hn::Mul(ids_b, numbers);
        V a[3][3];
        V b[3][3];
        for (std::size_t c = 0; c < 3; ++c) {
            V own[3];
            for (std::size_t k = 0; k < 3; ++k) {
                a[c][k] = hn::GatherIndex(d, triangles_a + 3 * c + k, at_a);
                own[k] = hn::GatherIndex(d, triangles_b + 3 * c + k, at_b);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                b[c][k] = hn::Set(d, pose.translation[k]);
                for (std::size_t j = 0; j < 3; ++j) {
                    b[c][k] = hn::MulAdd(hn::Set(d, pose.rotation[k][j]), own[j], b[c][k]);
                }
            }
        }
        const M beside = hn::Or(is_beside(a, b, pose.margin), is_beside(b, a, pose.margin));
        const auto across = hn::RebindMask(di, hn::Not(beside));
        keep(ids_a, across, di, to.a + kept);
        kept += keep(ids_b, across, di, to.b + kept);
    }
    return kept;
}

} // namespace HWY_NAMESPACE
} // namespace cd::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "common/geometry/simd_target.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace cd::bench {

HWY_EXPORT(pair_boxes);
HWY_EXPORT(pick_across);

namespace {

constexpr std::size_t node_pairs = 8;
constexpr std::size_t soup_triangles = 64;
constexpr std::size_t triangle_pairs = 1024;

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(random() >> 11);
}

Vec3 random_point(std::mt19937_64& random, double half_width) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
        point[k] = uniform(random, -half_width, half_width);
    }
    return point;
}

BoxNode random_node(std::mt19937_64& random) {
    BoxNode node;
    for (std::size_t i = 0; i < boxes_a_node; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double middle = uniform(random, -1, 1);
            const double half = uniform(random, 0.1, 0.3);
            node.low[k][i] = static_cast<float>(middle - half);
            node.high[k][i] = static_cast<float>(middle + half);
        }
    }
    return node;
}

/// Random triangles about a third as large as the cube that contains them.
MeshArrays random_soup(std::mt19937_64& random) {
    MeshArrays soup;
    for (std::uint32_t i = 0; i < soup_triangles; ++i) {
        const Vec3 middle = random_point(random, 0.5);
        for (int c = 0; c < 3; ++c) {
            const Vec3 corner = middle + random_point(random, 0.7);
            soup.vertices.push_back(corner.cast<float>().cast<double>());
        }
        soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return soup;
}

std::vector<float> numbers_of(const MeshArrays& soup) {
    std::vector<float> numbers(numbers_a_triangle * soup.triangles.size());
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[numbers_a_triangle * (i / 3) + 3 * (i % 3) + k] =
                static_cast<float>(soup.vertices[i][static_cast<int>(k)]);
        }
    }
    return numbers;
}

TriangleBlockArrays blocks_of(const MeshArrays& soup) {
    TriangleBlockArrays blocks(Precision::Float);
    for (std::size_t i = 0; i < soup_triangles; i += block_size) {
        const std::array<std::uint32_t, block_size> ids{};
        blocks.add(std::span(soup.triangles).subspan(i, block_size), ids, soup.vertices);
    }
    return blocks;
}

FloorPose floor_pose(const Pose& pose) {
    FloorPose floor{};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            floor.rotation[i][k] = static_cast<float>(pose.rotation()(i, k));
            floor.sizes[i][k] = std::abs(floor.rotation[i][k]);
        }
        floor.translation[i] = static_cast<float>(pose.translation()[i]);
    }
    floor.margin = 0x1p-18F;
    return floor;
}

} // namespace

struct FloorKernels::Data {
    std::mt19937_64 random{11};
    PosePair poses{Pose{}, Pose::from_quaternion({1, 0.3, -0.2, 0.4}, Vec3(0.1, 0.2, -0.1))};
    FloorPose pose = floor_pose(poses.b);
    std::vector<BoxNode> nodes_a;
    std::vector<BoxNode> nodes_b;
    MeshArrays soup_a = random_soup(random);
    MeshArrays soup_b = random_soup(random);
    std::vector<float> numbers_a = numbers_of(soup_a);
    std::vector<float> numbers_b = numbers_of(soup_b);
    TriangleBlockArrays blocks_a = blocks_of(soup_a);
    TriangleBlockArrays blocks_b = blocks_of(soup_b);
    FloatTrianglePair in_float{poses};
    std::vector<std::int32_t> pairs_a;
    std::vector<std::int32_t> pairs_b;
    // The vectors have room for the garbage lanes.
    std::vector<std::uint32_t> found =
        std::vector<std::uint32_t>(boxes_a_node * boxes_a_node + boxes_a_node);
    std::vector<std::int32_t> kept_a = std::vector<std::int32_t>(triangle_pairs + boxes_a_node);
    std::vector<std::int32_t> kept_b = std::vector<std::int32_t>(triangle_pairs + boxes_a_node);
    std::vector<Candidate> across;
    std::vector<FloatVerdict> verdicts = std::vector<FloatVerdict>(triangle_pairs);
};

FloorKernels::FloorKernels() : data_(std::make_unique<Data>()) {
    // Runs before the first call, so that a setting of the target takes effect.
    static_cast<void>(simd_target());
    for (std::size_t i = 0; i < node_pairs; ++i) {
        data_->nodes_a.push_back(random_node(data_->random));
        data_->nodes_b.push_back(random_node(data_->random));
    }
    for (std::size_t i = 0; i < triangle_pairs; ++i) {
        data_->pairs_a.push_back(static_cast<std::int32_t>(data_->random() % soup_triangles));
        data_->pairs_b.push_back(static_cast<std::int32_t>(data_->random() % soup_triangles));
    }
    const std::uint64_t left = sides().left;
    for (std::size_t i = 0; i < left; ++i) {
        data_->across.push_back({static_cast<std::uint32_t>(data_->kept_a[i]),
                                 static_cast<std::uint32_t>(data_->kept_b[i])});
    }
}

FloorKernels::~FloorKernels() = default;

FloorCounts FloorKernels::boxes() {
    FloorCounts counts;
    for (std::size_t i = 0; i < node_pairs; ++i) {
        counts.looked_at += boxes_a_node * boxes_a_node;
        counts.left += HWY_DYNAMIC_DISPATCH(pair_boxes)(
            data_->nodes_a[i], data_->nodes_b[i], data_->pose, data_->found.data());
    }
    return counts;
}

FloorCounts FloorKernels::sides() {
    const std::size_t left =
        HWY_DYNAMIC_DISPATCH(pick_across)(data_->numbers_a.data(),
                                          data_->numbers_b.data(),
                                          {data_->pairs_a.data(), data_->pairs_b.data()},
                                          triangle_pairs,
                                          data_->pose,
                                          {data_->kept_a.data(), data_->kept_b.data()});
    return {triangle_pairs, left};
}

FloorCounts FloorKernels::decision() {
    const auto verdicts = std::span(data_->verdicts).first(data_->across.size());
    data_->in_float.classify(
        data_->blocks_a.view(), data_->blocks_b.view(), data_->across, verdicts);
    const auto left = std::count(verdicts.begin(), verdicts.end(), FloatVerdict::Proper);
    return {data_->across.size(), static_cast<std::uint64_t>(left)};
}

} // namespace cd::bench

#endif
