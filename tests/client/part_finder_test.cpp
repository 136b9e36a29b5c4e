// Proves that a triangle's part is found whatever was looked for before.
#include "client/export/part_finder.hpp"

#include "client/export/result_writer.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

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
        const Part* expected = part_of(mesh.get(), triangle);
        const auto found = finder.find(triangle);
        ASSERT_EQ(found.has_value(), expected != nullptr) << triangle;
        if (found) {
            ASSERT_EQ(finder.parts()[*found], *expected) << triangle;
        }
    }
}

TEST(PartFinder, WithoutAMeshThereAreNoParts) {
    PartFinder finder(nullptr);
    EXPECT_FALSE(finder.find(0));
}

} // namespace cd::tests
