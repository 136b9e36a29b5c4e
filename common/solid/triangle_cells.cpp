#include "common/solid/triangle_cells.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// A convex polygon with its corners counter-clockwise.
using Polygon = std::vector<PlanePoint>;

/// Returns twice the signed area of p, q, x: positive where `x` lies to the left of the ray from
/// `p` to `q`.
Rational left_of(const PlanePoint& p, const PlanePoint& q, const PlanePoint& x) {
    return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
}

/// Returns true when some point of the cut lies in the polygon's interior.
bool enters(const PlaneCut& cut, const Polygon& polygon) {
    // [begin, end] is the parameter range of the cut, within 0 to 1, that is left of all edges. A
    // bound that an edge sets is excluded.
    Rational begin = 0;
    Rational end = 1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PlanePoint& p = polygon[i];
        const PlanePoint& q = polygon[(i + 1) % polygon.size()];
        const Rational from = left_of(p, q, cut.from);
        const Rational to = left_of(p, q, cut.to);
        if (from <= 0 && to <= 0) {
            return false;
        }
        if (from <= 0) {
            begin = std::max<Rational>(begin, from / (from - to));
        } else if (to <= 0) {
            end = std::min<Rational>(end, from / (from - to));
        }
        if (begin >= end) {
            return false;
        }
    }
    return true;
}

/// Returns the part of the polygon to the left of the line from `p` to `q`.
Polygon left_part(const Polygon& polygon, const PlanePoint& p, const PlanePoint& q) {
    Polygon part;
    std::vector<Rational> sides;
    sides.reserve(polygon.size());
    for (const PlanePoint& corner : polygon) {
        sides.push_back(left_of(p, q, corner));
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        if (sides[i] >= 0) {
            part.push_back(polygon[i]);
        }
        if (sides[i].sign() * sides[next].sign() < 0) {
            const Rational t = sides[i] / (sides[i] - sides[next]);
            part.push_back({polygon[i][0] + t * (polygon[next][0] - polygon[i][0]),
                            polygon[i][1] + t * (polygon[next][1] - polygon[i][1])});
        }
    }
    return part;
}

PlanePoint centre_of(const Polygon& polygon) {
    PlanePoint sum;
    for (const PlanePoint& corner : polygon) {
        sum[0] += corner[0];
        sum[1] += corner[1];
    }
    const Rational count = polygon.size();
    return {sum[0] / count, sum[1] / count};
}

struct Cell {
    Polygon polygon;
    std::vector<std::size_t> cuts; ///< Cuts that may enter the polygon, last first.
};

} // namespace

Rational to_rational(const Dyadic& value) {
    using Integer = boost::multiprecision::cpp_int;
    const Integer mantissa(value.mantissa);
    return value.exponent >= 0 ? Rational(Integer(mantissa << value.exponent))
                               : Rational(mantissa, Integer(Integer(1) << -value.exponent));
}

bool any_cell_centre(const std::array<PlanePoint, 3>& triangle,
                     std::span<const PlaneCut> cuts,
                     const std::function<bool(const PlanePoint&)>& question) {
    Cell whole{{triangle.begin(), triangle.end()}, {}};
    if (left_of(triangle[0], triangle[1], triangle[2]) < 0) {
        std::swap(whole.polygon[1], whole.polygon[2]);
    }
    for (std::size_t i = cuts.size(); i > 0; --i) {
        whole.cuts.push_back(i - 1);
    }
    std::vector<Cell> waiting{std::move(whole)};
    while (!waiting.empty()) {
        Cell cell = std::move(waiting.back());
        waiting.pop_back();
        while (!cell.cuts.empty() && !enters(cuts[cell.cuts.back()], cell.polygon)) {
            cell.cuts.pop_back();
        }
        if (cell.cuts.empty()) {
            if (question(centre_of(cell.polygon))) {
                return true;
            }
            continue;
        }
        const PlaneCut& cut = cuts[cell.cuts.back()];
        cell.cuts.pop_back();
        // A point in the interior differs from corner 0, so the line through both splits the cell.
        const PlanePoint& to = cut.from == cut.to ? cell.polygon[0] : cut.to;
        waiting.push_back({left_part(cell.polygon, cut.from, to), cell.cuts});
        waiting.push_back({left_part(cell.polygon, to, cut.from), std::move(cell.cuts)});
    }
    return false;
}

bool any_piece_centre(std::vector<Rational> cuts,
                      const std::function<bool(const Rational&)>& question) {
    cuts.emplace_back(0);
    cuts.emplace_back(1);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i - 1] < cuts[i] && question((cuts[i - 1] + cuts[i]) / 2)) {
            return true;
        }
    }
    return false;
}

} // namespace cd
