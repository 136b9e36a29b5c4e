#include "common/tree/build/build_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Returns the covariance of the points up to a factor.
SymmetricMatrix covariance(const Moments& moments) {
    const Vec3& sum = moments.sum;
    const Vec3 mean = sum / static_cast<double>(moments.corners);
    const SymmetricMatrix& m = moments.products;
    return {m[0] - sum.x() * mean.x(),
            m[1] - sum.x() * mean.y(),
            m[2] - sum.x() * mean.z(),
            m[3] - sum.y() * mean.y(),
            m[4] - sum.y() * mean.z(),
            m[5] - sum.z() * mean.z()};
}

bool is_orthonormal(const std::array<float, 9>& axes) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            double dot = i == j ? -1.0 : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                dot += static_cast<double>(axes[3 * i + k]) * static_cast<double>(axes[3 * j + k]);
            }
            // The limit is a little less than the bound, to allow for the roundings of this sum.
            // NaN fails, too.
            if (!(std::abs(dot) <= axes_error_max - 0x1p-40)) {
                return false;
            }
        }
    }
    return true;
}

/// Returns a float that is at least `value` and either a normal number or infinity.
float round_up(double value) {
    // Rounding to nearest loses at most 2^-24 of the value.
    const double grown = value * (1 + 0x1p-23);
    const auto floor = static_cast<double>(std::numeric_limits<float>::min());
    const auto ceiling = static_cast<double>(std::numeric_limits<float>::max());
    if (!(grown < ceiling)) {
        return std::numeric_limits<float>::infinity();
    }
    return static_cast<float>(std::max(grown, floor));
}

} // namespace

Moments& Moments::operator+=(const Moments& other) {
    sum += other.sum;
    for (std::size_t i = 0; i < products.size(); ++i) {
        products[i] += other.products[i];
    }
    corners += other.corners;
    return *this;
}

Moments sum_moments(std::span<const BuildTriangle> triangles,
                    std::span<const Vec3> vertices,
                    const Vec3& origin) {
    Moments all;
    all.corners = 3 * triangles.size();
    for (const BuildTriangle& triangle : triangles) {
        const Vec3 a = vertices[triangle.vertices[0]] - origin;
        const Vec3 b = vertices[triangle.vertices[1]] - origin;
        const Vec3 c = vertices[triangle.vertices[2]] - origin;
        // Summing within a triangle first shortens the dependency chain of additions over all
        // triangles.
        const auto product = [&](int i, int k) { return a[i] * a[k] + b[i] * b[k] + c[i] * c[k]; };
        all.sum += a + b + c;
        all.products[0] += product(0, 0);
        all.products[1] += product(0, 1);
        all.products[2] += product(0, 2);
        all.products[3] += product(1, 1);
        all.products[4] += product(1, 2);
        all.products[5] += product(2, 2);
    }
    return all;
}

std::vector<std::array<float, 9>> fit_axes(std::span<const Moments> nodes) {
    std::vector<SymmetricMatrix> covariances;
    covariances.reserve(nodes.size());
    for (const Moments& node : nodes) {
        covariances.push_back(covariance(node));
    }
    std::vector<Directions> directions(nodes.size());
    principal_directions(covariances, directions);
    std::vector<std::array<float, 9>> fitted;
    fitted.reserve(nodes.size());
    for (const Directions& rows : directions) {
        std::array<float, 9> axes{};
        for (std::size_t i = 0; i < 9; ++i) {
            axes[i] = static_cast<float>(rows[i / 3][static_cast<int>(i % 3)]);
        }
        fitted.push_back(is_orthonormal(axes) ? axes : body_axes);
    }
    return fitted;
}

void set_unbounded_box(ObbNode& node) {
    node.axes = body_axes;
    node.center.fill(0);
    node.half.fill(std::numeric_limits<float>::infinity());
}

Projection empty_projection() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Projection none;
    none.fill({infinity, -infinity});
    return none;
}

void extend(Projection& whole, const Projection& part) {
    for (std::size_t k = 0; k < 3; ++k) {
        whole[k].low = std::min(whole[k].low, part[k].low);
        whole[k].high = std::max(whole[k].high, part[k].high);
    }
}

Projection project(std::span<const BuildTriangle> triangles,
                   std::span<const Vec3> vertices,
                   const Vec3& origin,
                   const std::array<float, 9>& axes,
                   std::span<Projection> out) {
    std::array<double, 9> f{};
    std::copy(axes.begin(), axes.end(), f.begin());
    Projection whole = empty_projection();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Vec3 a = vertices[triangles[i].vertices[0]] - origin;
        const Vec3 b = vertices[triangles[i].vertices[1]] - origin;
        const Vec3 c = vertices[triangles[i].vertices[2]] - origin;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto along = [&](const Vec3& d) {
                return f[3 * k] * d.x() + f[3 * k + 1] * d.y() + f[3 * k + 2] * d.z();
            };
            const double pa = along(a);
            const double pb = along(b);
            const double pc = along(c);
            out[i][k] = {std::min(std::min(pa, pb), pc), std::max(std::max(pa, pb), pc)};
        }
        extend(whole, out[i]);
    }
    return whole;
}

void set_box(const Projection& whole, const Vec3& origin, ObbNode& node) {
    std::array<double, 9> f{};
    std::copy(node.axes.begin(), node.axes.end(), f.begin());
    std::array<double, 3> middle{};
    double reach = 0; // Sum over the axes of the largest |projection|.
    for (std::size_t k = 0; k < 3; ++k) {
        middle[k] = 0.5 * whole[k].low + 0.5 * whole[k].high;
        reach += std::max(std::abs(whole[k].low), std::abs(whole[k].high));
    }
    // Up to rounding, the transpose of the rows is their inverse. The half sizes are measured from
    // the rounded centre and so make up for the rounding.
    for (std::size_t k = 0; k < 3; ++k) {
        const double offset = f[k] * middle[0] + f[3 + k] * middle[1] + f[6 + k] * middle[2];
        node.center[k] = origin[static_cast<int>(k)] + offset;
    }

    // Let o be the origin, x a vertex and c the centre, all doubles taken as exact numbers. The
    // quantity to bound is row.(x - c) = row.(x - o) - row.(c - o).
    // - p = fl(row.fl(x - o)): difference and product round once each, the two sums once, so
    //   p errs by at most 4.01 u S, S = sum |row_k| |x_k - o_k| <= |row| |x - o|. The rows are
    //   orthonormal within axes_error_max, so |row| and |x - o| are at most 1.001 and 1.001 times
    //   the length of the exact projections, which is at most 1.001 reach: 5 u reach.
    // - q, with c in place of x: |c - o| <= 1.01 reach, as c is made from the middles with an error
    //   of some u (reach + |c|), and fl(c - o) is as exact as that of the vertices: 5 u reach.
    //   The size of |c| plays no part: c is whatever double was stored, and q is measured from c.
    //   If |c| is so much larger than reach that rounding c moved it further, |c - o| enters the
    //   bound through `reach_of_center`.
    // - fl(high - q), fl(q - low): 1 u of at most 2 (reach + |q|).
    // Together at most 16 u (reach + reach_of_center). Underflow is below round_up's floor.
    std::array<double, 3> offset{};
    for (std::size_t k = 0; k < 3; ++k) {
        offset[k] = node.center[k] - origin[static_cast<int>(k)];
    }
    const double reach_of_center = std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
    const double error = 16 * unit_roundoff * (reach + reach_of_center);
    for (std::size_t k = 0; k < 3; ++k) {
        const double q = f[3 * k] * offset[0] + f[3 * k + 1] * offset[1] + f[3 * k + 2] * offset[2];
        node.half[k] = round_up(std::max(whole[k].high - q, q - whole[k].low) + error);
    }
}

} // namespace cd
