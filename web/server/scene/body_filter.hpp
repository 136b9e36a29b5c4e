// Selects the scenarios in which one body of a job takes part.
#pragma once

#include "common/core/result.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace cd {

/// Returns the number of a body by its name, or else its number in `names`. Errors: BadInput if
/// there is no such body.
[[nodiscard]] Result<std::uint32_t> body_number(std::span<const std::string> names,
                                                const std::string& wanted);

class BodyFilter {
  public:
    /// Makes a filter that passes all results.
    BodyFilter() = default;
    /// Makes a filter for the body of this name or number; an empty text passes all results.
    /// Errors: as `body_number`.
    [[nodiscard]] static Result<BodyFilter> make(std::span<const std::string> names,
                                                 const std::string& wanted);

    /// True if the filter passes all results.
    [[nodiscard]] bool is_empty() const { return !body_; }
    [[nodiscard]] bool passes(const ScenarioHead& result) const {
        return !body_ || result.body_a == *body_ || result.body_b == *body_;
    }

  private:
    std::optional<std::uint32_t> body_;
};

} // namespace cd
