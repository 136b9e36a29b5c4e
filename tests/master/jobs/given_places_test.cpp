// Proves that positions at the dispatcher keep their pose window until they are sent.
#include "master/jobs/given_places.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

std::shared_ptr<const PoseWindow> window() {
    return std::make_shared<const PoseWindow>(std::vector<Scenario>(1));
}

TEST(PlacesAtDispatcher, EachPartOfARangeKeepsItsWindow) {
    const auto first = window();
    const auto second = window();
    PlacesAtDispatcher places;
    places.add({{0, 10}, first});
    places.add({{10, 5}, second});
    const GivenPlaces part = places.take({0, 4});
    EXPECT_EQ(part.places, (PlaceRange{0, 4}));
    EXPECT_EQ(part.window, first);
    EXPECT_EQ(places.take({10, 5}).window, second);
    EXPECT_EQ(places.take({4, 6}).window, first);
}

TEST(PlacesAtDispatcher, ALeadingPartMayBeGivenAgainBeforeTheRestIsTaken) {
    const auto first = window();
    const auto again = window();
    PlacesAtDispatcher places;
    places.add({{0, 10}, first});
    (void)places.take({0, 4});
    places.add({{0, 4}, again});
    EXPECT_EQ(places.take({0, 4}).window, again);
    EXPECT_EQ(places.take({4, 6}).window, first);
}

TEST(PlacesAtDispatcher, ClearedPositionsMayBeGivenAgain) {
    PlacesAtDispatcher places;
    places.add({{0, 10}, window()});
    places.clear();
    places.add({{0, 3}, nullptr});
    EXPECT_EQ(places.take({0, 3}).window, nullptr) << "a grid";
}

} // namespace
} // namespace cd::tests
