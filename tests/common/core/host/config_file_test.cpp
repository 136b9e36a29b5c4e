// Proves which configuration files are read, and that an error names the line.
#include "common/core/host/config_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ConfigFile, ValuesAreTextsNumbersTruthsAndListsOfThese) {
    const auto read = parse_config(
        "# A comment.\nname = \"a b\"\nthreads = 4\nno-sync = true\nhttp-name = [\"x\", \"y\"]\n",
        "");
    ASSERT_TRUE(read) << read.error().detail;
    const std::vector<ConfigEntry>& entries = read.value();
    ASSERT_EQ(entries.size(), 4u);
    EXPECT_EQ(entries[0].key, "http-name");
    EXPECT_THAT(entries[0].values, ElementsAre("x", "y"));
    EXPECT_EQ(entries[0].line, 5u);
    EXPECT_THAT(entries[1].values, ElementsAre("a b"));
    EXPECT_THAT(entries[2].values, ElementsAre("true"));
    EXPECT_THAT(entries[3].values, ElementsAre("4"));
    EXPECT_EQ(entries[3].line, 3u);
    const auto decimals = parse_config("a = 0.5\nb = 1e-3\nc = 2.0\n", "");
    ASSERT_TRUE(decimals) << decimals.error().detail;
    EXPECT_THAT(decimals.value()[0].values, ElementsAre("0.5"));
    EXPECT_THAT(decimals.value()[1].values, ElementsAre("0.001"));
    EXPECT_THAT(decimals.value()[2].values, ElementsAre("2"));
    EXPECT_TRUE(parse_config("", "")) << "an empty file has no keys";
}

TEST(ConfigFile, AnErrorNamesPlaceAndLine) {
    const auto problem = [](const char* text) {
        const auto read = parse_config(text, "here:");
        return read ? "no error" : read.error().detail;
    };
    EXPECT_THAT(problem("\nname =\n"), StartsWith("here:2: "));
    EXPECT_THAT(problem("\nname = 1\nname = 2\n"), StartsWith("here:3: "));
    EXPECT_THAT(problem("name = 1\n\nrate = inf\n"),
                StartsWith("here:3: 'rate' is neither text, a number"));
    EXPECT_THAT(problem("[a]\nb = 1\n"), StartsWith("here:1: 'a' is neither text"));
    EXPECT_THAT(problem("list = [\n1,\n[2]]\n"), StartsWith("here:3: 'list' is neither text"));
    EXPECT_THAT(problem("day = 2020-01-01\n"), HasSubstr("'day' is neither text"));
}

} // namespace
} // namespace cd::tests
