// The features of two triangles with integer corners: which have nearest points, how far apart
// these are, and where.
#pragma once

#include "common/distance/nearest_points.hpp"
#include "common/pair/numbers/exact_lattice.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// The square n / d of a distance in units of the pair's lattice; d > 0.
struct ExactSquare {
    ExactInt n = 0;
    ExactInt d = 1;
};

/// The point x / w in units of the pair's lattice; w > 0.
struct ExactPlace {
    ExactVec x;
    ExactInt w = 1;
};

/// Computes the features of one pair. A feature is valid if its nearest points are unique and lie
/// in the relative interiors of its corner, edge or face; a nearest point on a border is that of an
/// earlier feature. The least distance of triangles that share no point is that of a valid feature.
///
/// With u_i and v_j for the edges of A and B, and w_ij = a_i - b_j, all conditions and denominators
/// are polynomials in scalar products of these.
class ExactFeatures {
  public:
    explicit ExactFeatures(const std::array<ExactVec, 6>& corners);

    /// Returns a feature's squared distance; nothing if the feature is not valid.
    [[nodiscard]] std::optional<ExactSquare> square(std::size_t number) const;
    /// Returns the least squared distance of all valid features.
    [[nodiscard]] ExactSquare least() const;
    /// Returns the nearest points, on A and on B, of a valid feature.
    [[nodiscard]] std::array<ExactPlace, 2> places(std::size_t number) const;

  private:
    using Row = std::array<ExactInt, 3>;

    [[nodiscard]] std::optional<ExactSquare> corner_edge(std::size_t i, std::size_t j) const;
    [[nodiscard]] std::optional<ExactSquare> edge_corner(std::size_t i, std::size_t j) const;
    [[nodiscard]] std::optional<ExactSquare> corner_face(std::size_t i) const;
    [[nodiscard]] std::optional<ExactSquare> face_corner(std::size_t j) const;
    [[nodiscard]] std::optional<ExactSquare> edge_edge(std::size_t i, std::size_t j) const;

    /// The edges of a triangle and their products.
    struct Edges {
        std::array<ExactVec, 3> along; ///< From corner k to the next.
        Row square;                    ///< along[k] . along[k].
        Row turn;                      ///< along[k] . along[k + 1].
        ExactVec normal;               ///< along[0] x along[1].
        ExactInt area;                 ///< normal . normal.

        explicit Edges(const ExactVec* corners);
    };

    const std::array<ExactVec, 6>& corners_;
    Edges a_;
    Edges b_;
    std::array<std::array<ExactVec, 3>, 3> w_;
    std::array<Row, 3> wu_; ///< w_ij . u_i
    std::array<Row, 3> wv_; ///< w_ij . v_j
};

} // namespace cd
