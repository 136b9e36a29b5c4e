// Proves that a log line in JSON has the fields of the text as keys, whatever bytes they have.
#include "common/core/host/log_style.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace cd::tests {
namespace {

template <class... Values>
std::string members(fmt::string_view format, const Values&... values) {
    return json_members(format, fmt::make_format_args(values...));
}

TEST(JsonString, EscapesQuotesControlCharactersAndInvalidUtf8) {
    EXPECT_EQ(json_string(""), R"("")");
    EXPECT_EQ(json_string("a \"b\" c:\\d"), R"("a \"b\" c:\\d")");
    EXPECT_EQ(json_string("a\nb\tc\rd\x1b[2J\x7f"), R"("a\nb\tc\u000dd\u001b[2J\u007f")");
    EXPECT_EQ(json_string(std::string("a\0b", 3)), R"("a\u0000b")");
    EXPECT_EQ(json_string("\xc2\x80 \xc2\x9f \xc2\xa0"), "\"\\u0080 \\u009f \xc2\xa0\"");
    EXPECT_EQ(json_string("Caf\xc3\xa9 \xf0\x9f\x98\x80"), "\"Caf\xc3\xa9 \xf0\x9f\x98\x80\"");
    EXPECT_EQ(json_string("Caf\xe9 \xc2"), "\"Caf\xef\xbf\xbd \xef\xbf\xbd\"");
}

TEST(JsonMembers, FieldsAreKeys) {
    EXPECT_EQ(members("job goes on: job={} name=\"{}\" part={:.3f}", 7, "a \"b\" x=1: c", 0.25),
              R"("event":"job goes on","job":7,"name":"a \"b\" x=1: c","part":0.250)");
    EXPECT_EQ(members("job forgotten: job={} reason=\"newer jobs\" how=soon", 7),
              R"("event":"job forgotten","job":7,"reason":"newer jobs","how":"soon")");
    EXPECT_EQ(members("listening: at={}:{} tls={}", "::1", 7600, true),
              R"("event":"listening","at":"::1:7600","tls":true)");
    EXPECT_EQ(members("ended"), R"("event":"ended")");
    EXPECT_EQ(members("{}", "insecure: a=1"), R"("event":"insecure: a=1")");
}

TEST(JsonMembers, OnlyNumbersOfTheProgramAreNumbers) {
    // Text that looks like a number stays text; so do infinity and NaN, which JSON lacks.
    EXPECT_EQ(members("a: name={} x={}", "17", 17), R"("event":"a","name":"17","x":17)");
    EXPECT_EQ(members("a: x={} y={} z={}", -1.5, 1e300, 0),
              R"("event":"a","x":-1.5,"y":1e+300,"z":0)");
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(members("a: x={} y={:03} z=\"{}\"", infinity, 7, 7),
              R"("event":"a","x":"inf","y":"007","z":"7")");
}

TEST(JsonMembers, ProseAfterTheEventIsItsDetail) {
    EXPECT_EQ(members("refused: {}, try {} again", "x=1", 2),
              R"("event":"refused","detail":"x=1, try 2 again")");
    EXPECT_EQ(members("a: b=\"{}", 1), R"("event":"a","detail":"b=\"1")");
}

TEST(JsonLine, IsAnObjectWithTimeLevelAndProgram) {
    const std::chrono::system_clock::time_point time(std::chrono::milliseconds(1700000000042));
    EXPECT_EQ(json_line(time, "info", "cdmaster", R"("event":"ended")"),
              R"({"time":"2023-11-14T22:13:20.042Z","level":"info","program":"cdmaster",)"
              R"("event":"ended"})");
}

TEST(LogStyle, HasPrioritiesOnlyOnTheStreamOfTheJournal) {
    ::unsetenv("JOURNAL_STREAM");
    EXPECT_FALSE(log_style("text").has_priority);
    EXPECT_FALSE(log_style("text").is_json);
    EXPECT_TRUE(log_style("json").is_json);
    ::setenv("JOURNAL_STREAM", "0:0", 1); // Inherited from a service whose stderr was another file.
    EXPECT_FALSE(log_style("text").has_priority);
    ::unsetenv("JOURNAL_STREAM");
}

TEST(LogStyle, PrioritiesAreThoseOfSyslog) {
    EXPECT_EQ(journal_priority(LogLevel::Critical), "<2>");
    EXPECT_EQ(journal_priority(LogLevel::Error), "<3>");
    EXPECT_EQ(journal_priority(LogLevel::Warning), "<4>");
    EXPECT_EQ(journal_priority(LogLevel::Info), "<6>");
    EXPECT_EQ(journal_priority(LogLevel::Debug), "<7>");
}

} // namespace
} // namespace cd::tests
