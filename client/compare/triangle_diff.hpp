// Which triangles are in contact in only one of two runs.
#pragma once

#include "client/compare/paired_results.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cd {

/// Numbers of triangles of a body that are in contact in any compared scenario.
struct TriangleCounts {
    std::uint64_t in_both = 0;
    std::uint64_t only_earlier = 0;
    std::uint64_t only_later = 0;
};

/// A triangle and the numbers of scenarios in which it is in contact.
struct TriangleChange {
    std::uint32_t triangle = 0;
    std::uint64_t earlier = 0;
    std::uint64_t later = 0;

    friend bool operator==(const TriangleChange&, const TriangleChange&) = default;
};

/// Compares the contact maps of two runs over the scenarios that both tested. A triangle's number
/// means the same in both runs only if the body's mesh is equal. Memory: 16 bytes for each triangle
/// up to the last one in contact.
class TriangleDiff {
  public:
    /// Adds the listed pairs of a scenario, if both runs tested it.
    void add(const PairedResult& pair);
    /// Adds whole contact maps, of the same scenarios in both runs.
    void add(const ContactMap& earlier, const ContactMap& later);

    /// Returns the triangles of body A (0) or B (1) in other numbers of scenarios, ascending.
    [[nodiscard]] std::vector<TriangleChange> changes(std::size_t body);
    [[nodiscard]] TriangleCounts counts(std::size_t body);

  private:
    /// The map of one run; the latest results are not yet in `total`.
    struct Map {
        ContactMapSum latest;
        ContactMapTotal total;

        void add(const ScenarioResult& result);
        [[nodiscard]] ContactMap whole();
    };

    [[nodiscard]] std::vector<TriangleChange> all(std::size_t body);

    Map earlier_;
    Map later_;
};

} // namespace cd
