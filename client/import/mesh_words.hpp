// Words and numbers in the text of mesh files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// The words of a text in turn, separated by blanks and line ends.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    /// A part of the text; empty at its end.
    [[nodiscard]] std::string_view next();

  private:
    std::string_view rest_;
};

/// Without the mark of UTF-8 that some programs write at the beginning.
[[nodiscard]] std::string_view without_utf8_mark(std::string_view text);

/// All bytes of a file but that mark; empty if unreadable.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// The word in single quotes, for a message: cut where it is long, without control characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// The double nearest to a decimal number that is the whole word, with '.' before its fraction; may
/// be infinite or NaN.
[[nodiscard]] std::optional<double> to_number(std::string_view word);

/// A number of digits alone that is the whole word.
[[nodiscard]] std::optional<std::uint64_t> to_whole(std::string_view word);

} // namespace cd
