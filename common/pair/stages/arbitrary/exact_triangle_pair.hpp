// The last stage of the decision: arbitrary precision, right on every finite input.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <memory>

namespace cd {

/// Decides pairs under one pair of poses in integers, without rounding. Every finite double is an
/// integer times a power of two, and so are sums and products of such numbers. With quaternion
/// poses both bodies are scaled by both norms (q.q), which changes no sign.
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
