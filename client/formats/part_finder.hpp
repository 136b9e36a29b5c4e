// Finds the part of a mesh to which a triangle belongs.
#pragma once

#include "common/geometry/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace cd {

/// Finds a triangle's part by binary search, but first tries the part found last, since consecutive
/// triangles mostly share a part.
class PartFinder {
  public:
    explicit PartFinder(std::shared_ptr<const Mesh> mesh)
        : mesh_(std::move(mesh)), parts_(mesh_->parts()) {}

    [[nodiscard]] std::span<const Part> parts() const { return parts_; }

    /// Returns the index in `parts` of the triangle's part; nothing if it has none.
    [[nodiscard]] std::optional<std::size_t> find(std::uint32_t triangle) {
        if (last_ < parts_.size() && holds(parts_[last_], triangle)) {
            return last_;
        }
        const auto after = std::upper_bound(
            parts_.begin(), parts_.end(), triangle, [](std::uint32_t id, const Part& part) {
                return id < part.triangles_end;
            });
        if (after == parts_.end() || !holds(*after, triangle)) {
            return std::nullopt;
        }
        last_ = static_cast<std::size_t>(after - parts_.begin());
        return last_;
    }

  private:
    static bool holds(const Part& part, std::uint32_t triangle) {
        return part.triangles_begin <= triangle && triangle < part.triangles_end;
    }

    std::shared_ptr<const Mesh> mesh_;
    std::span<const Part> parts_;
    std::size_t last_ = 0;
};

} // namespace cd
