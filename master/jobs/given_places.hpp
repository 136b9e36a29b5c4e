// Order positions that the dispatcher has and has not sent.
#pragma once

#include "common/job/poses/ordered_poses.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace cd {

/// Order positions handed out as a range, and their pose window; null for a grid.
struct GivenPlaces {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window;
};

/// Keeps the windows of the positions until they are sent.
class PlacesAtDispatcher {
  public:
    void add(const GivenPlaces& given) { by_first_.emplace(given.places.first, given); }
    /// Removes `places`, the leading part of what was added and is left.
    [[nodiscard]] GivenPlaces take(const PlaceRange& places);
    void clear() { by_first_.clear(); }

  private:
    std::map<std::uint64_t, GivenPlaces> by_first_;
};

} // namespace cd
