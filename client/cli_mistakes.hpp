// Wrong usage of cdctl, told with the word that was probably meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace cd {

/// What `cdctl` alone prints: ten lines of things to type.
[[nodiscard]] std::string first_steps();

/// One line without its end for the first verb or option that `app` does not have, with the nearest
/// one that it has; nothing where all are known. `arguments` are as typed, without the program.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app,
                                                      const std::vector<std::string>& arguments);

} // namespace cd
