// To which part each triangle of a mesh belongs, by runs of consecutive triangles.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// Consecutive triangles of one part, up to the begin of the next run.
struct PartRun {
    std::uint32_t begin = 0; ///< The first triangle.
    std::uint32_t part = 0;  ///< Number of the part.

    friend bool operator==(const PartRun&, const PartRun&) = default;
};

/// Assigns each triangle of a mesh to a numbered part. Memory: eight bytes a run.
class PartRuns {
  public:
    /// One part with all triangles.
    PartRuns() = default;
    /// Takes runs that begin with triangle 0 and ascend. Errors: BadInput for other runs, and for a
    /// number above `limits::parts_max`.
    [[nodiscard]] static Result<PartRuns> create(std::vector<PartRun> runs);

    [[nodiscard]] const std::vector<PartRun>& runs() const { return runs_; }
    /// Returns one more than the greatest number of a part.
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Returns the index of the run that has the triangle.
    [[nodiscard]] std::size_t run_of(std::uint32_t triangle) const;
    /// Returns one past the last triangle of a run; the last run has no end.
    [[nodiscard]] std::uint32_t end_of(std::size_t run) const;

  private:
    explicit PartRuns(std::vector<PartRun> runs);

    std::vector<PartRun> runs_{PartRun{}};
    std::uint32_t count_ = 1;
};

/// The parts of a job's bodies A ([0]) and B ([1]).
using BodyPartRuns = std::array<PartRuns, 2>;

/// Finds parts of triangles. Is fast if consecutive triangles mostly share a run.
class PartCursor {
  public:
    /// The runs outlive the cursor.
    explicit PartCursor(const PartRuns& runs) : runs_(runs) { move_to(0); }

    [[nodiscard]] std::uint32_t part_of(std::uint32_t triangle) {
        if (triangle < begin_ || triangle >= end_) {
            move_to(triangle);
        }
        return part_;
    }

  private:
    void move_to(std::uint32_t triangle);

    const PartRuns& runs_;
    std::uint32_t begin_ = 0;
    std::uint32_t end_ = 0;
    std::uint32_t part_ = 0;
};

/// The parts of a mesh by their names.
struct NamedParts {
    PartRuns runs;
    std::vector<std::string> names; ///< The name of each part, by its number.
};

/// Numbers the parts of a mesh in the order of their first triangles. Parts of equal names are one,
/// and triangles of no part make up a part `others`. A mesh with at most one part is one part: its
/// own, or `whole`.
[[nodiscard]] NamedParts named_parts(const Mesh& mesh);

/// Returns the named parts of two bodies.
[[nodiscard]] std::shared_ptr<const BodyPartRuns> body_part_runs(const Mesh& a, const Mesh& b);

} // namespace cd
