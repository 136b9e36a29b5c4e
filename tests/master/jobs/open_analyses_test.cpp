// Proves that open analyses are found by position, and that their bytes are counted.
#include "master/jobs/open_analyses.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

Analysis analysis(std::uint64_t position, std::uint64_t bytes) {
    Analysis one;
    one.position = position;
    one.bytes = bytes;
    return one;
}

TEST(OpenAnalyses, AnAnalysisIsOpenUntilItIsClosed) {
    OpenAnalyses open;
    EXPECT_EQ(open.add(analysis(7, 100)).position, 7u);
    open.add(analysis(9, 20));
    EXPECT_TRUE(open.has(7));
    EXPECT_EQ(open.find(9)->bytes, 20u);
    EXPECT_EQ(open.bytes(), 120u);
    open.close(7);
    EXPECT_FALSE(open.has(7));
    EXPECT_EQ(open.find(7), nullptr);
    EXPECT_EQ(open.size(), 1u);
    EXPECT_EQ(open.bytes(), 20u);
}

TEST(OpenAnalyses, ClosingAScenarioThatIsNotOpenChangesNothing) {
    OpenAnalyses open;
    open.add(analysis(7, 100));
    open.close(8);
    EXPECT_EQ(open.size(), 1u);
    EXPECT_EQ(open.bytes(), 100u);
}

TEST(OpenAnalyses, ATaskMayKeepAnAnalysisThatIsClosed) {
    OpenAnalyses open;
    open.add(analysis(7, 100));
    const auto kept = open.find(7);
    open.close(7);
    EXPECT_EQ(kept->bytes, 100u);
}

} // namespace
} // namespace cd::tests
