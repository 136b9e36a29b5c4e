// What a report says of the distances of a run: the least ones in pictures, and how many of which.
#pragma once

#include "client/document/html.hpp"
#include "client/document/run_names.hpp"
#include "client/document/run_overview.hpp"
#include "client/folder/run_manifest.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A bar of a histogram: how many distances are in [from, to); the last bar has its end, too.
struct DistanceBar {
    double from = 0;
    double to = 0;
    std::size_t count = 0;
};

/// Returns 20 bars of equal width from 0 to the greatest distance; none without distances, and one
/// if all distances are 0.
[[nodiscard]] std::vector<DistanceBar> distance_bars(std::span<const double> distances);

/// Writes the sections of a run that asks for the distance. References must outlive the object.
class DistanceSections {
  public:
    DistanceSections(const RunNames& names, const RunManifest& manifest, RunOverview& overview)
        : names_(names), manifest_(manifest), overview_(overview) {}

    /// Returns one sentence about the least distance.
    [[nodiscard]] std::string least() const;
    /// Returns the section of the scenarios of least distance. `pictures` are theirs, in order.
    [[nodiscard]] Html nearest(std::span<const std::string> pictures) const;
    /// Returns the section with the histogram; empty without distances.
    [[nodiscard]] Html histogram() const;

  private:
    [[nodiscard]] std::string length(double value) const;
    [[nodiscard]] std::string caption(const ScenarioResult& result) const;

    const RunNames& names_;
    const RunManifest& manifest_;
    RunOverview& overview_;
};

} // namespace cd
