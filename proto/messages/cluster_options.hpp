// The [cluster] table of a job: how its scenarios are distributed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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

enum class Strategy : std::uint8_t {
    BestMatch = 0,
    BestMatchLoad = 1,
    Random = 2,
    Lowest = 3,
    BestMatchPull = 4,  ///< Paper, 5.1: idle workers pull the most similar work.
    EarliestFinish = 5, ///< Ours: sizes batches by time; ignores q and claim.
};

[[nodiscard]] std::string_view to_text(Strategy strategy);
[[nodiscard]] std::optional<Strategy> strategy_from_text(std::string_view text);
/// Names in the order of the enumerators.
[[nodiscard]] std::span<const std::string_view> strategy_names();

/// The [cluster] table of a job. With a tolerance, `tolerance_depth` of the trees replaces
/// `depths`.
struct ClusterOptions {
    Strategy strategy = Strategy::EarliestFinish;
    /// Distribution depths by body (paper: 12 or 10 for the fixed body, 6 for the moved one).
    std::vector<std::optional<std::uint32_t>> depths = {};
    std::uint32_t q = 20;      ///< Buffer capacity, scenarios.
    std::uint32_t v_kb = 4096; ///< Buffer capacity, kB.
    bool claim = false;        ///< The paper's strict claiming: one task per worker at a time.
    std::uint64_t seed = 1;    ///< Seed of the random strategy.
    /// Strict claiming implies Always.
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
