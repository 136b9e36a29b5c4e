// Normals of planes between pairs of nodes, kept from pose to pose.
#pragma once

#include "common/tree/planes/plane_proof.hpp"
#include "common/tree/wide/pair_buckets.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cd {

/// A direct-mapped table from pairs of nodes to the outcome of the last search for a plane between
/// them. A pair may displace another one, which costs time and nothing else.
class KeptNormals {
  public:
    struct Outcome {
        WidePair nodes;
        PlaneNormal normal{}; ///< The last one tried.
        PlaneProof proof;     ///< By `normal`, if it parted the pair.
        /// Number of consecutive poses in which no plane was found or none was searched for.
        std::uint32_t failures = 0;
        std::uint32_t age = 0; ///< The table's when the outcome was written; 0: never.
    };

    KeptNormals() : outcomes_(std::size_t{1} << size_bits) {}

    void forget() { ++age_; }

    /// Returns a pair's outcome and true, or one for the caller to write and false.
    [[nodiscard]] std::pair<Outcome&, bool> of(WidePair nodes) {
        const std::uint32_t hash = nodes.a * 0x9E3779B1U ^ nodes.b * 0x85EBCA77U;
        Outcome& outcome = outcomes_[hash >> (32 - size_bits)];
        const bool is_known = outcome.age == age_ && outcome.nodes == nodes;
        outcome.nodes = nodes;
        outcome.age = age_;
        return {outcome, is_known};
    }

  private:
    static constexpr unsigned size_bits = 11;

    std::vector<Outcome> outcomes_;
    std::uint32_t age_ = 1;
};

} // namespace cd
