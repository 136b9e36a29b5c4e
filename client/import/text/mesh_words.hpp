// Words and numbers in the text of mesh files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Splits a text into words at blanks and line ends.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    /// The next word; empty at the end of the text.
    [[nodiscard]] std::string_view next();

  private:
    std::string_view rest_;
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
[[nodiscard]] std::optional<std::uint64_t> to_whole(std::string_view word);

} // namespace cd
