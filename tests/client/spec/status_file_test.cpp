// Proves how files of statuses are read, and that mistakes are named with their line.
#include "client/spec/status_file.hpp"

#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;

std::string error_of(const std::string& text) {
    const auto rules = parse_statuses(text, "s.toml");
    return rules ? "no error" : rules.error().detail;
}

} // namespace

TEST(PartPattern, SplitsAtTheFirstPlainSlash) {
    const PartPattern plain = PartPattern::from_text("wheel_*");
    EXPECT_FALSE(plain.body);
    EXPECT_TRUE(plain.is_of_part("wheel_left"));
    EXPECT_TRUE(plain.is_of_body("any"));
    const PartPattern of_body = PartPattern::from_text("van/wheel?");
    EXPECT_TRUE(of_body.is_of_body("van"));
    EXPECT_FALSE(of_body.is_of_body("vans"));
    EXPECT_TRUE(of_body.is_of_part("wheels"));
    const PartPattern escaped = PartPattern::from_text("a\\/b\\*");
    EXPECT_FALSE(escaped.body);
    EXPECT_TRUE(escaped.is_of_part("a/b*"));
    EXPECT_FALSE(escaped.is_of_part("a/bc"));
}

TEST(StatusFile, HasATableForEachDecision) {
    const TemporaryFolder folder;
    write_text(
        folder / "s.toml",
        "[[clash]]\na = \"bumper\"\nb = \"post\"\nstatus = \"approved\"\nnote = \"wanted\"\n"
        "pairs_max = 400\n\n[[clash]]\na = \"*\"\nb = \"car/door\"\nstatus = \"reviewed\"\n");
    const auto rules = read_status_file(folder / "s.toml");
    ASSERT_TRUE(rules) << rules.error().detail;
    ASSERT_EQ(rules.value().size(), 2u);
    const StatusRule& first = rules.value()[0];
    EXPECT_TRUE(first.is_approved);
    EXPECT_EQ(first.note, "wanted");
    EXPECT_EQ(first.pairs_max, 400u);
    EXPECT_TRUE(first.a.is_of_part("bumper"));
    const StatusRule& second = rules.value()[1];
    EXPECT_FALSE(second.is_approved);
    EXPECT_FALSE(second.pairs_max);
    EXPECT_EQ(second.b.body, "car");
    EXPECT_THAT(second.place, HasSubstr("s.toml:8: clash \"*\", \"car/door\""));
    EXPECT_TRUE(parse_statuses("", "s.toml").value().empty());
    EXPECT_EQ(read_status_file(folder / "none.toml").error().code, ErrorCode::NotFound);
}

TEST(StatusFile, MistakesAreNamedWithTheirLine) {
    EXPECT_THAT(error_of("[[clash]]\na = \"x\"\nb = \"y\"\nstatus = \"aproved\"\n"),
                HasSubstr("s.toml:4: clash: status \"aproved\" is not known; did you mean "
                          "\"approved\"?"));
    EXPECT_THAT(error_of("[[clash]]\nb = \"y\"\nstatus = \"approved\"\n"),
                HasSubstr("s.toml:1: clash: a is missing"));
    EXPECT_THAT(error_of("[[clash]]\na = \"x\"\nb = \"y\"\n"), HasSubstr("status is missing"));
    EXPECT_THAT(error_of("[[clash]]\na = \"x\"\nb = \"y\"\nstatus = \"reviewed\"\npair_max = 1\n"),
                HasSubstr("s.toml:5: clash has no key \"pair_max\"; did you mean \"pairs_max\"?"));
    EXPECT_THAT(
        error_of("[[clash]]\na = \"x\"\nb = \"y\"\nstatus = \"reviewed\"\npairs_max = -1\n"),
        HasSubstr("s.toml:5: clash: pairs_max = -1 is not between 0"));
    EXPECT_THAT(error_of("[[clashes]]\n"), HasSubstr("s.toml:1: the file has no key \"clashes\""));
    EXPECT_THAT(error_of("clash = 1\n"), HasSubstr("has to be an array"));
    EXPECT_THAT(error_of("clash = [1]\n"), HasSubstr("clash has to be a table"));
    EXPECT_THAT(error_of("[[clash]\n"), HasSubstr("s.toml:1: "));
}

} // namespace cd::tests
