// Selects the scenarios in which two parts are in contact.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cd {

class PartFilter {
  public:
    /// Makes a filter that passes all results.
    PartFilter() = default;
    /// Makes a filter for triangles of A and B, by their numbers; an empty list stands for all.
    PartFilter(std::vector<bool> a, std::vector<bool> b) : a_(std::move(a)), b_(std::move(b)) {}
    /// Makes a filter for the parts of A and B with these names; an empty name stands for all
    /// triangles. Errors: BadInput if a mesh has no such part.
    [[nodiscard]] static Result<PartFilter>
    make(const Mesh& a, const std::string& part_a, const Mesh& b, const std::string& part_b);

    /// True if the filter passes all results.
    [[nodiscard]] bool is_empty() const { return a_.empty() && b_.empty(); }
    /// True if the result lists a pair of triangles of both parts.
    [[nodiscard]] bool passes(const ScenarioResult& result) const;

  private:
    std::vector<bool> a_;
    std::vector<bool> b_;
};

} // namespace cd
