// Proves that levels have the names that users write.

#include "common/job/query.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

TEST(Query, LevelsHaveNames) {
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        EXPECT_EQ(level_from_text(to_text(level)), level);
    }
    EXPECT_EQ(to_text(Level::Contacts), "contacts");
    EXPECT_EQ(level_from_text("Any"), std::nullopt);
    EXPECT_EQ(level_from_text(""), std::nullopt);
}

} // namespace cd::tests
