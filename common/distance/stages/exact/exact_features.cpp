#include "common/distance/stages/exact/exact_features.hpp"

#include "common/pair/numbers/exact_vectors.hpp"

#include <utility>

namespace cd {

namespace {

using exact_vectors::cross;
using exact_vectors::dot;
using exact_vectors::minus;

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

/// Returns (p w + direction by) / w.
ExactPlace
moved(const ExactVec& p, const ExactInt& w, const ExactVec& direction, const ExactInt& by) {
    ExactPlace place;
    for (std::size_t k = 0; k < 3; ++k) {
        place.x[k] = p[k] * w + direction[k] * by;
    }
    place.w = w;
    return place;
}

bool is_inside(const ExactInt& place, const ExactInt& length) {
    return place > 0 && place < length;
}

/// Squares the height of w over the line along an edge: |w x e|^2 / e.e, by Lagrange's identity.
ExactSquare height_over_edge(const ExactInt& ww, const ExactInt& we, const ExactInt& ee) {
    return {ww * ee - we * we, ee};
}

ExactSquare height(const ExactVec& w, const ExactVec& normal, const ExactInt& square) {
    const ExactInt along = dot(w, normal);
    return {along * along, square};
}

} // namespace

ExactFeatures::Edges::Edges(const ExactVec* corners) {
    for (std::size_t k = 0; k < 3; ++k) {
        along[k] = minus(corners[next(k)], corners[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        square[k] = dot(along[k], along[k]);
        turn[k] = dot(along[k], along[next(k)]);
    }
    normal = cross(along[0], along[1]);
    area = dot(normal, normal);
}

ExactFeatures::ExactFeatures(const std::array<ExactVec, 6>& corners)
    : corners_(corners), a_(corners.data()), b_(corners.data() + 3) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            w_[i][j] = minus(corners[i], corners[3 + j]);
            wu_[i][j] = dot(w_[i][j], a_.along[i]);
            wv_[i][j] = dot(w_[i][j], b_.along[j]);
        }
    }
}

std::optional<ExactSquare> ExactFeatures::corner_edge(std::size_t i, std::size_t j) const {
    if (!is_inside(wv_[i][j], b_.square[j])) {
        return std::nullopt;
    }
    return height_over_edge(dot(w_[i][j], w_[i][j]), wv_[i][j], b_.square[j]);
}

std::optional<ExactSquare> ExactFeatures::edge_corner(std::size_t i, std::size_t j) const {
    if (!is_inside(-wu_[i][j], a_.square[i])) {
        return std::nullopt;
    }
    return height_over_edge(dot(w_[i][j], w_[i][j]), wu_[i][j], a_.square[i]);
}

/// The side of a corner p against edge k of a face with normal n is n . (e_k x w_k) with w_k = p -
/// f_k. As n = e_k x e_k+1, and w_k = w_k+1 + e_k, that is (e_k . e_k)(e_k+1 . w_k) - (e_k . w_k)
/// (e_k . e_k+1) with e_k+1 . w_k = e_k+1 . w_k+1 + e_k . e_k+1.
std::optional<ExactSquare> ExactFeatures::corner_face(std::size_t i) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const ExactInt ahead = wv_[i][next(k)] + b_.turn[k];
        if (b_.square[k] * ahead <= wv_[i][k] * b_.turn[k]) {
            return std::nullopt;
        }
    }
    return b_.area == 0 ? std::nullopt : std::optional(height(w_[i][0], b_.normal, b_.area));
}

/// Here w_k = p - f_k is -w_kj.
std::optional<ExactSquare> ExactFeatures::face_corner(std::size_t j) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const ExactInt ahead = a_.turn[k] - wu_[next(k)][j];
        if (a_.square[k] * ahead <= -wu_[k][j] * a_.turn[k]) {
            return std::nullopt;
        }
    }
    return a_.area == 0 ? std::nullopt : std::optional(height(w_[0][j], a_.normal, a_.area));
}

std::optional<ExactSquare> ExactFeatures::edge_edge(std::size_t i, std::size_t j) const {
    const ExactInt uv = dot(a_.along[i], b_.along[j]);
    const ExactInt cc = a_.square[i] * b_.square[j] - uv * uv;
    if (!is_inside(uv * wv_[i][j] - b_.square[j] * wu_[i][j], cc) ||
        !is_inside(a_.square[i] * wv_[i][j] - uv * wu_[i][j], cc)) {
        return std::nullopt;
    }
    return height(w_[i][j], cross(a_.along[i], b_.along[j]), cc);
}

std::optional<ExactSquare> ExactFeatures::square(std::size_t number) const {
    if (number < feature::corner_edge) {
        const ExactVec& w = w_[number / 3][number % 3];
        return ExactSquare{dot(w, w), 1};
    }
    if (number < feature::edge_corner) {
        return corner_edge((number - feature::corner_edge) / 3, number % 3);
    }
    if (number < feature::corner_face) {
        return edge_corner((number - feature::edge_corner) / 3, number % 3);
    }
    if (number < feature::face_corner) {
        return corner_face(number - feature::corner_face);
    }
    if (number < feature::edge_edge) {
        return face_corner(number - feature::face_corner);
    }
    return edge_edge((number - feature::edge_edge) / 3, number % 3);
}

ExactSquare ExactFeatures::least() const {
    ExactSquare least = *square(0);
    for (std::size_t number = 1; number < feature::count; ++number) {
        std::optional<ExactSquare> found = square(number);
        if (found && found->n * least.d < least.n * found->d) {
            least = std::move(*found);
        }
    }
    return least;
}

std::array<ExactPlace, 2> ExactFeatures::places(std::size_t number) const {
    if (number < feature::corner_edge) {
        return {ExactPlace{corners_[number / 3], 1}, ExactPlace{corners_[3 + number % 3], 1}};
    }
    if (number < feature::edge_corner) {
        const std::size_t i = (number - feature::corner_edge) / 3;
        const std::size_t j = number % 3;
        return {ExactPlace{corners_[i], 1},
                moved(corners_[3 + j], b_.square[j], b_.along[j], wv_[i][j])};
    }
    if (number < feature::corner_face) {
        const std::size_t i = (number - feature::edge_corner) / 3;
        const std::size_t j = number % 3;
        return {moved(corners_[i], a_.square[i], a_.along[i], -wu_[i][j]),
                ExactPlace{corners_[3 + j], 1}};
    }
    if (number < feature::face_corner) {
        const std::size_t i = number - feature::corner_face;
        return {ExactPlace{corners_[i], 1},
                moved(corners_[i], b_.area, b_.normal, -dot(w_[i][0], b_.normal))};
    }
    if (number < feature::edge_edge) {
        const std::size_t j = number - feature::face_corner;
        return {moved(corners_[3 + j], a_.area, a_.normal, dot(w_[0][j], a_.normal)),
                ExactPlace{corners_[3 + j], 1}};
    }
    const std::size_t i = (number - feature::edge_edge) / 3;
    const std::size_t j = number % 3;
    const ExactInt uv = dot(a_.along[i], b_.along[j]);
    const ExactInt cc = a_.square[i] * b_.square[j] - uv * uv;
    return {moved(corners_[i], cc, a_.along[i], uv * wv_[i][j] - b_.square[j] * wu_[i][j]),
            moved(corners_[3 + j], cc, b_.along[j], a_.square[i] * wv_[i][j] - uv * wu_[i][j])};
}

} // namespace cd
