// Collects the results of scenarios into the arrays of the library, window by window.
#pragma once

#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "common/scene/step_index.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cdcluster {

/// Takes the results of one call in order. Passes them on in windows, or keeps all of them.
class ResultArrays {
  public:
    /// Called with a full window; empty: all results are kept.
    using EachWindow = std::function<void(Results&&)>;

    explicit ResultArrays(EachWindow each_window, std::vector<std::string> body_names = {});

    /// Takes the step of each result from these, the steps of a scene: with lines, the step in a
    /// result names its bundle, too. Null: results have the steps that they tell.
    void number_steps(std::shared_ptr<const cd::StepIndex> steps) { steps_ = std::move(steps); }

    /// Adds the next result; `found` has all its pairs if the job has maps.
    void add(const cd::ScenarioResult& result, std::span<const cd::ContactPair> found);
    /// Counts the pairs that `add` gets for maps.
    void count_maps() { counts_maps_ = true; }

    /// Passes the last window on. Returns what belongs to all results, and without windows the
    /// results. `map` replaces the maps that were counted; the bodies have so many triangles.
    [[nodiscard]] Results finish(const std::optional<cd::Sha256>& digest,
                                 std::array<std::size_t, 2> triangles,
                                 std::optional<cd::ContactMap> map = {});

  private:
    void add_pairs(const cd::ScenarioResult& result);
    void add_points(const cd::ScenarioResult& result);
    void add_distance(const cd::ScenarioResult& result);
    void add_motion(const cd::ScenarioResult& result);
    void begin_window(std::uint64_t first);

    EachWindow each_window_;
    std::vector<std::string> body_names_;
    std::shared_ptr<const cd::StepIndex> steps_;
    Results window_;
    bool counts_maps_ = false;
    cd::ContactMapSum map_;
};

} // namespace cdcluster
