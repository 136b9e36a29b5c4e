// Selects the engines that fit into the machine's memory together.
#pragma once

#include "bench/peers/contest.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cd::bench {

/// Learns from scenes how much memory engines use per triangle.
class Room {
  public:
    void learn(std::span<const Outcome> outcomes, std::uint64_t triangles);

    /// Returns the engines that fit with so many triangles, in order; the first engine always fits.
    /// Reports the others on stderr.
    [[nodiscard]] std::vector<Engine> fitting(std::span<const Engine> engines,
                                              std::uint64_t triangles) const;

  private:
    std::map<std::string, double> bytes_a_triangle_; ///< Keyed by engine.
};

} // namespace cd::bench
