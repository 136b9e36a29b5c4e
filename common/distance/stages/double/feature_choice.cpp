#include "common/distance/stages/double/feature_choice.hpp"

#include "common/distance/nearest_points.hpp"

#include <Eigen/Geometry>

#include <limits>

namespace cd {

namespace {

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

/// Returns the quotient, limited to [0, 1]; 0 if the divisor is 0.
double share_of(double dividend, double divisor) {
    const double share = dividend / divisor;
    return share > 0 ? (share < 1 ? share : 1) : 0;
}

/// A point of an edge as a corner or as the edge's interior.
struct OnEdge {
    bool is_corner;
    std::size_t corner;

    OnEdge(std::size_t edge, double share)
        : is_corner(share == 0 || share == 1), corner(share == 1 ? next(edge) : edge) {}
};

class Choice {
  public:
    explicit Choice(const std::array<Vec3, 6>& corners) : corners_(corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            u_[k] = corners[next(k)] - corners[k];
            v_[k] = corners[3 + next(k)] - corners[3 + k];
            uu_[k] = u_[k].squaredNorm();
            vv_[k] = v_[k].squaredNorm();
        }
    }

    [[nodiscard]] std::size_t best() {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                try_edges(i, j);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            try_face(corners_[i], corners_.data() + 3, v_, feature::corner_face + i);
            try_face(corners_[3 + i], corners_.data(), u_, feature::face_corner + i);
        }
        return best_;
    }

  private:
    void keep_lesser(double square, std::size_t number) {
        if (square < least_) {
            least_ = square;
            best_ = number;
        }
    }

    /// Finds the nearest points of two segments as Ericson, Real-Time Collision Detection (2004),
    /// section 5.1.9.
    void try_edges(std::size_t i, std::size_t j) {
        const Vec3 w = corners_[i] - corners_[3 + j];
        const double uv = u_[i].dot(v_[j]);
        const double wu = w.dot(u_[i]);
        const double wv = w.dot(v_[j]);
        const double area = uu_[i] * vv_[j] - uv * uv;
        const double first = share_of(uv * wv - vv_[j] * wu, area);
        const double t = share_of(first * uv + wv, vv_[j]);
        const double s = share_of(t * uv - wu, uu_[i]);
        keep_lesser((w + s * u_[i] - t * v_[j]).squaredNorm(), number_of(i, s, j, t));
    }

    static std::size_t number_of(std::size_t i, double s, std::size_t j, double t) {
        const OnEdge a(i, s);
        const OnEdge b(j, t);
        if (a.is_corner) {
            return b.is_corner ? feature::corner_corner + 3 * a.corner + b.corner
                               : feature::corner_edge + 3 * a.corner + j;
        }
        return b.is_corner ? feature::edge_corner + 3 * i + b.corner
                           : feature::edge_edge + 3 * i + j;
    }

    void try_face(const Vec3& p,
                  const Vec3* face,
                  const std::array<Vec3, 3>& edges,
                  std::size_t number) {
        const Vec3 normal = edges[0].cross(edges[1]);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(normal.dot(edges[k].cross(p - face[k])) > 0)) {
                return;
            }
        }
        const double height = normal.dot(p - face[0]);
        keep_lesser(height * height / normal.squaredNorm(), number);
    }

    const std::array<Vec3, 6>& corners_;
    std::array<Vec3, 3> u_; ///< Edges of A.
    std::array<Vec3, 3> v_; ///< Edges of B.
    std::array<double, 3> uu_{};
    std::array<double, 3> vv_{};
    double least_ = std::numeric_limits<double>::infinity();
    std::size_t best_ = 0;
};

} // namespace

std::size_t likely_feature(const std::array<Vec3, 6>& corners) {
    return Choice(corners).best();
}

} // namespace cd
