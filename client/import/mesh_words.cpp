#include "client/import/mesh_words.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

namespace cd {

namespace {

constexpr std::string_view blanks = " \t\r\n";

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

std::optional<double> to_number(std::string_view word) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && !word.empty();
    return whole && error != std::errc::invalid_argument ? std::optional(value) : std::nullopt;
}

std::optional<std::uint64_t> to_whole(std::string_view word) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && !word.empty();
    return whole && error == std::errc{} ? std::optional(value) : std::nullopt;
}

} // namespace cd
