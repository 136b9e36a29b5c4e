#include "master/jobs/given_places.hpp"

#include "common/core/check.hpp"

#include <utility>

namespace cd {

GivenPlaces PlacesAtDispatcher::take(const PlaceRange& places) {
    // Keeps the rest under its first position: the part taken now may come back by `add` earlier.
    auto found = by_first_.extract(places.first);
    CD_CHECK(!found.empty());
    GivenPlaces& left = found.mapped();
    CD_CHECK(places.count <= left.places.count);
    const GivenPlaces taken{places, left.window};
    left.places = {places.end(), left.places.count - places.count};
    if (left.places.count != 0) {
        found.key() = left.places.first;
        const bool is_new = by_first_.insert(std::move(found)).inserted;
        CD_CHECK(is_new);
    }
    return taken;
}

} // namespace cd
