#include "master/dispatch/policy/strategies.hpp"

#include "common/core/check.hpp"
#include "master/dispatch/policy/best_match.hpp"
#include "master/dispatch/policy/best_match_load.hpp"
#include "master/dispatch/policy/best_match_pull.hpp"
#include "master/dispatch/policy/earliest_finish.hpp"
#include "master/dispatch/policy/lowest.hpp"
#include "master/dispatch/policy/random.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace cd {

namespace {

// One line per strategy. `strategies` (proto/messages/cluster_options.hpp) names it to users.
constexpr std::array registry{
    RegisteredStrategy{"best-match", make_as<BestMatch>},
    RegisteredStrategy{"best-match-load", make_as<BestMatchLoad>},
    RegisteredStrategy{"random", make_as<RandomWorker>},
    RegisteredStrategy{"lowest", make_as<Lowest>},
    RegisteredStrategy{"best-match-pull", make_as<BestMatchPull>},
    RegisteredStrategy{"earliest-finish", make_as<EarliestFinish>},
};

} // namespace

std::span<const RegisteredStrategy> registered_strategies() {
    return registry;
}

Status check_strategy(std::string_view name) {
    std::string names;
    for (const RegisteredStrategy& strategy : registry) {
        if (strategy.name == name) {
            return Done{};
        }
        names += (names.empty() ? "" : ", ") + std::string(strategy.name);
    }
    return Error{ErrorCode::BadInput,
                 "no strategy is called \"" + std::string(name) + "\"; this master has " + names};
}

std::unique_ptr<MatchingPolicy> make_policy(const ClusterOptions& options,
                                            const MatchingContext& context,
                                            std::span<const RegisteredStrategy> registered) {
    const auto found = std::ranges::find(registered, options.strategy, &RegisteredStrategy::name);
    CD_CHECK(found != registered.end());
    return found->make(context, options);
}

} // namespace cd
