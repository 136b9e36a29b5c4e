#include "common/geometry/triangle_blocks.hpp"

#include "common/core/check.hpp"

#include <algorithm>

namespace cd {

namespace {

template <class T>
Vec3 vertex_at(std::span<const T> coordinates, std::size_t vertex) {
    const T* from = &coordinates[3 * vertex];
    return {
        static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2])};
}

template <class T>
std::uint64_t bytes_of(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}

} // namespace

Vec3 TriangleBlocks::vertex(std::size_t number) const {
    return doubles.empty() ? vertex_at(floats, number) : vertex_at(doubles, number);
}

Corners TriangleBlocks::corners_at(std::uint32_t slot) const {
    const std::size_t first = vertex_begin[slot / block_size];
    const BlockCorners& c = corners[slot];
    return {vertex(first + c[0]), vertex(first + c[1]), vertex(first + c[2])};
}

TriangleBlockArrays::TriangleBlockArrays(Precision precision) : precision_(precision) {
    precision_ == Precision::Float ? floats_.resize(spare_numbers, 0)
                                   : doubles_.resize(spare_numbers, 0);
}

void TriangleBlockArrays::add_vertex(const Vec3& vertex) {
    const auto put = [&](auto& to) {
        using T = typename std::decay_t<decltype(to)>::value_type;
        to.insert(
            to.end() - std::ptrdiff_t{spare_numbers},
            {static_cast<T>(vertex.x()), static_cast<T>(vertex.y()), static_cast<T>(vertex.z())});
    };
    precision_ == Precision::Float ? put(floats_) : put(doubles_);
    reach_ = std::max(reach_, vertex.cwiseAbs().maxCoeff());
}

std::uint32_t TriangleBlockArrays::add(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> ids,
                                       std::span<const Vec3> vertices) {
    CD_CHECK(!triangles.empty() && triangles.size() <= block_size);
    CD_CHECK(ids.size() == triangles.size());
    const auto block = static_cast<std::uint32_t>(vertex_begin_.size() - 1);
    std::array<std::uint32_t, 3 * block_size> known;
    std::uint8_t known_count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        BlockCorners indices{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = triangles[i][k];
            auto* const end = known.begin() + known_count;
            auto* const found = std::find(known.begin(), end, vertex);
            indices[k] = static_cast<std::uint8_t>(found - known.begin());
            if (found == end) {
                known[known_count++] = vertex;
                add_vertex(vertices[vertex]);
            }
        }
        corners_.push_back(indices);
        ids_.push_back(ids[i]);
    }
    vertex_begin_.push_back(vertex_begin_.back() + known_count);
    corners_.resize(std::size_t{block_size} * (block + 1), BlockCorners{});
    ids_.resize(corners_.size(), 0);
    return block;
}

TriangleBlocks TriangleBlockArrays::view() const {
    return {precision_ == Precision::Float ? std::span<const float>(floats_)
                                           : std::span<const float>(),
            precision_ == Precision::Double ? std::span<const double>(doubles_)
                                            : std::span<const double>(),
            vertex_begin_,
            corners_,
            ids_,
            reach_};
}

std::uint64_t TriangleBlockArrays::memory_bytes() const {
    return bytes_of(floats_) + bytes_of(doubles_) + bytes_of(vertex_begin_) + bytes_of(corners_) +
           bytes_of(ids_);
}

} // namespace cd
