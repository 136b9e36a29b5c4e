#include "client/import/indexed_mesh.hpp"

#include "common/core/errors.hpp"

#include <limits>

namespace cd {

namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

} // namespace

void IndexedMesh::add_vertex(const Vec3& vertex) {
    vertices_.push_back(vertex);
    numbers_.push_back(unused);
}

Status IndexedMesh::add_face(std::span<const std::int64_t> corners) {
    if (corners.empty()) {
        return bad_input("the face has no corners");
    }
    CD_TRY(resolve(corners));
    if (corners.size() < 3) {
        (corners.size() == 2 ? lines_ : points_) += 1;
        return Done{};
    }
    if (corners.size() > 3) {
        return cut(corners);
    }
    builder_.add(Triangle{corners_[0], corners_[1], corners_[2]});
    return Done{};
}

Status IndexedMesh::resolve(std::span<const std::int64_t> corners) {
    corners_.clear();
    for (const std::int64_t corner : corners) {
        const auto vertex = static_cast<std::size_t>(corner);
        if (corner < 0 || vertex >= vertices_.size()) {
            return bad_input("names vertex " + std::to_string(corner) + " of " +
                             std::to_string(vertices_.size()));
        }
        if (numbers_[vertex] == unused && corners.size() >= 3) {
            const Vec3 scaled = unit_factor_ * vertices_[vertex];
            if (!scaled.allFinite()) {
                return bad_input("has a coordinate that is not finite in the job's unit");
            }
            numbers_[vertex] = builder_.vertex(scaled);
        }
        corners_.push_back(numbers_[vertex]);
    }
    return Done{};
}

Status IndexedMesh::cut(std::span<const std::int64_t> corners) {
    polygon_.clear();
    for (const std::int64_t corner : corners) {
        polygon_.push_back(vertices_[static_cast<std::size_t>(corner)]);
    }
    const std::span<const Triangle> triangles = cutter_.cut(polygon_);
    if (triangles.empty()) {
        return bad_input(
            "is a polygon of " + std::to_string(corners.size()) +
            " corners that cannot be cut into triangles, since its outline crosses itself; "
            "triangulate it before exporting");
    }
    for (const Triangle& triangle : triangles) {
        builder_.add(Triangle{corners_[triangle[0]], corners_[triangle[1]], corners_[triangle[2]]});
    }
    return Done{};
}

Result<ImportedMesh> IndexedMesh::finish(const MeshSource& source) {
    auto imported = finish_import(source.path, builder_);
    if (imported) {
        imported.value().points_skipped = points_;
        imported.value().lines_skipped = lines_;
    }
    return imported;
}

} // namespace cd
