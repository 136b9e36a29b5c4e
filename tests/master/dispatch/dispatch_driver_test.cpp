// Proves that actions are performed in order, those that they cause after them, and that each event
// has its time.
#include "master/dispatch/dispatch_driver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace cd::tests {
namespace {

using testing::ElementsAre;

/// Performs actions that cause others; each is named by its scenario.
class DispatchDriverTest : public testing::Test {
  protected:
    static Action action(std::uint64_t name) { return GiveUp{JobId{1}, name}; }

    void perform(const Action& action) {
        const std::uint64_t name = std::get<GiveUp>(action).position;
        performed_.push_back(name);
        EXPECT_FALSE(driver_.is_idle());
        for (const std::uint64_t next : causes_[name]) {
            driver_.act({DispatchDriverTest::action(next)});
        }
    }

    std::map<std::uint64_t, std::vector<std::uint64_t>> causes_;
    std::vector<std::uint64_t> performed_;
    int clock_reads_ = 0;
    DispatchDriver driver_{[this] { return static_cast<double>(++clock_reads_); },
                           [this](const Action& action) { perform(action); }};
};

TEST_F(DispatchDriverTest, ActionsThatCauseActionsKeepTheirOrder) {
    causes_ = {{1, {4, 5}}, {2, {6}}, {4, {7}}};
    driver_.act({action(1), action(2), action(3)});
    EXPECT_THAT(performed_, ElementsAre(1, 2, 3, 4, 5, 6, 7));
    EXPECT_TRUE(driver_.is_idle());
    driver_.act({});
    EXPECT_TRUE(driver_.is_idle());
}

TEST_F(DispatchDriverTest, TheClockIsReadForEachEvent) {
    (void)driver_->worker_joined(WorkerId{1}, {"w", 1});
    (void)driver_->worker_lost(WorkerId{1});
    EXPECT_EQ(clock_reads_, 2);
    EXPECT_TRUE(driver_.view().workers().empty());
    EXPECT_EQ(clock_reads_, 2) << "a question is no event";
}

} // namespace
} // namespace cd::tests
