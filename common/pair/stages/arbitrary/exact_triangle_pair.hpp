// The last stage of the decision: arbitrary precision, right on every finite input.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <memory>

namespace cd {

/// Decides pairs under one pair of poses in integers. Every finite double is an integer times a
/// power of two, and sums and products of such numbers are again; with quaternion poses both bodies
/// are scaled by the norms (q.q) of both, which changes no sign. So nothing is ever rounded.
class ExactTrianglePair {
  public:
    explicit ExactTrianglePair(const PosePair& poses);
    ExactTrianglePair(ExactTrianglePair&&) noexcept;
    ExactTrianglePair& operator=(ExactTrianglePair&&) noexcept;
    ~ExactTrianglePair();

    [[nodiscard]] PairClass classify(const Corners& a, const Corners& b) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
