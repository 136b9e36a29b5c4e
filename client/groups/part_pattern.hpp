// Patterns that name parts of bodies, in job files and in files of statuses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// A pattern "part" or "body/part" with the wildcards of a shell; a backslash makes the next of
/// / * ? [ an ordinary character.
struct PartPattern {
    std::optional<std::string> body; ///< Nothing: any body.
    std::string part;

    /// Splits a pattern at the first slash that is not escaped.
    [[nodiscard]] static PartPattern from_text(std::string_view text);

    [[nodiscard]] bool is_of_body(const std::string& name) const;
    [[nodiscard]] bool is_of_part(const std::string& name) const;
};

} // namespace cd
