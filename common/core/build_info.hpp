// The answer to --version: what a program is and what it was built from.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// The commit that was built; "unknown" outside a git checkout.
[[nodiscard]] std::string_view build_commit();

/// "cdctl 0.1.0" and a line each for commit, compiler, SIMD target and libraries; as JSON an object
/// with the keys program, version, commit, compiler, simd and libraries.
[[nodiscard]] std::string
version_text(std::string_view program, std::string_view simd_target, bool as_json);

/// The answer to the arguments `--version` and `--version -o json`; nothing for all others.
[[nodiscard]] std::optional<std::string> version_answer(std::string_view program,
                                                        std::string_view simd_target,
                                                        std::span<const std::string> arguments);

} // namespace cd
