// The strategies compared in the experiments, one line each.
#pragma once

#include "proto/messages/cluster_options.hpp"

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

    [[nodiscard]] std::string name() const {
        return std::string(strategy) + (peers ? "+peers" : "");
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

} // namespace cd::bench
