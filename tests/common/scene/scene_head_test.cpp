// Proves that all which decides what a scene tests changes its head, and nothing else does.
#include "common/scene/scene_head.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace cd::tests {

namespace {

struct Tested {
    std::vector<Sha256> meshes = std::vector<Sha256>(3);
    std::vector<bool> are_fixed = {false, false, true};
    std::uint64_t steps = 4;
    PairSet ignored{3};
    std::vector<IgnoredRange> ranges = {{0, 1, 2, 3, 0, 1}};

    [[nodiscard]] Sha256 hash() const {
        return scene_head(meshes, are_fixed, steps, ignored, ranges).hash;
    }
};

} // namespace

TEST(SceneHead, ChangesWithEachOfItsInputs) {
    const std::vector<std::function<void(Tested&)>> changes{
        [](Tested& scene) { scene.meshes[1].bytes[31] = std::byte{1}; },
        [](Tested& scene) { scene.are_fixed[0] = true; },
        [](Tested& scene) { scene.steps = 5; },
        [](Tested& scene) {
            const std::vector<std::uint32_t> one{0};
            const std::vector<std::uint32_t> other{2};
            EXPECT_EQ(scene.ignored.add(one, other), 1u);
        },
        [](Tested& scene) { scene.ranges[0].body_b = 2; },
        [](Tested& scene) { scene.ranges.clear(); },
    };
    std::set<Sha256> hashes{Tested().hash()};
    EXPECT_EQ(Tested().hash(), Tested().hash());
    for (const auto& change : changes) {
        Tested scene;
        change(scene);
        EXPECT_TRUE(hashes.insert(scene.hash()).second);
    }
}

} // namespace cd::tests
