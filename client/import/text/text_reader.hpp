// Words, lines and numbers in the text of mesh files.
#pragma once

#include "common/core/words.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Reads a text by words. Lines end with "\n", "\r\n" or "\r"; blanks separate words.
class TextReader {
  public:
    /// How a backslash at a line's end is read: as text, or as joining the next line to this one.
    enum class Backslash { IsText, JoinsLines };

    explicit TextReader(std::string_view text,
                        Backslash backslash = Backslash::IsText,
                        std::uint64_t first_line = 1);

    /// Returns the next word of this line; empty at the line's end.
    [[nodiscard]] std::string_view word_in_line();
    /// Returns the next word of this line or a later one; empty at the end of the text.
    [[nodiscard]] std::string_view word();
    /// Returns the rest of this line without surrounding blanks. A backslash joins no lines here.
    std::string_view rest_of_line();

    /// Returns the number of the current line, from 1.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    /// Returns the text that has not been read yet.
    [[nodiscard]] std::string_view rest() const { return {at_, end_}; }

  private:
    [[nodiscard]] bool is_at_joint() const;
    void pass_line_end();
    void skip_blanks();

    const char* at_;
    const char* end_;
    std::uint64_t line_;
    Backslash backslash_;
};

/// Returns the text without a UTF-8 byte order mark at its beginning.
[[nodiscard]] std::string_view without_utf8_mark(std::string_view text);

/// Reads a file without its byte order mark; returns an empty text for an unreadable file.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// Quotes a word for a message, shortened, with control characters replaced.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Returns the double nearest to a decimal number with a '.'; nothing if the word is not a number.
/// The result may be infinite or NaN.
[[nodiscard]] std::optional<double> to_number(std::string_view word);

/// Reads an unsigned integer; returns nothing if the word holds anything but digits.
[[nodiscard]] inline std::optional<std::uint64_t> to_whole(std::string_view word) {
    return number_in<std::uint64_t>(word);
}

/// True if `word` equals `lower`, which is in lower case; upper and lower case of ASCII letters in
/// `word` are equal.
[[nodiscard]] bool equals_lower(std::string_view word, std::string_view lower);

} // namespace cd
