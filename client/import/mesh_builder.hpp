// Gathers corners into a mesh whose equal positions are one vertex.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace cd {

/// Triangles come part by part. Vertices are numbered in the order of their first use, so the
/// result does not depend on the hash table.
class MeshBuilder {
  public:
    /// A part with that name, or that name with "#2", "#3" ... where it was taken. A part that got
    /// no triangle disappears.
    void begin_part(const std::string& name);
    void add(const Corners& corners);
    [[nodiscard]] std::uint64_t triangle_count() const { return arrays_.triangles.size(); }

    /// Errors: those of `Mesh::create`.
    [[nodiscard]] Result<Mesh> finish(Precision precision);

  private:
    struct PositionHash {
        std::size_t operator()(const std::array<double, 3>& position) const;
    };

    void end_part();

    MeshArrays arrays_;
    std::unordered_map<std::array<double, 3>, std::uint32_t, PositionHash> places_;
    std::unordered_set<std::string> names_;
};

} // namespace cd
