// Selects q scenarios for a free client (paper, section 5.1), one at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

/// A block that the client does not hold.
struct MissingBlock {
    std::uint64_t block = 0; ///< Number of the block among those of all bodies.
    std::uint32_t triangles = 0;
};

/// A waiting scenario: what the client holds and misses of it.
struct Candidate {
    std::uint64_t held_triangles = 0; ///< Triangles in those of its blocks that the client holds.
    std::vector<MissingBlock> missing;
};

enum class Likeness : std::uint8_t { Most, Least };

/// Returns the indices of at most `count` candidates, ascending. Each choice takes the candidate
/// with the most or least triangles in blocks that the client holds or that a candidate chosen
/// before it needs. Ties go to the smaller index.
[[nodiscard]] std::vector<std::size_t>
choose_one_by_one(std::span<const Candidate> candidates, std::size_t count, Likeness likeness);

} // namespace cd::bench
