// Gathers corners into a mesh whose equal positions are one vertex.
#pragma once

#include "client/import/imported_mesh.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cd {

/// Triangles come part by part. Vertices are numbered in the order of their first use, so the
/// result does not depend on the hash table.
class MeshBuilder {
  public:
    /// A part with that name, or that name with "#2", "#3" ... where it was taken. A part that got
    /// no triangle disappears.
    void begin_part(const std::string& name);
    void add(const Corners& corners);
    /// Of vertices that `vertex` gave.
    void add(const Triangle& triangle) { arrays_.triangles.push_back(triangle); }
    /// The number of the vertex at this position, a new one if there was none.
    [[nodiscard]] std::uint32_t vertex(const Vec3& position);
    [[nodiscard]] std::uint64_t triangle_count() const { return arrays_.triangles.size(); }

    /// Errors: those of `Mesh::create`.
    [[nodiscard]] Result<Mesh> finish(Precision precision);
    /// In floats where they hold every coordinate, else in doubles.
    [[nodiscard]] Result<Mesh> finish();

  private:
    void end_part();
    [[nodiscard]] std::string unique_name(const std::string& name);
    void grow();

    MeshArrays arrays_;
    std::vector<std::uint32_t>
        slots_; ///< A hash table: numbers of vertices, `empty` in free slots.
    std::unordered_set<std::string> names_;
    std::unordered_map<std::string, std::uint64_t>
        repetitions_; ///< Last number after a name's '#'.
};

/// The mesh that a reader has gathered, in the precision that its coordinates need.
/// Errors: BadInput naming the file.
[[nodiscard]] Result<ImportedMesh> finish_import(const MeshSource& source, MeshBuilder& builder);

} // namespace cd
