#include "common/tree/build_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Mean and covariance of all corners, up to a factor. A vertex counts once for each triangle that
/// uses it, as in Eberly, 3D Game Engine Design (2001), fitting points with a Gaussian.
Mat3 covariance(std::span<const BuildTriangle> triangles, std::span<const Vec3> vertices) {
    // Seen from one of the corners, the squares do not swamp the differences.
    const Vec3 origin = vertices[triangles.front().vertices[0]];
    Vec3 sum = Vec3::Zero();
    double xx = 0;
    double xy = 0;
    double xz = 0;
    double yy = 0;
    double yz = 0;
    double zz = 0;
    for (const BuildTriangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle.vertices) {
            const Vec3 d = vertices[vertex] - origin;
            sum += d;
            xx += d.x() * d.x();
            xy += d.x() * d.y();
            xz += d.x() * d.z();
            yy += d.y() * d.y();
            yz += d.y() * d.z();
            zz += d.z() * d.z();
        }
    }
    const Vec3 mean = sum / (3.0 * static_cast<double>(triangles.size()));
    Mat3 result;
    result << xx - sum.x() * mean.x(), xy - sum.x() * mean.y(), xz - sum.x() * mean.z(), //
        xy - sum.x() * mean.y(), yy - sum.y() * mean.y(), yz - sum.y() * mean.z(),       //
        xz - sum.x() * mean.z(), yz - sum.y() * mean.z(), zz - sum.z() * mean.z();
    return result;
}

struct EigenSystem {
    Vec3 values;
    Mat3 vectors; ///< Columns.
};

/// Turns rows and columns p and q so that the entry between them vanishes.
void jacobi_rotate(Mat3& m, Mat3& vectors, int p, int q) {
    if (m(p, q) == 0) {
        return;
    }
    const double theta = (m(q, q) - m(p, p)) / (2 * m(p, q));
    const double t = (theta < 0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1);
    const double s = t * c;
    const int r = 3 - p - q;
    const double mpq = m(p, q);
    const double mpr = m(p, r);
    const double mqr = m(q, r);
    m(p, p) -= t * mpq;
    m(q, q) += t * mpq;
    m(p, q) = m(q, p) = 0;
    m(p, r) = m(r, p) = c * mpr - s * mqr;
    m(q, r) = m(r, q) = s * mpr + c * mqr;
    for (int k = 0; k < 3; ++k) {
        const double vp = vectors(k, p);
        const double vq = vectors(k, q);
        vectors(k, p) = c * vp - s * vq;
        vectors(k, q) = s * vp + c * vq;
    }
}

/// Cyclic Jacobi (Golub and Van Loan, Matrix Computations, 8.5), of plain operations and square
/// roots alone, so that every host gets the same bits.
EigenSystem eigen_symmetric(Mat3 m) {
    Mat3 vectors = Mat3::Identity();
    // It converges quadratically: more than 6 sweeps are not seen, and the bound keeps NaN finite.
    for (int sweep = 0; sweep < 12; ++sweep) {
        const double off = std::abs(m(0, 1)) + std::abs(m(0, 2)) + std::abs(m(1, 2));
        const double diagonal = std::abs(m(0, 0)) + std::abs(m(1, 1)) + std::abs(m(2, 2));
        // A frame this near is as good: it will be rounded to floats.
        if (off <= 0x1p-30 * diagonal) {
            break;
        }
        jacobi_rotate(m, vectors, 0, 1);
        jacobi_rotate(m, vectors, 0, 2);
        jacobi_rotate(m, vectors, 1, 2);
    }
    return {m.diagonal(), vectors};
}

bool is_orthonormal(const std::array<float, 9>& axes) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            double dot = i == j ? -1.0 : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                dot += static_cast<double>(axes[3 * i + k]) * static_cast<double>(axes[3 * j + k]);
            }
            // A little less than the bound, for the roundings of this sum. NaN fails, too.
            if (!(std::abs(dot) <= axes_error_max - 0x1p-40)) {
                return false;
            }
        }
    }
    return true;
}

/// A float that is at least `value` and a normal number, or infinity.
float round_up(double value) {
    // Rounding to nearest takes away at most 2^-24 of it.
    const double grown = value * (1 + 0x1p-23);
    const auto floor = static_cast<double>(std::numeric_limits<float>::min());
    const auto ceiling = static_cast<double>(std::numeric_limits<float>::max());
    if (!(grown < ceiling)) {
        return std::numeric_limits<float>::infinity();
    }
    return static_cast<float>(std::max(grown, floor));
}

} // namespace

std::array<float, 9> fit_axes(std::span<const BuildTriangle> triangles,
                              std::span<const Vec3> vertices) {
    Mat3 m = covariance(triangles, vertices);
    const double largest = m.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest)) {
        return body_axes;
    }
    m /= largest;
    const EigenSystem eigen = eigen_symmetric(m);

    std::array<int, 3> order = {0, 1, 2};
    const auto swap_if_wider = [&](std::size_t i, std::size_t j) {
        if (eigen.values[order[j]] < eigen.values[order[i]]) {
            std::swap(order[i], order[j]);
        }
    };
    swap_if_wider(0, 1);
    swap_if_wider(1, 2);
    swap_if_wider(0, 1);

    std::array<float, 9> axes{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            axes[3 * i + k] = static_cast<float>(eigen.vectors(static_cast<int>(k), order[i]));
        }
    }
    return is_orthonormal(axes) ? axes : body_axes;
}

void set_unbounded_box(ObbNode& node) {
    node.axes = body_axes;
    node.center.fill(0);
    node.half.fill(std::numeric_limits<float>::infinity());
}

void project(std::span<const BuildTriangle> triangles,
             std::span<const Vec3> vertices,
             const std::array<float, 9>& axes,
             Projections& out) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 9> f{};
    std::copy(axes.begin(), axes.end(), f.begin());
    out.origin = vertices[triangles.front().vertices[0]];
    out.whole.fill({infinity, -infinity});
    for (auto& intervals : out.triangles) {
        intervals.resize(triangles.size());
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::array<Interval, 3> own;
        own.fill({infinity, -infinity});
        for (const std::uint32_t vertex : triangles[i].vertices) {
            const Vec3 d = vertices[vertex] - out.origin;
            for (std::size_t k = 0; k < 3; ++k) {
                const double p = f[3 * k] * d.x() + f[3 * k + 1] * d.y() + f[3 * k + 2] * d.z();
                own[k].low = std::min(own[k].low, p);
                own[k].high = std::max(own[k].high, p);
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            out.triangles[k][i] = own[k];
            out.whole[k].low = std::min(out.whole[k].low, own[k].low);
            out.whole[k].high = std::max(out.whole[k].high, own[k].high);
        }
    }
}

void set_box(const Projections& projections, ObbNode& node) {
    std::array<double, 9> f{};
    std::copy(node.axes.begin(), node.axes.end(), f.begin());
    std::array<double, 3> middle{};
    double reach = 0; // The sum over the axes of the largest |projection|.
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval& whole = projections.whole[k];
        middle[k] = 0.5 * whole.low + 0.5 * whole.high;
        reach += std::max(std::abs(whole.low), std::abs(whole.high));
    }
    // The rows are their own inverse but for rounding, which the last step makes good.
    for (std::size_t k = 0; k < 3; ++k) {
        const double offset = f[k] * middle[0] + f[3 + k] * middle[1] + f[6 + k] * middle[2];
        node.center[k] = projections.origin[static_cast<int>(k)] + offset;
    }

    // With o the origin, x a vertex and c the centre (all doubles, exact numbers), what must be
    // bounded is row.(x - c) = row.(x - o) - row.(c - o).
    // - p = fl(row.fl(x - o)): the difference and the product round once each, the two sums once,
    // so
    //   it errs by at most 4.01 u S, S = sum |row_k| |x_k - o_k| <= |row| |x - o|. The rows are
    //   orthonormal within axes_error_max, so |row| and |x - o| are at most 1.001 and 1.001 times
    //   the length of the exact projections, which is at most 1.001 reach: 5 u reach.
    // - q, with c in place of x: |c - o| <= 1.01 reach, as c is made from the middles with an error
    //   of some u (reach + |c|), and fl(c - o) is as exact as that of the vertices: 5 u reach.
    //   The size of |c| plays no part: c is whatever double was stored, and q is measured from it.
    //   If |c| is so much larger than reach that rounding c moved it further, q sees that: |c - o|
    //   enters through `reach_of_center`.
    // - fl(high - q), fl(q - low): 1 u of at most 2 (reach + |q|).
    // Together at most 16 u (reach + reach_of_center). Underflow is below round_up's floor.
    std::array<double, 3> offset{};
    for (std::size_t k = 0; k < 3; ++k) {
        offset[k] = node.center[k] - projections.origin[static_cast<int>(k)];
    }
    const double reach_of_center = std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
    const double error = 16 * unit_roundoff * (reach + reach_of_center);
    for (std::size_t k = 0; k < 3; ++k) {
        const double q = f[3 * k] * offset[0] + f[3 * k + 1] * offset[1] + f[3 * k + 2] * offset[2];
        const Interval& whole = projections.whole[k];
        node.half[k] = round_up(std::max(whole.high - q, q - whole.low) + error);
    }
}

} // namespace cd
