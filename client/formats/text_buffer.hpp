// A text to which pieces are appended without making a string of each, for rows of files.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace cd {

class TextBuffer {
  public:
    /// Appends pieces: text, integers in decimal, doubles as the shortest decimal that reads back
    /// as the same number.
    template <class... Pieces>
    void add(const Pieces&... pieces) {
        (add_piece(pieces), ...);
    }

    [[nodiscard]] std::string_view text() const { return text_; }
    /// Clears the text and keeps its memory.
    void clear() { text_.clear(); }

  private:
    void add_piece(std::string_view text) { text_.append(text); }
    template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
    void add_piece(Number number) {
        static_assert(!std::same_as<Number, char> && !std::same_as<Number, bool>);
        char digits[32]; // NOLINT(modernize-avoid-c-arrays): not set first.
        text_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    }

    std::string text_;
};

} // namespace cd
