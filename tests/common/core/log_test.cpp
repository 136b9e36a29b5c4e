// Proves that whatever is logged stays within its line, and leaves the terminal as it is.
#include "common/core/log.hpp"

#include "common/core/printable.hpp"
#include "tests/support/logged.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::EndsWith;

TEST(Log, ATextIsOneLineWhateverIsInIt) {
    const Logged logged(spdlog::level::info);
    spdlog::info("job: name=\"{}\"",
                 "a\nwarn cdmaster forged\r\x1b[2J\x7f\t\xc2\x9b"
                 "2J");
    EXPECT_THAT(logged.text(),
                EndsWith("info test job: name=\"a\\nwarn cdmaster forged\\x0d\\x1b[2J\\x7f\\t"
                         "\\xc2\\x9b2J\"\n"));
    EXPECT_EQ(logged.text().find('\n'), logged.text().size() - 1);
}

TEST(Log, NoLevelHidesWhatIsAlwaysSaid) {
    for (const auto level : {spdlog::level::err, spdlog::level::off}) {
        const Logged logged(level);
        spdlog::warn("hidden");
        warn_always("insecure: \n");
        EXPECT_THAT(logged.text(),
                    testing::AllOf(EndsWith("warning test insecure: \\n\n"),
                                   testing::Not(testing::HasSubstr("hidden"))));
    }
}

TEST(Printable, IsAllButControlCharacters) {
    EXPECT_TRUE(is_printable(""));
    EXPECT_TRUE(is_printable("a name, \xc3\xa4 \xc2\xa0 \xe2\x82\xac ~"));
    for (const char* text : {"\n", "a\x1b", "\x7f", "a\xc2\x80", "\xc2\x9f z"}) {
        EXPECT_FALSE(is_printable(text)) << escaped(text);
    }
    EXPECT_FALSE(is_printable(std::string(1, '\0')));
    EXPECT_EQ(escaped("\xc2"), "\xc2") << "cut short";
    EXPECT_EQ(escaped("back\\slash"), "back\\slash");
}

} // namespace
} // namespace cd::tests
