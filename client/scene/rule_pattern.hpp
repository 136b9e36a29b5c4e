// The patterns by which rules name bodies and their parts.
#pragma once

#include "client/groups/part_pattern.hpp"
#include "client/scene/scene_bodies.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// Consecutive triangles: the first, and one past the last.
using TriangleRange = std::pair<std::uint32_t, std::uint32_t>;

/// A pattern "body", "body/part", "group:NAME" or "group:NAME/part" with the wildcards of a shell.
class RulePattern {
  public:
    [[nodiscard]] static RulePattern from_text(std::string_view text);

    /// True if the pattern names parts. Otherwise it names bodies with all their triangles.
    [[nodiscard]] bool has_part() const { return part_.has_value(); }
    /// Returns the bodies that have triangles which the pattern names, ascending. Errors: BadInput
    /// with the names that exist, if there are none.
    [[nodiscard]] Result<std::vector<std::uint32_t>> bodies_of(const SceneBodies& scene) const;
    /// Returns the triangles of a mesh that the pattern names, with adjacent ranges joined.
    [[nodiscard]] std::vector<TriangleRange> ranges_of(const Mesh& mesh) const;

  private:
    [[nodiscard]] bool names(const NamedBody& body) const;
    [[nodiscard]] Error no_body(const SceneBodies& scene) const;
    [[nodiscard]] Error no_part(const SceneBodies& scene,
                                const std::vector<std::uint32_t>& bodies) const;

    std::string text_;
    bool is_group_ = false;
    std::string body_; ///< The pattern of a body's name, or of its group's.
    std::optional<std::string> part_;
};

} // namespace cd
