// The parts of a body: what groups of contacts are made of.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/query.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cd {

/// What the parts of bodies are that groups are made of.
enum class PartKind : std::uint8_t {
    Any,   ///< Named parts or, in a mesh with at most one, its connected pieces.
    Named, ///< Only named parts, as in sums over scenarios whose pairs are not listed.
};

/// Returns the parts that are in the groups of a run of this level.
[[nodiscard]] constexpr PartKind part_kind(Level level) {
    return level >= Level::Pairs ? PartKind::Any : PartKind::Named;
}

/// Assigns each triangle of a mesh to a part. Parts are those of the mesh; parts of equal names are
/// one, and triangles of no part make up a part `others`. In a mesh with at most one part, parts
/// are the connected pieces (triangles that share a vertex, by coordinates): `piece 1` has most
/// triangles, and pieces beyond `limits::pieces_max` together are `others`. A mesh that is one
/// piece or a bundle of lines, or of which only named parts count, is one part: its own, or
/// `whole`.
class BodyParts {
  public:
    /// Takes near-linear time in the number of vertices and triangles.
    explicit BodyParts(const Mesh& mesh, PartKind kind = PartKind::Any);

    [[nodiscard]] std::size_t count() const { return names_.size(); }
    [[nodiscard]] const std::string& name(std::size_t part) const { return names_[part]; }
    /// Returns the number of a triangle's part, below `count()`.
    [[nodiscard]] std::uint32_t part_of(std::uint32_t triangle) const { return part_of_[triangle]; }
    /// Returns the parts by runs of consecutive triangles.
    [[nodiscard]] NamedParts by_runs() const;
    /// False if parts are pieces: another revision of the mesh may give a piece another number.
    [[nodiscard]] bool has_lasting_names() const { return has_lasting_names_; }

  private:
    void assign_named_parts(const Mesh& mesh);
    void assign_pieces(const Mesh& mesh);

    std::vector<std::string> names_;
    std::vector<std::uint32_t> part_of_; ///< For each triangle the number of its part.
    bool has_lasting_names_ = true;
};

} // namespace cd
