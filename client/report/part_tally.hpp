// Counts the scenarios in which each part is touched.
#pragma once

#include "client/formats/part_finder.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Counts, for each part, the scenarios that list a pair with one of the part's triangles. Results
/// below `level pairs` list no pairs.
class PartTally {
  public:
    /// `meshes` holds the mesh of each body, by the index that results give the body.
    explicit PartTally(const std::vector<std::shared_ptr<const Mesh>>& meshes);

    /// Counts a result, whose bodies must have meshes.
    void add(const ScenarioResult& result);

    struct Touched {
        std::string part;
        std::uint64_t scenarios = 0;
    };
    /// Returns the `count` parts in contact in most scenarios, most first. Leaves out parts never
    /// in contact, and bodies with a single part.
    [[nodiscard]] std::vector<Touched> most_touched(std::size_t count = 3) const;

  private:
    struct Body {
        PartFinder parts;
        std::vector<std::uint64_t> scenarios; ///< Number of scenarios, by part.
        std::vector<std::uint64_t> last_seen; ///< `stamp_` of the last result counted, by part.
    };
    static void note(Body& body, std::uint32_t triangle, std::uint64_t stamp);

    std::vector<Body> bodies_;
    std::uint64_t stamp_ = 0; ///< Number of results added so far.
};

} // namespace cd
