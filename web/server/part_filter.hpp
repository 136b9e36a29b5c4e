// Selects the scenarios in which two parts are in contact or near.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/result.hpp"
#include "web/server/page_request.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace cd {

/// The parts of A ([0]) and B ([1]) as the groups of a job name them.
using PartsOfBodies = std::array<std::shared_ptr<const NamedParts>, 2>;

class PartFilter {
  public:
    /// Makes a filter that passes all results.
    PartFilter() = default;
    /// Makes a filter for the parts that a search names. Errors: BadInput if a body has no such
    /// part.
    [[nodiscard]] static Result<PartFilter> make(const PartsOfBodies& parts,
                                                 const NextContact& wanted);

    /// True if the filter passes all results.
    [[nodiscard]] bool is_empty() const { return !wanted_[0] && !wanted_[1]; }
    /// True if the result lists a pair of triangles of both parts that the search means.
    [[nodiscard]] bool passes(const ScenarioResult& result) const;

  private:
    [[nodiscard]] bool has(std::size_t body, std::uint32_t triangle) const;

    PartsOfBodies parts_;
    NextContact next_;
    std::array<std::optional<std::uint32_t>, 2> wanted_; ///< Number of the part; nothing: any.
};

} // namespace cd
