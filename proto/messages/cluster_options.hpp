// How a job is given out: the [cluster] table of a job.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cd {

/// Whether the master analyses a scenario before it goes to a worker (paper, 6.4.6), or the worker
/// finds the colliding roots of a whole range of scenarios itself.
enum class AnalysisMode : std::uint8_t {
    Auto = 0, ///< Whichever costs less, as measured.
    Always = 1,
    Never = 2, ///< But for scenarios that were lost with a worker.
};

[[nodiscard]] std::string_view to_text(AnalysisMode mode);
[[nodiscard]] std::optional<AnalysisMode> analysis_mode_from_text(std::string_view text);
[[nodiscard]] std::span<const std::string_view> analysis_mode_names();

enum class Strategy : std::uint8_t {
    BestMatch = 0,
    BestMatchLoad = 1,
    Random = 2,
    Lowest = 3,
    BestMatchPull = 4,  ///< The paper's first form (5.1): a free worker takes what is most similar.
    EarliestFinish = 5, ///< Ours, in seconds. Batches follow time; q and claim are not looked at.
};

[[nodiscard]] std::string_view to_text(Strategy strategy);
[[nodiscard]] std::optional<Strategy> strategy_from_text(std::string_view text);
/// In the order of their numbers.
[[nodiscard]] std::span<const std::string_view> strategy_names();

/// The [cluster] table of a job. Under a tolerance the depths are `tolerance_depth` of the trees,
/// and those given here are not looked at.
struct ClusterOptions {
    Strategy strategy = Strategy::EarliestFinish;
    /// Distribution depths by body (paper: 12 or 10 for the fixed body, 6 for the moved one).
    std::vector<std::optional<std::uint32_t>> depths = {};
    std::uint32_t q = 20;      ///< A buffer is full at q scenarios
    std::uint32_t v_kb = 4096; ///< or V kB.
    bool claim = false;        ///< The paper's strict claiming: one task at a worker at a time.
    std::uint64_t seed = 1;    ///< Of the random strategy.
    /// With strict claiming it is Always.
    AnalysisMode analysis = AnalysisMode::Auto;
    /// Workers hear what they will need next. Looked at by `earliest-finish` alone.
    bool hints = true;

    /// The distribution depth given for a body; nothing if it follows from the body's tree.
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
