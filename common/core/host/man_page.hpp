// A manual page from a program's options, in the language of man(7).
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
} // namespace CLI

namespace cd {

/// Returns the page of a program, with all its options and subcommands. `summary` is its line in
/// NAME; a subcommand's is the first line of its description. The date is that of
/// SOURCE_DATE_EPOCH, or today.
[[nodiscard]] std::string man_page(const CLI::App& app, int section, std::string_view summary);

} // namespace cd
