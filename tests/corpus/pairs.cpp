#include "tests/corpus/pairs.hpp"

#include "common/core/check.hpp"
#include "tests/corpus/pair_makers.hpp"

namespace cd::tests {

namespace {

const PairMakers& all_makers() {
    static const PairMakers makers = [] {
        PairMakers all = pair_makers();
        add_contact_makers(all);
        add_extreme_makers(all);
        add_pose_makers(all);
        add_scene_makers(all);
        return all;
    }();
    return makers;
}

} // namespace

const std::vector<std::string>& pair_categories() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& [name, maker] : all_makers()) {
            all.push_back(name);
        }
        return all;
    }();
    return names;
}

PosedPair corpus_pair(std::string_view category, std::uint64_t seed) {
    const auto maker = all_makers().find(std::string(category));
    CD_CHECK(maker != all_makers().end());
    std::mt19937_64 random(seed);
    return maker->second(random);
}

} // namespace cd::tests
