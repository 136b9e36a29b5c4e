// Words of command lines that a user may copy into a shell.
#pragma once

#include <string>
#include <string_view>

namespace cd {

/// Returns a word as a POSIX shell reads it: as it is, or in single quotes if a character has a
/// meaning to the shell (POSIX.1-2017, Shell Command Language, section 2.2).
[[nodiscard]] std::string shell_word(std::string_view word);

} // namespace cd
