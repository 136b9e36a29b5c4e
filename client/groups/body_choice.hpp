// The bodies that a report is about.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// All bodies of a run, or those that a user names.
class BodyChoice {
  public:
    /// Chooses those of the `bodies` that have one of these names; without names, all. Errors:
    /// BadInput for a name that no body has, with the nearest one.
    [[nodiscard]] static Result<BodyChoice> of_names(std::span<const std::string> names,
                                                     std::span<const std::string> bodies);

    [[nodiscard]] bool is_all() const { return is_chosen_.empty(); }
    /// True if a scenario of these two bodies is about a chosen one.
    [[nodiscard]] bool has(std::uint32_t body_a, std::uint32_t body_b) const {
        return is_all() || is_chosen_[body_a] || is_chosen_[body_b];
    }
    /// The names as they were given, with commas.
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::vector<bool> is_chosen_; ///< Of each body; empty: all are.
    std::string text_;
};

} // namespace cd
