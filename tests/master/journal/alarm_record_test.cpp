// Proves that alarms and quarantined workers are restored, that their number is bounded, and that
// invalid bytes are errors.
#include "master/journal/alarm_record.hpp"

#include "common/core/limits/master.hpp"
#include "tests/support/damage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

AlarmRecord some_alarms() {
    AlarmRecord alarms;
    alarms.add("one");
    alarms.add("");
    alarms.quarantine(~std::uint64_t{0});
    alarms.quarantine(5);
    return alarms;
}

TEST(AlarmRecord, ARecordIsReadBackAsWritten) {
    for (const AlarmRecord& alarms : {AlarmRecord{}, some_alarms()}) {
        const auto decoded = decode_alarms(encode_alarms(alarms));
        ASSERT_TRUE(decoded) << decoded.error().detail;
        EXPECT_EQ(decoded.value(), alarms);
    }
}

TEST(AlarmRecord, TheLastAlarmsAreKeptAndAllAreCounted) {
    AlarmRecord alarms;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        alarms.add(std::to_string(i));
        alarms.quarantine(i);
    }
    EXPECT_EQ(alarms.count, 10'000u);
    EXPECT_EQ(alarms.last.size(), limits::alarms_kept_max);
    EXPECT_EQ(alarms.last.back(), "9999");
    EXPECT_EQ(alarms.quarantined.size(), limits::quarantined_kept_max);
    EXPECT_EQ(alarms.quarantined.back(), 9999u);
    EXPECT_EQ(decode_alarms(encode_alarms(alarms)).value(), alarms);
}

TEST(AlarmRecord, CutShortFollowedByMoreOrTooLongIsAnError) {
    expect_no_other_length(encode_alarms(some_alarms()), decode_alarms);
    AlarmRecord many;
    many.last.resize(limits::alarms_kept_max + 1);
    EXPECT_FALSE(decode_alarms(encode_alarms(many)));
}

} // namespace
} // namespace cd::tests
