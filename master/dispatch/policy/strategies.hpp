// The matching strategies of this master, by name.
#pragma once

#include "common/core/result.hpp"
#include "proto/messages/cluster_options.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace cd {

class MatchingPolicy;
struct MatchingContext;

/// The name of a strategy, and the function that makes its policies.
struct RegisteredStrategy {
    std::string_view name;
    std::unique_ptr<MatchingPolicy> (*make)(const MatchingContext&, const ClusterOptions&);
};

template <class Policy>
std::unique_ptr<MatchingPolicy> make_as(const MatchingContext& context,
                                        const ClusterOptions& options) {
    return std::make_unique<Policy>(context, options);
}

[[nodiscard]] std::span<const RegisteredStrategy> registered_strategies();

/// Checks that a strategy has this name. Errors: BadInput, with the registered names.
[[nodiscard]] Status check_strategy(std::string_view name);

/// Makes a policy of the strategy that the options name, which must be among `registered`.
[[nodiscard]] std::unique_ptr<MatchingPolicy>
make_policy(const ClusterOptions& options,
            const MatchingContext& context,
            std::span<const RegisteredStrategy> registered = registered_strategies());

} // namespace cd
