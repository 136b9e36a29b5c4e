// Messages for wrong usage of cdctl, which suggest the intended word.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace cd {

/// Returns what `cdctl` prints without arguments: ten lines of examples.
[[nodiscard]] std::string first_steps();

/// Returns a line without newline about the first unknown verb or option in `arguments` (without
/// the program's name), with the most similar known one; nothing if all are known.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app,
                                                      const std::vector<std::string>& arguments);

} // namespace cd
