// Proves that the searches of the pairs of trees used last are kept, and no more.

#include "common/job/kept_searches.hpp"

#include "common/core/limits/engine.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

TEST(KeptSearches, ThePairsUsedLastAreKept) {
    const int most = static_cast<int>(limits::searches_kept_max);
    KeptSearches<int> kept;
    for (int tree = 0; tree < most; ++tree) {
        kept.of(0, tree).touching = tree;
    }
    EXPECT_EQ(kept.of(0, 0).touching, 0u); // Used again, so that another pair is the oldest.
    EXPECT_FALSE(kept.of(1, 0).touching) << "another order is another pair";
    EXPECT_EQ(kept.of(0, 0).touching, 0u);
    EXPECT_FALSE(kept.of(0, 1).touching) << "it was the oldest";
    EXPECT_EQ(kept.of(0, 3).touching, 3u);
}

} // namespace cd::tests
