// The strategies that the experiments compare: one line each.
#pragma once

#include "proto/message.hpp"

#include <array>

namespace cd::bench {

struct ComparedStrategy {
    Strategy strategy;
    /// As the paper has it: a worker gets nothing while it has a task. Ours keep a second task
    /// waiting at the worker.
    bool claims;
};

inline constexpr std::array compared_strategies{
    ComparedStrategy{Strategy::BestMatch, true},
    ComparedStrategy{Strategy::BestMatchLoad, true},
    ComparedStrategy{Strategy::Random, true},
    ComparedStrategy{Strategy::Lowest, true},
};

} // namespace cd::bench
