#include "client/import/text/text_reader.hpp"

#include "client/formats/output_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace cd {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

} // namespace

TextReader::TextReader(std::string_view text, Backslash backslash, std::uint64_t first_line)
    : at_(text.data()), end_(text.data() + text.size()), line_(first_line), backslash_(backslash) {}

bool TextReader::is_at_joint() const {
    return backslash_ == Backslash::JoinsLines && *at_ == '\\' && at_ + 1 != end_ &&
           is_line_end(at_[1]);
}

void TextReader::pass_line_end() {
    const bool is_pair = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
    at_ += is_pair ? 2 : 1;
    ++line_;
}

void TextReader::skip_blanks() {
    while (at_ != end_) {
        if (is_blank(*at_)) {
            ++at_;
        } else if (is_at_joint()) {
            ++at_;
            pass_line_end();
        } else {
            return;
        }
    }
}

std::string_view TextReader::word_in_line() {
    skip_blanks();
    const char* const begin = at_;
    while (at_ != end_ && !is_blank(*at_) && !is_line_end(*at_) && !is_at_joint()) {
        ++at_;
    }
    return {begin, at_};
}

std::string_view TextReader::word() {
    skip_blanks();
    while (at_ != end_ && is_line_end(*at_)) {
        pass_line_end();
        skip_blanks();
    }
    return word_in_line();
}

std::string_view TextReader::rest_of_line() {
    while (at_ != end_ && is_blank(*at_)) {
        ++at_;
    }
    const char* const begin = at_;
    at_ = std::find_if(at_, end_, is_line_end);
    const char* last = at_;
    while (last != begin && is_blank(last[-1])) {
        --last;
    }
    return {begin, last};
}

std::string_view without_utf8_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    text.remove_prefix(text.starts_with(mark) ? mark.size() : 0);
    return text;
}

std::string read_text(const std::filesystem::path& path) {
    const auto text = read_file(path);
    return text ? std::string(without_utf8_mark(text.value())) : "";
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t shown_max = 40;
    std::string shown(word.substr(0, shown_max));
    std::ranges::replace_if(
        shown, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return "'" + shown + (word.size() > shown_max ? "...'" : "'");
}

std::optional<double> to_number(std::string_view word) {
    const bool has_plus = word.starts_with('+');
    word.remove_prefix(has_plus ? 1 : 0);
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [behind, error] = std::from_chars(word.data(), end, value);
    const bool is_whole = behind == end && !word.empty();
    if (!is_whole || error == std::errc::invalid_argument || (has_plus && word[0] == '-')) {
        return std::nullopt;
    }
    // `strtod` returns infinity or 0 for a number that no double holds; `from_chars` fails.
    return error == std::errc() ? value : std::strtod(std::string(word).c_str(), nullptr);
}

bool equals_lower(std::string_view word, std::string_view lower) {
    const auto is_same = [](char c, char small) {
        return c == small || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == small);
    };
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), is_same);
}

} // namespace cd
