#include "client/import/mesh_builder.hpp"

#include "common/core/hash.hpp"

#include <span>

namespace cd {

std::size_t MeshBuilder::PositionHash::operator()(const std::array<double, 3>& position) const {
    return static_cast<std::size_t>(checksum(std::as_bytes(std::span(position))));
}

void MeshBuilder::begin_part(const std::string& name) {
    end_part();
    std::string unique = name;
    for (int n = 2; names_.contains(unique); ++n) {
        unique = name + "#" + std::to_string(n);
    }
    names_.insert(unique);
    const auto begin = static_cast<std::uint32_t>(arrays_.triangles.size());
    arrays_.parts.push_back({std::move(unique), begin, begin});
}

void MeshBuilder::end_part() {
    if (arrays_.parts.empty()) {
        return;
    }
    Part& part = arrays_.parts.back();
    part.triangles_end = static_cast<std::uint32_t>(arrays_.triangles.size());
    if (part.triangles_begin == part.triangles_end) {
        names_.erase(part.name);
        arrays_.parts.pop_back();
    }
}

void MeshBuilder::add(const Corners& corners) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
        // Adding zero makes one zero of both.
        const std::array<double, 3> position{
            corners[k].x() + 0.0, corners[k].y() + 0.0, corners[k].z() + 0.0};
        const auto [place, is_new] =
            places_.emplace(position, static_cast<std::uint32_t>(arrays_.vertices.size()));
        if (is_new) {
            arrays_.vertices.emplace_back(position[0], position[1], position[2]);
        }
        triangle[k] = place->second;
    }
    arrays_.triangles.push_back(triangle);
}

Result<Mesh> MeshBuilder::finish(Precision precision) {
    end_part();
    arrays_.precision = precision;
    return Mesh::create(std::move(arrays_));
}

} // namespace cd
