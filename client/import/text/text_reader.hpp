// Words, lines and numbers in the text of mesh files.
#pragma once

#include "client/base/words.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Lines end with "\n", "\r\n" or "\r". Words are separated by blanks and line ends.
class TextReader {
  public:
    /// The meaning of a backslash at the end of a line: text, or the line goes on in the next one.
    enum class Backslash { IsText, JoinsLines };

    explicit TextReader(std::string_view text,
                        Backslash backslash = Backslash::IsText,
                        std::uint64_t first_line = 1);

    /// The next word of this line; empty at the line's end.
    [[nodiscard]] std::string_view word_in_line();
    /// The next word of this line or a later one; empty at the end of the text.
    [[nodiscard]] std::string_view word();
    /// The rest of this line without surrounding blanks. A backslash does not continue it.
    std::string_view rest_of_line();

    /// The number of the current line, from 1.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    /// The text that has not been read yet.
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

/// The text without a UTF-8 byte order mark.
[[nodiscard]] std::string_view without_utf8_mark(std::string_view text);

/// The content of a file without a byte order mark; empty if unreadable.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// The word in single quotes for a message, shortened, and without control characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// The double nearest to a decimal number with a '.'; nothing if the word is not a number. The
/// result may be infinite or NaN.
[[nodiscard]] std::optional<double> to_number(std::string_view word);

/// An unsigned integer; nothing if the word holds anything but digits.
[[nodiscard]] inline std::optional<std::uint64_t> to_whole(std::string_view word) {
    return number_in<std::uint64_t>(word);
}

/// True when the words are equal but for upper and lower case of ASCII letters. `lower` is in
/// lower case.
[[nodiscard]] bool equals_lower(std::string_view word, std::string_view lower);

} // namespace cd
