// Proves that a triangle's part is found in any order of lookups.
#include "client/formats/part_finder.hpp"

#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cd::tests {

TEST(PartFinder, FindsWhatASearchFromTheStartFinds) {
    const Mesh box = make_box({1, 1, 1});
    // Triangles 0, 5 and 11 belong to no part.
    MeshArrays arrays{box.vertices(),
                      box.triangles(),
                      {{"first", 1, 3}, {"second", 3, 5}, {"third", 6, 11}},
                      box.precision()};
    const auto mesh = share(Mesh::create(std::move(arrays)).value());
    PartFinder finder(mesh);
    std::mt19937_64 random(5);
    for (int i = 0; i < 1000; ++i) {
        const auto triangle = static_cast<std::uint32_t>(random() % 13);
        const auto expected = std::ranges::find_if(mesh->parts(), [&](const Part& part) {
            return part.triangles_begin <= triangle && triangle < part.triangles_end;
        });
        const auto found = finder.find(triangle);
        ASSERT_EQ(found.has_value(), expected != mesh->parts().end()) << triangle;
        if (found) {
            ASSERT_EQ(finder.parts()[*found], *expected) << triangle;
        }
    }
}

} // namespace cd::tests
