// Proves that alarms and quarantine are reported for the journal exactly when they change.
#include "master/verify/alarms.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(Alarms, ReportEachChangeOnce) {
    Alarms alarms;
    EXPECT_FALSE(alarms.take_changed());
    alarms.raise("something is wrong");
    EXPECT_TRUE(alarms.quarantine(7));
    const auto changed = alarms.take_changed();
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->count, 1u);
    EXPECT_EQ(changed->quarantined, std::vector<InstanceId>{7});
    EXPECT_FALSE(alarms.take_changed());
}

TEST(Alarms, QuarantineAProcessOnceAndTheMasterNever) {
    Alarms alarms;
    EXPECT_TRUE(alarms.quarantine(7));
    EXPECT_FALSE(alarms.quarantine(7));
    EXPECT_FALSE(alarms.quarantine(0));
    EXPECT_TRUE(alarms.is_quarantined(7));
    EXPECT_FALSE(alarms.is_quarantined(8));
    EXPECT_EQ(alarms.quarantined(), std::set<InstanceId>{7});
}

TEST(Alarms, AfterARestartAreThoseOfTheRecord) {
    Alarms before;
    before.raise("something is wrong");
    before.quarantine(7);
    Alarms after;
    after.restore(before.record());
    EXPECT_EQ(after.record(), before.record());
    EXPECT_TRUE(after.is_quarantined(7));
    EXPECT_FALSE(after.take_changed()) << "the journal has it already";
}

} // namespace
} // namespace cd::tests
