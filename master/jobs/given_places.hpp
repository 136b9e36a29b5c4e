// Positions in a job's hand-out order that the dispatcher has but has not sent to a worker.
#pragma once

#include "common/job/poses/ordered_poses.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace cd {

/// Positions handed out as a range, with their poses.
struct GivenPlaces {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window; ///< Null for a grid, which needs no poses.
};

/// Keeps the pose windows of positions until the dispatcher sends the positions.
class PlacesAtDispatcher {
  public:
    void add(const GivenPlaces& given) { by_first_.emplace(given.places.first, given); }
    /// Removes `places`, which must begin where an added range or the rest of one begins.
    [[nodiscard]] GivenPlaces take(const PlaceRange& places);
    void clear() { by_first_.clear(); }

  private:
    std::map<std::uint64_t, GivenPlaces> by_first_;
};

} // namespace cd
