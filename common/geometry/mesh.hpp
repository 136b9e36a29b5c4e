// An immutable, validated triangle mesh.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/geometry/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// The type in which a mesh's coordinates are serialised. Float requires all to be floats.
enum class Precision : std::uint8_t { Float = 0, Double = 1 };

/// Returns Float if float represents every coordinate exactly, else Double.
[[nodiscard]] Precision precision_of(std::span<const Vec3> vertices);

/// A named range of consecutive triangles. Parts do not overlap and are in ascending order.
struct Part {
    std::string name;
    std::uint32_t triangles_begin = 0;
    std::uint32_t triangles_end = 0;

    friend bool operator==(const Part&, const Part&) = default;
};

/// The arrays of a mesh, not yet checked.
struct MeshArrays {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles; ///< In canonical order; the index is the id.
    std::vector<Part> parts;
    Precision precision = Precision::Double;
};

/// A valid mesh: at least one triangle, indices in range, finite coordinates (all floats if
/// `precision` is Float), parts in order and in range. Degenerate and duplicate triangles are legal
/// and kept.
class Mesh {
  public:
    /// Checks the arrays and replaces -0 by 0. Errors: BadInput naming the first bad vertex,
    /// triangle (both counted from 0) or part; TooLarge over the bounds of limits/engine.hpp.
    [[nodiscard]] static Result<Mesh> create(MeshArrays arrays);

    [[nodiscard]] const std::vector<Vec3>& vertices() const { return arrays_.vertices; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return arrays_.triangles; }
    [[nodiscard]] const std::vector<Part>& parts() const { return arrays_.parts; }
    [[nodiscard]] Precision precision() const { return arrays_.precision; }

    [[nodiscard]] Corners corners(std::uint32_t triangle) const;

    /// Serialises precision, vertices, triangles and parts, little-endian. The SHA-256 of these
    /// bytes identifies the mesh.
    [[nodiscard]] Bytes canonical_bytes() const;
    /// Parses bytes that `canonical_bytes` made. The bytes are untrusted and checked as by
    /// `create`. Errors: those of `create`; BadInput for bytes of another form.
    [[nodiscard]] static Result<Mesh> from_canonical_bytes(std::span<const std::byte> bytes);

    /// Returns the SHA-256 of `canonical_bytes`.
    [[nodiscard]] const Sha256& hash() const { return hash_; }

  private:
    Mesh(MeshArrays arrays, Sha256 hash) : arrays_(std::move(arrays)), hash_(hash) {}

    MeshArrays arrays_;
    Sha256 hash_;
};

} // namespace cd
