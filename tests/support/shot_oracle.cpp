#include "tests/support/shot_oracle.hpp"

#include "tests/support/distance_oracle.hpp"
#include "tests/support/exact_world.hpp"
#include "tests/support/oracle.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cd::tests {

namespace {

/// A triangle and a segment in integers.
struct ShotWorld {
    ExactTriangle t;
    ExactPoint p;
    ExactPoint q;

    [[nodiscard]] ExactPoint d() const { return minus(q, p); }
    [[nodiscard]] Integer side(const ExactPoint& x) const {
        return dot(normal_of(t), minus(x, t[0]));
    }
};

ShotWorld world_of(const Corners& a, const Segment& line, const PosePair& poses) {
    const std::array<Vec3, 2> ends{line.p, line.q};
    const ExactWorld world = exact_world(a, ends, poses);
    return {{world.a[0], world.a[1], world.a[2]}, world.b[0], world.b[1]};
}

/// Returns a number of which 1 / number is a sufficiently small eps. Let c bound the coordinates. A
/// side of an edge is a polynomial in eps with integers of at most 96 c^2 behind the constant term.
/// So the first of its numbers that is not 0 decides once eps is below 1 / (96 c^2 + 1).
Integer inverse_eps(const ShotWorld& w) {
    Integer largest = 1;
    const auto see = [&](const ExactPoint& x) {
        for (const Integer& coordinate : x) {
            largest = std::max(largest, Integer(abs(coordinate)));
        }
    };
    std::for_each(w.t.begin(), w.t.end(), see);
    see(w.p);
    see(w.q);
    return 128 * largest * largest + 1;
}

/// Moves the segment by (eps, eps^2, eps^3) and tests whether its line then meets the inside of the
/// triangle. All numbers are scaled by eps^-3.
bool passes_inside_when_moved(const ShotWorld& w) {
    const Integer k = inverse_eps(w);
    const Integer scale = k * k * k;
    ShotWorld moved = w;
    for (std::size_t i = 0; i < 3; ++i) {
        for (ExactPoint* x : {&moved.t[0], &moved.t[1], &moved.t[2], &moved.p, &moved.q}) {
            (*x)[i] *= scale;
        }
    }
    const ExactPoint by{k * k, k, 1};
    for (std::size_t i = 0; i < 3; ++i) {
        moved.p[i] += by[i];
        moved.q[i] += by[i];
    }
    // The line meets the plane at p + d * share / weight.
    const ExactPoint n = normal_of(moved.t);
    const ExactPoint d = moved.d();
    const Integer weight = dot(n, d);
    const Integer share = -moved.side(moved.p);
    ExactPoint x;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = moved.p[i] * weight + d[i] * share;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const ExactPoint& from = moved.t[i];
        const ExactPoint edge = minus(moved.t[(i + 1) % 3], from);
        const ExactPoint apart{
            x[0] - weight * from[0], x[1] - weight * from[1], x[2] - weight * from[2]};
        if (sgn(dot(n, cross(edge, apart))) * sgn(weight) <= 0) {
            return false;
        }
    }
    return true;
}

bool crosses(const ShotWorld& w) {
    const int p = sgn(w.side(w.p));
    const int q = sgn(w.side(w.q));
    const bool passes = p * q < 0 || (p == 0 && q != 0);
    return passes && passes_inside_when_moved(w);
}

/// Returns the share of the segment before a point of it.
mpq_class share_of(const ShotWorld& w, const WeightedPoint& x) {
    const ExactPoint d = w.d();
    if (is_zero(d)) {
        return 0;
    }
    mpq_class share(dot(x.p, d) - x.weight * dot(w.p, d), x.weight * dot(d, d));
    share.canonicalize();
    return share;
}

bool is_at(const WeightedPoint& x, const ExactPoint& corner) {
    return x.p[0] == corner[0] * x.weight && x.p[1] == corner[1] * x.weight &&
           x.p[2] == corner[2] * x.weight;
}

/// Tests whether a point of the triangle is on its border.
bool is_on_border(const ExactTriangle& t, const WeightedPoint& x) {
    const ExactPoint n = normal_of(t);
    if (is_zero(n)) {
        return true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const ExactPoint aside = cross(n, minus(t[(i + 1) % 3], t[i]));
        if (dot(aside, x.p) == x.weight * dot(aside, t[i])) {
            return true;
        }
    }
    return false;
}

std::uint8_t flags_at(const ShotWorld& w, const WeightedPoint& x) {
    std::uint8_t flags = 0;
    const int facing = sgn(dot(normal_of(w.t), w.d()));
    flags |= facing > 0 ? hit_flag::back : facing < 0 ? hit_flag::front : 0;
    if (std::any_of(w.t.begin(), w.t.end(), [&](const auto& c) { return is_at(x, c); })) {
        flags |= hit_flag::corner;
    } else if (is_on_border(w.t, x)) {
        flags |= hit_flag::edge;
    }
    return flags | (crosses(w) ? hit_flag::crosses : 0);
}

int order_of(const OracleHit& hit) {
    return (hit.flags & hit_flag::back) != 0 ? 0 : (hit.flags & hit_flag::front) != 0 ? 1 : 2;
}

} // namespace

std::optional<OracleHit> oracle_hit(const Corners& a, const Segment& line, const PosePair& poses) {
    const ShotWorld w = world_of(a, line, poses);
    const std::vector<WeightedPoint> shared = shared_corners(w.t, {w.p, w.q, w.q});
    if (shared.empty()) {
        return std::nullopt;
    }
    const auto first =
        std::min_element(shared.begin(), shared.end(), [&](const auto& l, const auto& r) {
            return share_of(w, l) < share_of(w, r);
        });
    return OracleHit{0, flags_at(w, *first), share_of(w, *first)};
}

std::vector<OracleHit>
oracle_hits(std::span<const Corners> a, const Segment& line, const PosePair& poses) {
    std::vector<OracleHit> hits;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (auto hit = oracle_hit(a[i], line, poses)) {
            hit->triangle = static_cast<std::uint32_t>(i);
            hits.push_back(*std::move(hit));
        }
    }
    std::sort(hits.begin(), hits.end(), [](const OracleHit& l, const OracleHit& r) {
        const int order = cmp(l.lambda, r.lambda);
        return order != 0 ? order < 0
                          : std::pair(order_of(l), l.triangle) < std::pair(order_of(r), r.triangle);
    });
    return hits;
}

double oracle_length(const Segment& line) {
    mpq_class square = 0;
    for (int k = 0; k < 3; ++k) {
        const mpq_class d = mpq_class(line.q[k]) - mpq_class(line.p[k]);
        square += d * d;
    }
    return oracle_nearest_root(square);
}

std::vector<LineHit> rounded_hits(std::span<const OracleHit> hits, const Segment& line) {
    const mpq_class length(oracle_length(line));
    std::vector<LineHit> rounded;
    int rank = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const double depth = oracle_nearest(hits[i].lambda * length);
        if (i == 0 || depth != rounded.back().depth) {
            rank = 0;
        } else if (hits[i].lambda != hits[i - 1].lambda) {
            ++rank;
        }
        rounded.push_back({hits[i].triangle,
                           hits[i].flags,
                           static_cast<std::uint8_t>(std::min<int>(rank, hit_rank_most)),
                           depth});
    }
    return rounded;
}

} // namespace cd::tests
