// Which engines fit into the machine's memory together.
#pragma once

#include "bench/peers/contest.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cd::bench {

/// Learns from scenes how much memory engines take for a triangle.
class Room {
  public:
    void learn(std::span<const Outcome> outcomes, std::uint64_t triangles);

    /// The engines that fit with so many triangles, the first ones first, the first always. Those
    /// that do not are said on stderr.
    [[nodiscard]] std::vector<Engine> fitting(std::span<const Engine> engines,
                                              std::uint64_t triangles) const;

  private:
    std::map<std::string, double> bytes_a_triangle_; ///< By engine.
};

} // namespace cd::bench
