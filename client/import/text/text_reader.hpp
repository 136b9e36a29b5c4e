// Splits a text into words and counts lines.
#pragma once

#include <cstdint>
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

    /// Moves to the start of the next line. False at the end of the text.
    bool next_line();

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

/// True when the words are equal but for upper and lower case of ASCII letters. `lower` is in
/// lower case.
[[nodiscard]] bool equals_lower(std::string_view word, std::string_view lower);

} // namespace cd
