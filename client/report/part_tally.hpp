// Counts for each part the scenarios in which it was touched.
#pragma once

#include "client/formats/part_finder.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Takes results of level pairs and above.
class PartTally {
  public:
    /// `meshes` of all bodies, in the order of their indices in results.
    explicit PartTally(const std::vector<std::shared_ptr<const Mesh>>& meshes);

    /// The result's bodies must be among the meshes.
    void add(const ScenarioResult& result);

    struct Touched {
        std::string part;
        std::uint64_t scenarios = 0;
    };
    /// The most touched parts first, without parts never touched and bodies with a single part.
    [[nodiscard]] std::vector<Touched> most_touched(std::size_t count = 3) const;

  private:
    struct Body {
        PartFinder parts;
        std::vector<std::uint64_t> scenarios; ///< For each part.
        std::vector<std::uint64_t> last_seen; ///< For each part: stamp of the last result with it.
    };
    static void note(Body& body, std::uint32_t triangle, std::uint64_t stamp);

    std::vector<Body> bodies_;
    std::uint64_t stamp_ = 0; ///< Counts results.
};

} // namespace cd
