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

/// Takes triangles part by part. Vertices are numbered in the order of their first use, so the mesh
/// does not depend on the order of the hash table.
class MeshBuilder {
  public:
    /// Begins a part. If an earlier part has the name, "#2", "#3" and so on is appended to it. A
    /// part without triangles is dropped.
    void begin_part(const std::string& name);
    void add(const Corners& corners);
    /// Adds a triangle of vertices returned by `vertex`.
    void add(const Triangle& triangle) { arrays_.triangles.push_back(triangle); }
    /// Returns the index of the vertex at this position, and adds a new position as a vertex.
    [[nodiscard]] std::uint32_t vertex(const Vec3& position);
    [[nodiscard]] std::uint64_t triangle_count() const { return arrays_.triangles.size(); }

    /// Completes the mesh in this precision. Errors: as `Mesh::create`.
    [[nodiscard]] Result<Mesh> finish(Precision precision);
    /// Completes the mesh in floats if they hold every coordinate, else in doubles.
    [[nodiscard]] Result<Mesh> finish();

  private:
    void end_part();
    [[nodiscard]] std::string unique_name(const std::string& name);
    void grow();

    MeshArrays arrays_;
    std::vector<std::uint32_t> slots_; ///< A hash table of vertex indices; free slots hold `empty`.
    std::unordered_set<std::string> names_;
    std::unordered_map<std::string, std::uint64_t>
        repetitions_; ///< For each name: the last number used after '#'.
};

/// Completes a reader's mesh, by default in the precision that its coordinates need. Errors:
/// BadInput naming the file.
[[nodiscard]] Result<ImportedMesh> finish_import(const std::filesystem::path& path,
                                                 MeshBuilder& builder,
                                                 std::optional<Precision> precision = {});

} // namespace cd
