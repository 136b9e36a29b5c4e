// Collects the results of scenarios into the arrays of the library, window by window.
#pragma once

#include "client/export/result_writer.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <array>
#include <cstddef>
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

    /// The first scenario has the index `first`.
    explicit ResultArrays(EachWindow each_window,
                          std::vector<std::string> body_names = {},
                          std::uint64_t first = 0);

    /// Takes the step of each result, and with lines its bundle, from the job: with lines, the step
    /// in a record of a scene names both.
    void number_steps(const cd::ExportContext& context) { scene_ = context; }

    /// Adds the next result; `found` has all its pairs if the job has maps.
    void add(const cd::ScenarioResult& result, std::span<const cd::ContactPair> found);
    /// Counts the pairs that `add` gets for a map, which has sums by these parts.
    void count_maps(std::shared_ptr<const cd::BodyPartRuns> parts) {
        map_.emplace(std::move(parts));
    }
    /// Returns the map of all results; nothing if none was counted.
    [[nodiscard]] std::optional<cd::ContactMap> take_map();

    /// Passes the last window on. Returns what belongs to all results, and without windows the
    /// results. The bodies have so many triangles.
    [[nodiscard]] Results finish(const std::optional<cd::Sha256>& digest,
                                 std::array<std::size_t, 2> triangles,
                                 const std::optional<cd::ContactMap>& map);

  private:
    void add_pairs(const cd::ScenarioResult& result);
    void add_points(const cd::ScenarioResult& result);
    void add_distance(const cd::ScenarioResult& result);
    void add_motion(const cd::ScenarioResult& result);
    void number(std::uint64_t index);
    void begin_window(std::uint64_t first);
    void pass_window();

    EachWindow each_window_;
    std::vector<std::string> body_names_;
    std::optional<cd::ExportContext> scene_;
    Results window_;
    std::optional<cd::ContactMapSum> map_;
};

/// Returns the names of the bodies of a job.
[[nodiscard]] std::vector<std::string> names_of(const cd::ExportContext& context);
/// Returns the numbers of triangles of A and of B. Scenes, which may have more, have no maps.
[[nodiscard]] std::array<std::size_t, 2>
triangles_of(const std::vector<std::shared_ptr<const cd::Mesh>>& meshes);

} // namespace cdcluster
