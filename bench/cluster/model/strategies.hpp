// The strategies compared in the experiments, one line each.
#pragma once

#include "proto/messages/cluster_options.hpp"

#include <array>
#include <string>

namespace cd::bench {

struct ComparedStrategy {
    Strategy strategy;
    /// True: as in the paper, a worker with a task gets no other. False: a second task waits at the
    /// worker.
    bool claims;
    /// Chooses among waiting scenarios: then as many wait as in the product, whatever the setting.
    bool sees_queue;
    bool peers = false; ///< Workers send each other blocks.

    [[nodiscard]] std::string name() const {
        return std::string(to_text(strategy)) + (peers ? "+peers" : "");
    }
};

inline constexpr std::array compared_strategies{
    ComparedStrategy{Strategy::BestMatch, true, false},
    ComparedStrategy{Strategy::BestMatchLoad, true, false},
    ComparedStrategy{Strategy::Random, true, false},
    ComparedStrategy{Strategy::Lowest, true, false},
    ComparedStrategy{Strategy::BestMatchPull, true, true},
    ComparedStrategy{Strategy::EarliestFinish, false, true},
    ComparedStrategy{Strategy::EarliestFinish, false, true, true},
};

} // namespace cd::bench
