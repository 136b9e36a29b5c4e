// Variations of the product's policies that exist only in simulations.
#pragma once

#include "master/dispatch/policy/strategies.hpp"

#include <cstdint>
#include <span>

namespace cd::bench {

/// What a job's strategy is replaced with. The strategy keeps its name, because the master accepts
/// no other.
enum class Variation : std::uint8_t {
    None,
    /// The paper's section 5.1: a free worker takes q waiting scenarios, one at a time
    /// (one_by_one.hpp). `best-match` takes those of which it holds most, `lowest` those of which
    /// it holds least, `random` any.
    ClientFirst,
    /// `earliest-finish` that does not see where blocks are.
    Blind,
};

[[nodiscard]] std::span<const RegisteredStrategy> strategies_with(Variation variation);

} // namespace cd::bench
