// Completion of command lines of cdctl in a shell, from the verbs and options that cdctl parses.
#pragma once

#include "client/cli/cli.hpp"

#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
} // namespace CLI

namespace cd {

/// Returns how the last of `words`, which may be empty, can go on. `words` are those of a command
/// line after the program's name; a shell may give --option=value in three words.
[[nodiscard]] CompleteCommand complete_words(const CLI::App& app,
                                             std::span<const std::string> words);

/// Returns the script that completes cdctl in bash, zsh or fish.
[[nodiscard]] std::string_view completion_script(std::string_view shell);

} // namespace cd
