// Reads one candidate's corners per SIMD lane, as rows of edges and differences.
// float_pair_columns-inl.hpp turns the rows into columns. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_FLOAT_PAIR_ROWS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_FLOAT_PAIR_ROWS_INL_HPP
#undef CD_FLOAT_PAIR_ROWS_INL_HPP
#else
#define CD_FLOAT_PAIR_ROWS_INL_HPP
#endif

#include "common/pair/stages/float/float_pair_kernel.hpp"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using V = hn::Vec<Floats>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());

/// Edges and differences of one pair per lane, as rows of three numbers and an unused one. SIMD
/// vector k of each array has the rows of the pairs k, k + 4, k + 8 and k + 12, as far as there are
/// lanes. So the transposition to columns stays within 128 bits, which is cheapest.
struct Rows {
    alignas(64) float p[4 * lanes];   ///< First edges of A.
    alignas(64) float q[4 * lanes];   ///< Second edges of A.
    alignas(64) float e[4 * lanes];   ///< First edges of B before rotation.
    alignas(64) float f[4 * lanes];   ///< Second edges of B before rotation.
    alignas(64) float d[4 * lanes];   ///< First corners of A minus posed first corners of B.
    alignas(64) float d_error[lanes]; ///< Error bounds of B's posed corners.
};

/// Pointers to a triangle's corners.
template <class T>
struct CornerRows {
    const T* x0;
    const T* x1;
    const T* x2;
};

/// Reads corners from TriangleBlocks.
template <class T>
struct BlockSource {
    using Number = T;
    static constexpr bool four_are_readable = true;

    const T* vertices;
    const std::uint32_t* vertex_begin;
    const std::uint8_t* corners;

    HWY_INLINE CornerRows<T> at(std::uint32_t place) const {
        const T* first = vertices + 3 * std::size_t{vertex_begin[place / 16]};
        const std::uint8_t* c = corners + 4 * std::size_t{place};
        return {first + 3 * std::size_t{c[0]},
                first + 3 * std::size_t{c[1]},
                first + 3 * std::size_t{c[2]}};
    }
};

/// Reads corners from a TriangleSpan.
struct MeshSource {
    using Number = double;
    static constexpr bool four_are_readable = false;

    const double* vertices;
    const std::uint32_t* triangles;

    HWY_INLINE CornerRows<double> at(std::uint32_t place) const {
        const std::uint32_t* t = triangles + 3 * std::size_t{place};
        return {vertices + 3 * std::size_t{t[0]},
                vertices + 3 * std::size_t{t[1]},
                vertices + 3 * std::size_t{t[2]}};
    }
};

template <class T>
BlockSource<T> blocks_of(const FloatPairBody& body, const T* vertices) {
    return {vertices, body.vertex_begin, body.corners};
}

/// Calls `use(a, b, reach)` with the sources of both bodies. `reach` bounds every |coordinate| of
/// B's blocks; 0 for a mesh.
template <class Use>
void with_sources(const FloatPairBody& a, const FloatPairBody& b, const Use& use) {
    const auto with_a = [&](const auto& from_a) {
        if (b.kind == FloatPairBody::Kind::FloatBlocks) {
            use(from_a, blocks_of(b, b.floats), b.reach);
        } else {
            use(from_a, blocks_of(b, b.doubles), b.reach);
        }
    };
    switch (a.kind) {
    case FloatPairBody::Kind::FloatBlocks:
        return with_a(blocks_of(a, a.floats));
    case FloatPairBody::Kind::DoubleBlocks:
        return with_a(blocks_of(a, a.doubles));
    case FloatPairBody::Kind::Mesh:
        return use(MeshSource{a.doubles, a.triangles}, MeshSource{b.doubles, b.triangles}, 0.0);
    }
}

/// Candidates alternate between A's and B's triangle numbers.
constexpr std::size_t candidate_step = 2;

#if HWY_MAX_BYTES >= 32

using Doubles = hn::ScalableTag<double>;
using VD = hn::Vec<Doubles>;

/// Corners of several triangles, four numbers (three used) per corner.
template <class Vector>
struct Corners4 {
    Vector x0;
    Vector x1;
    Vector x2;
};

template <class Source, class D>
HWY_INLINE hn::Vec<D> load_row(D d, const typename Source::Number* from) {
    if constexpr (Source::four_are_readable) {
        return hn::LoadU(d, from);
    } else {
        return hn::MaskedLoad(hn::FirstN(d, 3), d, from);
    }
}

/// Loads the corners of every fourth candidate, as many as fit a vector.
template <class D, class Source>
HWY_INLINE Corners4<hn::Vec<D>>
load_corners(D d, const Source& source, const std::uint32_t* candidates) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        const CornerRows<typename Source::Number> rows = source.at(*candidates);
        return {load_row<Source>(d, rows.x0),
                load_row<Source>(d, rows.x1),
                load_row<Source>(d, rows.x2)};
    } else {
        const hn::Half<D> half;
        constexpr std::size_t next = hn::MaxLanes(D()) / 8 * 4 * candidate_step;
        const auto low = load_corners(half, source, candidates);
        const auto high = load_corners(half, source, candidates + next);
        return {hn::Combine(d, high.x0, low.x0),
                hn::Combine(d, high.x1, low.x1),
                hn::Combine(d, high.x2, low.x2)};
    }
}

/// The two edges from the first corner, and that corner in two halves.
struct Sides {
    V first;
    V second;
    VD corner_low;
    VD corner_high;
};

HWY_INLINE V narrowed(VD low, VD high) {
    const hn::Half<Floats> half;
    return hn::Combine(Floats(), hn::DemoteTo(half, high), hn::DemoteTo(half, low));
}

template <class Source>
HWY_INLINE Sides load_sides(const Source& source, const std::uint32_t* candidates) {
    const Doubles dd;
    if constexpr (sizeof(typename Source::Number) == sizeof(float)) {
        const Floats df;
        const hn::Half<Floats> half;
        const auto rows = load_corners(df, source, candidates);
        return {hn::Sub(rows.x1, rows.x0),
                hn::Sub(rows.x2, rows.x0),
                hn::PromoteTo(dd, hn::LowerHalf(half, rows.x0)),
                hn::PromoteTo(dd, hn::UpperHalf(half, rows.x0))};
    } else {
        constexpr std::size_t next = lanes / 8 * 4 * candidate_step;
        const auto low = load_corners(dd, source, candidates);
        const auto high = load_corners(dd, source, candidates + next);
        return {narrowed(hn::Sub(low.x1, low.x0), hn::Sub(high.x1, high.x0)),
                narrowed(hn::Sub(low.x2, low.x0), hn::Sub(high.x2, high.x0)),
                low.x0,
                high.x0};
    }
}

/// Broadcasts one number of each row within its row.
template <int number>
HWY_INLINE VD spread(VD rows) {
    alignas(64) constexpr std::int64_t places[8] = {
        number, number, number, number, number + 4, number + 4, number + 4, number + 4};
    return hn::TableLookupLanes(rows, hn::SetTableIndices(Doubles(), places));
}

HWY_INLINE VD posed(const FloatPairPose& pose, VD rows) {
    const Doubles dd;
    const VD x = hn::Mul(hn::Load(dd, pose.columns[0].data()), spread<0>(rows));
    const VD y = hn::Mul(hn::Load(dd, pose.columns[1].data()), spread<1>(rows));
    const VD z = hn::Mul(hn::Load(dd, pose.columns[2].data()), spread<2>(rows));
    return hn::Add(hn::Add(hn::Add(x, y), z), hn::Load(dd, pose.columns[3].data()));
}

template <class A, class B>
HWY_INLINE void load_rows(
    const FloatPairPose& pose, const A& a, const B& b, const std::uint32_t* candidates, Rows& to) {
    const Floats df;
    for (std::size_t k = 0; k < 4; ++k) {
        const Sides of_a = load_sides(a, candidates + k * candidate_step);
        hn::Store(of_a.first, df, to.p + k * lanes);
        hn::Store(of_a.second, df, to.q + k * lanes);
        const Sides of_b = load_sides(b, candidates + k * candidate_step + 1);
        hn::Store(of_b.first, df, to.e + k * lanes);
        hn::Store(of_b.second, df, to.f + k * lanes);
        hn::Store(narrowed(hn::Sub(of_a.corner_low, posed(pose, of_b.corner_low)),
                           hn::Sub(of_a.corner_high, posed(pose, of_b.corner_high))),
                  df,
                  to.d + k * lanes);
    }
}

#else

/// Loads the rows of one candidate.
template <class A, class B>
HWY_INLINE void load_row(const FloatPairPose& pose,
                         const A& a,
                         const B& b,
                         const std::uint32_t* candidate,
                         std::size_t at,
                         Rows& to) {
    const auto of_a = a.at(candidate[0]);
    const auto of_b = b.at(candidate[1]);
    const double x = static_cast<double>(of_b.x0[0]);
    const double y = static_cast<double>(of_b.x0[1]);
    const double z = static_cast<double>(of_b.x0[2]);
    const auto& columns = pose.columns;
    for (std::size_t i = 0; i < 3; ++i) {
        to.p[at + i] = static_cast<float>(of_a.x1[i] - of_a.x0[i]);
        to.q[at + i] = static_cast<float>(of_a.x2[i] - of_a.x0[i]);
        to.e[at + i] = static_cast<float>(of_b.x1[i] - of_b.x0[i]);
        to.f[at + i] = static_cast<float>(of_b.x2[i] - of_b.x0[i]);
        const double posed =
            columns[0][i] * x + columns[1][i] * y + columns[2][i] * z + columns[3][i];
        to.d[at + i] = static_cast<float>(static_cast<double>(of_a.x0[i]) - posed);
    }
    to.p[at + 3] = to.q[at + 3] = to.e[at + 3] = to.f[at + 3] = to.d[at + 3] = 0;
}

template <class A, class B>
HWY_INLINE void load_rows(
    const FloatPairPose& pose, const A& a, const B& b, const std::uint32_t* candidates, Rows& to) {
    for (std::size_t i = 0; i < lanes; ++i) {
        load_row(pose, a, b, candidates + i * candidate_step, 4 * i, to);
    }
}

#endif

/// Loads the error bounds of B's posed corners. Does nothing for blocks: one bound serves all.
template <class T>
HWY_INLINE void
load_errors(const FloatPairPose&, const BlockSource<T>&, const std::uint32_t*, Rows&) {}

HWY_INLINE void load_errors(const FloatPairPose& pose,
                            const MeshSource& b,
                            const std::uint32_t* candidates,
                            Rows& to) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const double* corner = b.at(candidates[i * candidate_step + 1]).x0;
        double reach = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = corner[k] < 0 ? -corner[k] : corner[k];
            reach = size > reach ? size : reach;
        }
        to.d_error[i] = static_cast<float>(pose.point_error_reach * reach + pose.point_error);
    }
}

/// Blocks are prefetched this many pairs ahead.
constexpr std::size_t prefetch_distance = 32;
/// Only every eighth candidate is prefetched: consecutive candidates share most blocks.
constexpr std::size_t prefetch_step = 8;

template <class T>
HWY_INLINE void prefetch(const BlockSource<T>& source, std::uint32_t place) {
    constexpr std::size_t line = 64;
    constexpr std::size_t usual_vertices = 20;
    const std::size_t block = place / 16;
    hwy::Prefetch(source.corners + 4 * 16 * block);
    const T* vertices = source.vertices + 3 * std::size_t{source.vertex_begin[block]};
    for (std::size_t i = 0; i < 3 * usual_vertices; i += line / sizeof(T)) {
        hwy::Prefetch(vertices + i);
    }
}

HWY_INLINE void prefetch(const MeshSource&, std::uint32_t) {}

/// Prefetches the blocks of one vector of candidates.
template <class A, class B>
HWY_INLINE void prefetch_blocks(const A& a, const B& b, const std::uint32_t* candidates) {
    for (std::size_t i = 0; i < lanes; i += prefetch_step) {
        prefetch(a, candidates[i * candidate_step]);
        prefetch(b, candidates[i * candidate_step + 1]);
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
