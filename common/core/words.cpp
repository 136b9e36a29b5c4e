#include "common/core/words.hpp"

#include "common/core/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Returns the optimal string alignment distance: Levenshtein's distance in which swapping two
/// neighbouring characters is one edit. It is computed row by row.
std::size_t edits_between(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) {
        row[j] = j;
    }
    std::vector<std::size_t> above = row;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::vector<std::size_t> above_that = std::exchange(above, row);
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = above[j] + (from[i] == to[j] ? 0 : 1);
            row[j + 1] = std::min({replaced, above[j + 1] + 1, row[j] + 1});
            if (i > 0 && j > 0 && from[i] == to[j - 1] && from[i - 1] == to[j]) {
                row[j + 1] = std::min(row[j + 1], above_that[j - 1] + 1);
            }
        }
    }
    return row.back();
}

/// Longer words, which may come from a file, get no suggestion: comparing them takes too long.
constexpr std::size_t word_length_max = 64;
constexpr std::size_t words_listed_max = 20; ///< In an error.

} // namespace

std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known) {
    if (word.size() > word_length_max) {
        return std::nullopt;
    }
    std::optional<std::string_view> nearest;
    std::size_t edits_min = std::max<std::size_t>(1, word.size() / 2) + 1;
    for (const std::string_view candidate : known) {
        const std::size_t edits = edits_between(word, candidate);
        if (edits < edits_min) {
            edits_min = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    if (const auto nearest = nearest_word(word, known)) {
        return "; did you mean \"" + std::string(*nearest) + "\"?";
    }
    const auto listed = known.first(std::min(known.size(), words_listed_max));
    return fmt::format(
        "; known are {}{}", fmt::join(listed, ", "), listed.size() < known.size() ? ", ..." : "");
}

std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t end = text.size(); end > 3; end -= 3) {
        text.insert(end - 3, 1, ' ');
    }
    return text;
}

std::string exact_text(double value) {
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.begin(), buffer.end(), value).ptr};
}

std::string fixed_text(double value, int digits) {
    return fmt::format("{:.{}f}", value, digits);
}

std::string rate_text(double per_second) {
    if (per_second >= 999'500) {
        return fixed_text(per_second / 1e6, 1) + " M";
    }
    if (per_second >= 9'999.5) {
        return fixed_text(per_second / 1e3, 1) + " k";
    }
    return fixed_text(per_second, per_second < 10 ? 1 : 0);
}

std::string counted(std::uint64_t number, std::string_view noun) {
    return grouped(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

std::string csv_field(std::string_view given) {
    const std::string text = valid_utf8(given);
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string field = "\"";
    for (const char c : text) {
        field += (c == '"') ? "\"\"" : std::string(1, c);
    }
    return field + "\"";
}

} // namespace cd
