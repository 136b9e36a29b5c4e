// Makes the text that --version prints: the program's name, version and build.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cd {

/// Returns the hash of the commit that was built; "unknown" outside a git checkout.
[[nodiscard]] std::string_view build_commit();

/// Returns a line such as "cdctl 0.1.0" and one line each for commit, compiler, SIMD target and
/// libraries. With `as_json`, returns a JSON object with the keys program, version, commit,
/// compiler, simd and libraries.
[[nodiscard]] std::string
version_text(std::string_view program, std::string_view simd_target, bool as_json);

/// Returns the text for the arguments `--version` or `--version -o json`, else nothing.
[[nodiscard]] std::optional<std::string> version_answer(std::string_view program,
                                                        std::string_view simd_target,
                                                        std::span<const std::string> arguments);

} // namespace cd
