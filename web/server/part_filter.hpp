// Selects the scenarios in which parts of bodies are in contact or near.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/result.hpp"
#include "web/server/page_request.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// Returns the parts of a body as the groups of a job name them.
using PartsOfBody = std::function<Result<std::shared_ptr<const NamedParts>>(std::uint32_t body)>;

class PartFilter {
  public:
    /// Makes a filter that passes all results.
    PartFilter() = default;
    /// Makes a filter for the parts that a search names, in a job with these bodies. Errors:
    /// BadInput if there is no such body or part, or if a part of a scene has no body; those of
    /// `parts`.
    [[nodiscard]] static Result<PartFilter>
    make(std::span<const std::string> bodies, const PartsOfBody& parts, const NextContact& wanted);

    /// True if the filter passes all results.
    [[nodiscard]] bool is_empty() const { return wanted_.empty(); }
    /// True if the result is of the bodies of all these parts, and lists a pair of triangles of
    /// them that the search means.
    [[nodiscard]] bool passes(const ScenarioResult& result) const;

  private:
    /// A part of a body.
    struct Wanted {
        std::uint32_t body = 0;
        std::uint32_t part = 0;
        std::shared_ptr<const NamedParts> parts; ///< All parts of the body.

        /// True if the body takes part in the scenario.
        [[nodiscard]] bool is_in(const ScenarioHead& result) const {
            return result.body_a == body || result.body_b == body;
        }
        /// True if the pair's triangle of the body is of the part.
        [[nodiscard]] bool has(const ScenarioHead& result, const ContactPair& pair) const;
    };

    std::vector<Wanted> wanted_; ///< At most two.
    NextContact next_;
};

} // namespace cd
