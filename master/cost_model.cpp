#include "master/cost_model.hpp"

#include <bit>

namespace cd {

std::uint64_t predicted_ns(const TreeTop& a,
                           const TreeTop& b,
                           std::span<const RootPair> pairs,
                           std::uint64_t box_tests) {
    constexpr std::uint64_t scenario_ns = 2000;
    constexpr std::uint64_t box_test_ns = 10;
    constexpr std::uint64_t pair_ns = 100;
    constexpr std::uint64_t level_ns = 25; ///< Two subtrees that meet are descended level by level.
    std::uint64_t sum = scenario_ns + box_test_ns * box_tests;
    for (const RootPair& pair : pairs) {
        const auto levels =
            std::bit_width(a.triangles_under(pair.a)) + std::bit_width(b.triangles_under(pair.b));
        sum += pair_ns + level_ns * static_cast<std::uint64_t>(levels);
    }
    return sum;
}

} // namespace cd
