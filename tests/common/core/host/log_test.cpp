// Proves that logged text stays within its line and cannot control the terminal.
#include "common/core/host/log.hpp"

#include "common/core/printable.hpp"
#include "tests/support/logged.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::EndsWith;

TEST(Log, ATextIsOneLineWhateverIsInIt) {
    const Logged logged(LogLevel::Info);
    log_info("job: name=\"{}\"",
             "a\nwarn cdmaster forged\r\x1b[2J\x7f\t\xc2\x9b"
             "2J");
    EXPECT_THAT(logged.text(),
                EndsWith("info test job: name=\"a\\nwarn cdmaster forged\\x0d\\x1b[2J\\x7f\\t"
                         "\\xc2\\x9b2J\"\n"));
    EXPECT_EQ(logged.text().find('\n'), logged.text().size() - 1);
}

TEST(Log, WarnAlwaysIgnoresTheLevel) {
    for (const auto level : {LogLevel::Error, LogLevel::Off}) {
        const Logged logged(level);
        log_warning("hidden");
        warn_always("insecure: \n");
        EXPECT_THAT(logged.text(),
                    testing::AllOf(EndsWith("warning test insecure: \\n\n"),
                                   testing::Not(testing::HasSubstr("hidden"))));
    }
}

TEST(Printable, IsUtf8WithoutControlCharacters) {
    EXPECT_TRUE(is_printable(""));
    EXPECT_TRUE(is_printable("a name, \xc3\xa4 \xc2\xa0 \xe2\x82\xac ~"));
    // The first and last characters of two, three and four bytes, and those next to the surrogates.
    for (const char* text : {"\xdf\xbf",
                             "\xe0\xa0\x80",
                             "\xed\x9f\xbf",
                             "\xee\x80\x80",
                             "\xef\xbf\xbf",
                             "\xf0\x90\x80\x80",
                             "\xf4\x8f\xbf\xbf"}) {
        EXPECT_TRUE(is_printable(text)) << text;
        EXPECT_EQ(escaped(text), text);
    }
    for (const char* text : {"\n",
                             "a\x1b",
                             "\x7f",
                             "a\xc2\x80",
                             "\xc2\x9f z",
                             // Truncated, without a first byte, or overlong.
                             "\xff",
                             "\xc3",
                             "\xe2\x82",
                             "\x80",
                             "\xc1\x81",
                             "\xe0\x9f\xbf",
                             "\xf0\x8f\xbf\xbf",
                             // Surrogates, and beyond the last code point.
                             "\xed\xa0\x80",
                             "\xed\xbf\xbf",
                             "\xf4\x90\x80\x80",
                             "\xf5\x80\x80\x80"}) {
        EXPECT_FALSE(is_printable(text)) << escaped(text);
    }
    EXPECT_FALSE(is_printable(std::string(1, '\0')));
    EXPECT_EQ(escaped("Caf\xe9"), "Caf\\xe9");
    EXPECT_EQ(escaped("back\\slash"), "back\\slash");
}

TEST(Printable, InvalidUtf8IsReplacedAndNoCharacterIsCut) {
    EXPECT_EQ(valid_utf8("Caf\xc3\xa9\n"), "Caf\xc3\xa9\n");
    EXPECT_EQ(valid_utf8("Caf\xe9 \xc3"), "Caf\xEF\xBF\xBD \xEF\xBF\xBD");
    EXPECT_EQ(utf8_prefix("a\xc3\xa9o", 1), "a");
    EXPECT_EQ(utf8_prefix("a\xc3\xa9o", 2), "a");
    EXPECT_EQ(utf8_prefix("a\xc3\xa9o", 3), "a\xc3\xa9");
    EXPECT_EQ(utf8_prefix("a\xc3\xa9o", std::string::npos), "a\xc3\xa9o");
}

} // namespace
} // namespace cd::tests
