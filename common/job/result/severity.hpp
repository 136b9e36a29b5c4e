// Which of several scenarios is the worst, in charts, episodes and lists.
#pragma once

#include "common/job/result/result.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace cd {

/// Returns how bad a class is; larger is worse. The order is separate, undecided, near, touch,
/// contact, cross, inside, failed. The least value is 1: a scenario without a result is less bad
/// than any class.
[[nodiscard]] constexpr std::uint8_t severity(ScenarioClass kind) {
    constexpr std::array<std::uint8_t, 8> by_class{1, 4, 6, 7, 5, 2, 8, 3};
    return by_class[static_cast<std::size_t>(kind)];
}

/// Returns the number of the pairs that a scenario's class stands for: of near pairs if the class
/// is Near, else of pairs in contact.
[[nodiscard]] inline std::uint64_t pairs_of_class(const ScenarioResult& result) {
    return result.kind == ScenarioClass::Near ? result.near_count : result.pair_count;
}

/// How bad a scenario is: by its class, then by the number of pairs of its class.
struct Badness {
    std::uint8_t severity = 0;
    std::uint64_t pairs = 0;

    friend auto operator<=>(const Badness&, const Badness&) = default;
};

[[nodiscard]] inline Badness badness_of(const ScenarioResult& result) {
    return {severity(result.kind), pairs_of_class(result)};
}

/// True for the classes of scenarios that lists of the worst ones have: those in contact and near.
[[nodiscard]] constexpr bool is_hit(ScenarioClass kind) {
    return is_contact(kind) || kind == ScenarioClass::Near;
}

} // namespace cd
