// The [cluster] table of a job: how its scenarios are distributed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Whether the master finds the colliding roots of each scenario (paper, 6.4.6), or workers do for
/// whole ranges of scenarios.
enum class AnalysisMode : std::uint8_t {
    Auto = 0, ///< The cheaper mode by measurement.
    Always = 1,
    Never = 2, ///< Except for scenarios of lost workers.
};

[[nodiscard]] std::string_view to_text(AnalysisMode mode);
[[nodiscard]] std::optional<AnalysisMode> analysis_mode_from_text(std::string_view text);
[[nodiscard]] std::span<const std::string_view> analysis_mode_names();

/// A matching strategy as users know it. `master/dispatch/policy/strategies.cpp` makes its policy.
struct Strategy {
    std::string_view name;
    std::string_view worker; ///< Ends the sentence "A scenario goes to the worker that ...".
    bool uses_q = true;      ///< Its batches have q scenarios; workers may be claimed.
};

/// All strategies, one line each.
inline constexpr std::array strategies{
    Strategy{"best-match", "holds most of what the scenario touches"},
    Strategy{"best-match-load", "holds most, times the free share of its buffer"},
    Strategy{"random", "is drawn"},
    Strategy{"lowest", "holds least of what the scenario touches"},
    Strategy{"best-match-pull", "is free; it takes the q scenarios of which it holds most"},
    Strategy{"earliest-finish", "would be done first, transfers included", false},
};

/// Returns null if no strategy has the name.
[[nodiscard]] const Strategy* find_strategy(std::string_view name);
[[nodiscard]] std::vector<std::string_view> strategy_names();
/// Whether the text may name a strategy: 1 to `limits::strategy_name_bytes_max` of a-z, 0-9 and -.
[[nodiscard]] bool is_strategy_name(std::string_view text);

/// The [cluster] table of a job.
struct ClusterOptions {
    std::string strategy = "earliest-finish"; ///< The name of a strategy.
    /// Distribution depths by body (paper: 12 or 10 for the fixed body, 6 for the moved one).
    std::vector<std::optional<std::uint32_t>> depths = {};
    std::uint32_t q = 20;      ///< Buffer capacity, scenarios.
    std::uint32_t v_kb = 4096; ///< Buffer capacity, kB.
    bool claim = false;        ///< The paper's strict claiming: one task per worker at a time.
    std::uint64_t seed = 1;    ///< Seed of the random strategy.
    /// Whether the master or the workers find the colliding roots. `claim` implies Always.
    AnalysisMode analysis = AnalysisMode::Auto;
    /// Sends workers hints of subtrees that they will need. `earliest-finish` only.
    bool hints = true;

    /// The distribution depth set for a body; empty if it follows from the body's tree.
    [[nodiscard]] std::optional<std::uint32_t> depth(std::size_t body) const {
        return body < depths.size() ? depths[body] : std::nullopt;
    }
    void set_depth(std::size_t body, std::optional<std::uint32_t> depth) {
        if (depth || body < depths.size()) {
            depths.resize(std::max(depths.size(), body + 1));
            depths[body] = depth;
        }
    }
};

} // namespace cd
