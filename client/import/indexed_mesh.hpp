// Builds a mesh from a list of vertices and faces that index it, as in OBJ, OFF and PLY files.
#pragma once

#include "client/import/imported_mesh.hpp"
#include "client/import/mesh_builder.hpp"
#include "client/import/polygon_cut.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

class IndexedMesh {
  public:
    explicit IndexedMesh(double unit_factor) : unit_factor_(unit_factor) {}

    void add_vertex(const Vec3& vertex);
    [[nodiscard]] std::uint64_t vertex_count() const { return vertices_.size(); }
    [[nodiscard]] const MeshBuilder& builder() const { return builder_; }

    void begin_part(const std::string& name) { builder_.begin_part(name); }

    /// Adds a triangle, or cuts a polygon into triangles and adds them. A face of one corner is
    /// counted as a point, a face of two as a line. Corners are indices of vertices, from 0.
    ///
    /// Errors: BadInput (the caller adds file and line) for a face without corners, an index out of
    /// range, a coordinate that the unit's factor makes infinite, or a polygon that cannot be cut.
    [[nodiscard]] Status add_face(std::span<const std::int64_t> corners);

    void skip_lines(std::uint64_t count) { lines_ += count; }
    void skip_points(std::uint64_t count) { points_ += count; }

    /// Completes the mesh. Errors: BadInput naming the file, for a mesh without triangles or with
    /// more than a mesh may have.
    [[nodiscard]] Result<ImportedMesh> finish(const MeshSource& source);

  private:
    [[nodiscard]] Status resolve(std::span<const std::int64_t> corners);
    [[nodiscard]] Status cut(std::span<const std::int64_t> corners);

    double unit_factor_;
    std::vector<Vec3> vertices_;         ///< In the order of the file, not scaled.
    std::vector<std::uint32_t> numbers_; ///< Index in the mesh of each vertex that a face uses.
    std::vector<std::uint32_t> corners_; ///< Mesh indices of the current face's corners.
    std::vector<Vec3> polygon_;
    PolygonCutter cutter_;
    MeshBuilder builder_;
    std::uint64_t points_ = 0;
    std::uint64_t lines_ = 0;
};

} // namespace cd
