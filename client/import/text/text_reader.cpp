#include "client/import/text/text_reader.hpp"

#include <algorithm>

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

bool TextReader::next_line() {
    at_ = std::find_if(at_, end_, is_line_end);
    if (at_ == end_) {
        return false;
    }
    pass_line_end();
    return at_ != end_;
}

bool equals_lower(std::string_view word, std::string_view lower) {
    const auto is_same = [](char c, char small) {
        return c == small || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == small);
    };
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), is_same);
}

} // namespace cd
