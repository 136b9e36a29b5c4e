// Finds scenarios of an earlier run by their poses or ids.
#pragma once

#include "common/core/result.hpp"
#include "common/job/scenario.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace cd {

/// 96 bits of a SHA-256, which stand for a pair of poses or for an id. Among 10^8 scenarios, two
/// different ones have equal keys with a probability below 10^-12.
struct ScenarioKey {
    std::uint64_t high = 0;
    std::uint32_t low = 0;

    friend auto operator<=>(const ScenarioKey&, const ScenarioKey&) = default;
};

/// Returns the key of the poses' forms and numbers, exactly as given, except that -0 is 0; in a
/// scene also of the step and the bodies.
[[nodiscard]] ScenarioKey key_of(const Scenario& scenario);
/// Returns the step and the bodies of a scene's scenario as a key.
[[nodiscard]] ScenarioKey key_of_step(const Scenario& scenario);
[[nodiscard]] ScenarioKey key_of(std::string_view id);

/// A table from keys to scenarios, with 16 bytes for each scenario.
class ScenarioKeys {
  public:
    /// Makes an empty table for the keys of a run. Errors: TooLarge for 2^32 scenarios or more.
    [[nodiscard]] static Result<ScenarioKeys> for_run(std::uint64_t scenarios);

    /// Adds the key of the next scenario.
    void add(const ScenarioKey& key);
    /// Ends the adding; `find` and `take` may follow.
    void sort();

    /// Returns the first scenario with this key; nothing if there is none.
    [[nodiscard]] std::optional<std::uint64_t> find(const ScenarioKey& key) const;
    /// Returns the first scenario with this key that no earlier call has returned.
    [[nodiscard]] std::optional<std::uint64_t> take(const ScenarioKey& key);

  private:
    struct Entry {
        std::uint64_t high;
        std::uint32_t low;
        std::uint32_t index;

        [[nodiscard]] ScenarioKey key() const { return {high, low}; }
        friend auto operator<=>(const Entry&, const Entry&) = default;
    };

    [[nodiscard]] std::size_t place_of(const ScenarioKey& key) const;
    [[nodiscard]] bool has_at(std::size_t place, const ScenarioKey& key) const;

    std::vector<Entry> entries_; ///< Ascending.
    std::vector<bool> taken_;    ///< By place in `entries_`.
    /// For keys of several scenarios, by the first place: how many are taken.
    std::unordered_map<std::size_t, std::size_t> repeats_taken_;
};

} // namespace cd
