// Proves that a decimal number becomes the nearest double, however it is spelled.
#include "client/import/text/text_reader.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace cd::tests {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns digits with a point somewhere, and perhaps an exponent.
std::string random_decimal(std::mt19937_64& random) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const std::uint64_t digits = 1 + random() % 30;
    const std::uint64_t point = random() % (digits + 1);
    for (std::uint64_t i = 0; i < digits; ++i) {
        text += i == point ? "." : "";
        text += static_cast<char>('0' + random() % 10);
    }
    if (random() % 2 == 0) {
        text += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
    }
    return text;
}

} // namespace

TEST(TextReader, NumbersAreTheNearestDoubles) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const std::string text = random_decimal(random);
        ASSERT_EQ(to_number(text), std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(TextReader, WhatDoublesDoNotHoldIsInfiniteOrZero) {
    EXPECT_EQ(to_number("1e400"), infinite);
    EXPECT_EQ(to_number("-1e+400"), -infinite);
    EXPECT_EQ(to_number("-" + std::string(400, '9') + ".5"), -infinite);
    EXPECT_EQ(to_number("0." + std::string(400, '0') + "1e401"), 1.0);
    EXPECT_EQ(to_number("1e-400"), 0.0);
    EXPECT_EQ(to_number("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(to_number("1e99999999999999999999"), infinite);
    EXPECT_EQ(to_number("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(to_number("0e99999999999999999999"), 0.0);
}

TEST(TextReader, OtherWordsAreNoNumbers) {
    for (const char* word :
         {"", "+", "-", ".", "e1", "1e", "0x10", "1d5", "1,5", "+-1", "--1", "1 ", "1#"}) {
        EXPECT_FALSE(to_number(word)) << word;
    }
}

TEST(TextReader, WordsInMessagesAreShortAndPlain) {
    EXPECT_EQ(in_quotes("F"), "'F'");
    EXPECT_EQ(in_quotes("a\x1b[1m\n"), "'a?[1m?'");
    EXPECT_EQ(in_quotes(std::string(1000, 'x')).size(), 45u);
}

TEST(TextReader, WordsAndLines) {
    TextReader text("  one two\r\n\n three \rfour");
    EXPECT_EQ(text.word_in_line(), "one");
    EXPECT_EQ(text.rest_of_line(), "two");
    EXPECT_EQ(text.word_in_line(), "");
    EXPECT_EQ(text.line(), 1u);
    EXPECT_EQ(text.word(), "three");
    EXPECT_EQ(text.line(), 3u);
    EXPECT_EQ(text.word(), "four");
    EXPECT_EQ(text.line(), 4u);
    EXPECT_EQ(text.word(), "");
}

TEST(TextReader, ABackslashJoinsLinesWhereItShould) {
    TextReader joined("a\\\n b \\\r\nc\\d \\\ne", TextReader::Backslash::JoinsLines);
    EXPECT_EQ(joined.word_in_line(), "a");
    EXPECT_EQ(joined.word_in_line(), "b");
    EXPECT_EQ(joined.word_in_line(), "c\\d");
    EXPECT_EQ(joined.word_in_line(), "e");
    EXPECT_EQ(joined.line(), 4u);
    TextReader plain("a\\\nb");
    EXPECT_EQ(plain.word_in_line(), "a\\");
    EXPECT_EQ(plain.word_in_line(), "");
}

} // namespace cd::tests
