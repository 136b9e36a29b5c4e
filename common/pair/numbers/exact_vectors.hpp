// Vectors of exact integers.
#pragma once

#include "common/pair/numbers/exact_lattice.hpp"

namespace cd::exact_vectors {

inline ExactVec minus(const ExactVec& l, const ExactVec& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

inline ExactVec cross(const ExactVec& l, const ExactVec& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

inline ExactInt dot(const ExactVec& l, const ExactVec& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

} // namespace cd::exact_vectors
