#include "client/import/text/mesh_words.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>

namespace cd {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The value of a decimal number that is out of the range of doubles: infinity or 0.
double beyond_doubles(std::string_view word) {
    const bool is_negative = word.starts_with('-');
    word.remove_prefix(is_negative ? 1 : 0);
    const std::string_view digits = word.substr(0, word.find_first_of("eE"));
    std::string_view exponent_text = word.substr(std::min(word.size(), digits.size() + 1));
    exponent_text.remove_prefix(exponent_text.starts_with('+') ? 1 : 0);
    std::int64_t exponent = 0;
    const auto [end, error] = std::from_chars(
        exponent_text.data(), exponent_text.data() + exponent_text.size(), exponent);
    if (error == std::errc::result_out_of_range) {
        exponent = exponent_text.starts_with('-') ? std::numeric_limits<std::int64_t>::min() / 2
                                                  : std::numeric_limits<std::int64_t>::max() / 2;
    }
    // The position of the first digit other than 0, before or after the point.
    const std::size_t nonzero = digits.find_first_of("123456789");
    const auto point = static_cast<std::int64_t>(std::min(digits.size(), digits.find('.')));
    const bool is_large =
        nonzero != digits.npos && exponent + point - static_cast<std::int64_t>(nonzero) > 0;
    const double size = is_large ? std::numeric_limits<double>::infinity() : 0.0;
    return is_negative ? -size : size;
}

} // namespace

std::string_view Words::next() {
    const std::size_t begin = rest_.find_first_not_of(blanks);
    if (begin == std::string_view::npos) {
        rest_ = {};
        return {};
    }
    rest_.remove_prefix(begin);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    return word;
}

std::string_view without_utf8_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    text.remove_prefix(text.starts_with(mark) ? mark.size() : 0);
    return text;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    std::string text = std::move(bytes).str();
    text.erase(0, text.size() - without_utf8_mark(text).size());
    return text;
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t shown_max = 40;
    std::string shown(word.substr(0, shown_max));
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return "'" + shown + (word.size() > shown_max ? "...'" : "'");
}

std::optional<double> to_number(std::string_view word) {
    const bool has_plus = word.starts_with('+');
    word.remove_prefix(has_plus ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && !word.empty();
    if (!whole || error == std::errc::invalid_argument || (has_plus && word[0] == '-')) {
        return std::nullopt;
    }
    return error == std::errc::result_out_of_range ? beyond_doubles(word) : value;
}

std::optional<std::uint64_t> to_whole(std::string_view word) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && !word.empty();
    return whole && error == std::errc{} ? std::optional(value) : std::nullopt;
}

} // namespace cd
