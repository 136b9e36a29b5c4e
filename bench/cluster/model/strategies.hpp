// The strategies compared in the experiments, one line each.
#pragma once

#include "bench/cluster/model/policies.hpp"

#include <array>
#include <string>
#include <string_view>

namespace cd::bench {

struct ComparedStrategy {
    std::string_view strategy;
    /// True: as in the paper, a worker with a task gets no other. False: a second task waits at the
    /// worker.
    bool claims;
    /// Chooses among waiting scenarios: then as many wait as in the product, whatever the setting.
    bool sees_queue;
    bool peers = false; ///< Workers send each other blocks.
    Variation variation = Variation::None;

    [[nodiscard]] std::string name() const {
        return std::string(variation == Variation::Blind ? "blind " : "") + std::string(strategy) +
               (variation == Variation::ClientFirst ? "-pull" : "") + (peers ? "+peers" : "");
    }
};

inline constexpr std::array compared_strategies{
    ComparedStrategy{"best-match", true, false},
    ComparedStrategy{"best-match-load", true, false},
    ComparedStrategy{"random", true, false},
    ComparedStrategy{"lowest", true, false},
    ComparedStrategy{"best-match-pull", true, true},
    ComparedStrategy{"earliest-finish", false, true},
    ComparedStrategy{"earliest-finish", false, true, true},
};

/// The paper's strategies in the client-first form of its section 5.1, beside ours.
inline constexpr std::array client_first_strategies{
    ComparedStrategy{"best-match", true, true, false, Variation::ClientFirst},
    ComparedStrategy{"random", true, true, false, Variation::ClientFirst},
    ComparedStrategy{"lowest", true, true, false, Variation::ClientFirst},
    ComparedStrategy{"earliest-finish", false, true, true},
};

} // namespace cd::bench
