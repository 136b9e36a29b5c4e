#include "common/geometry/mesh.hpp"

#include "common/core/limits/engine.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'48'53'45'4d'44'43'00; // "\0CDMESH1", little-endian.

Error bad(const std::string& detail) {
    return {ErrorCode::BadInput, detail};
}

bool is_float(double value) {
    return static_cast<double>(static_cast<float>(value)) == value;
}

Status check_vertices(const MeshArrays& arrays) {
    for (std::size_t i = 0; i < arrays.vertices.size(); ++i) {
        const Vec3& vertex = arrays.vertices[i];
        if (!vertex.allFinite()) {
            return bad("vertex " + std::to_string(i) + " has a coordinate that is not finite");
        }
        const bool narrow = arrays.precision == Precision::Double ||
                            (is_float(vertex.x()) && is_float(vertex.y()) && is_float(vertex.z()));
        if (!narrow) {
            return bad("vertex " + std::to_string(i) + " of a float mesh is not a float");
        }
    }
    return Done{};
}

Status check_triangles(const MeshArrays& arrays) {
    for (std::size_t i = 0; i < arrays.triangles.size(); ++i) {
        for (const std::uint32_t vertex : arrays.triangles[i]) {
            if (vertex >= arrays.vertices.size()) {
                return bad("triangle " + std::to_string(i) + " names vertex " +
                           std::to_string(vertex) + " of " +
                           std::to_string(arrays.vertices.size()));
            }
        }
    }
    return Done{};
}

Status check_parts(const MeshArrays& arrays) {
    std::uint32_t end_before = 0;
    for (const Part& part : arrays.parts) {
        const bool in_order = part.triangles_begin >= end_before &&
                              part.triangles_end >= part.triangles_begin &&
                              part.triangles_end <= arrays.triangles.size();
        if (!in_order) {
            return bad("part '" + part.name + "' is out of order or out of range");
        }
        end_before = part.triangles_end;
    }
    return Done{};
}

Status check_sizes(const MeshArrays& arrays) {
    if (arrays.triangles.empty()) {
        return bad("the mesh has no triangles");
    }
    if (arrays.vertices.size() > limits::mesh_vertices_max) {
        return Error{ErrorCode::TooLarge, "the mesh has too many vertices"};
    }
    if (arrays.triangles.size() > limits::mesh_triangles_max) {
        return Error{ErrorCode::TooLarge, "the mesh has too many triangles"};
    }
    if (arrays.parts.size() > limits::parts_max) {
        return Error{ErrorCode::TooLarge, "the mesh has too many parts"};
    }
    return Done{};
}

Bytes encode(const MeshArrays& arrays) {
    ByteWriter out;
    out.put(magic);
    out.put(static_cast<std::uint8_t>(arrays.precision));
    out.put(static_cast<std::uint64_t>(arrays.vertices.size()));
    out.put(static_cast<std::uint64_t>(arrays.triangles.size()));
    out.put(static_cast<std::uint32_t>(arrays.parts.size()));
    for (const Vec3& vertex : arrays.vertices) {
        if (arrays.precision == Precision::Float) {
            const Eigen::Vector3f narrow = vertex.cast<float>();
            out.put_array(std::span<const float>(narrow.data(), 3));
        } else {
            out.put_array(std::span<const double>(vertex.data(), 3));
        }
    }
    for (const Triangle& triangle : arrays.triangles) {
        out.put_array(std::span<const std::uint32_t>(triangle));
    }
    for (const Part& part : arrays.parts) {
        out.put_text(part.name);
        out.put(part.triangles_begin);
        out.put(part.triangles_end);
    }
    return out.take();
}

/// Replaces -0 by 0, so that meshes with equal coordinates have equal hashes.
void drop_negative_zeros(MeshArrays& arrays) {
    for (Vec3& vertex : arrays.vertices) {
        vertex.array() += 0.0;
    }
}

template <class T>
void read_vertices(ByteReader& in, std::uint64_t count, std::vector<Vec3>& vertices) {
    const std::vector<T> values =
        in.get_array<T>(count <= limits::mesh_vertices_max ? 3 * count : ~std::uint64_t{0});
    vertices.reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        vertices.emplace_back(static_cast<double>(values[i]),
                              static_cast<double>(values[i + 1]),
                              static_cast<double>(values[i + 2]));
    }
}

} // namespace

Precision precision_of(std::span<const Vec3> vertices) {
    const bool are_floats = std::all_of(vertices.begin(), vertices.end(), [](const Vec3& vertex) {
        return vertex.cast<float>().cast<double>() == vertex;
    });
    return are_floats ? Precision::Float : Precision::Double;
}

Result<Mesh> Mesh::create(MeshArrays arrays) {
    drop_negative_zeros(arrays);
    for (const auto check : {check_sizes, check_vertices, check_triangles, check_parts}) {
        if (const Status status = check(arrays); !status) {
            return status.error();
        }
    }
    const Sha256 hash = sha256(encode(arrays));
    return Mesh(std::move(arrays), hash);
}

Corners Mesh::corners(std::uint32_t triangle) const {
    const Triangle& t = arrays_.triangles[triangle];
    return {arrays_.vertices[t[0]], arrays_.vertices[t[1]], arrays_.vertices[t[2]]};
}

Bytes Mesh::canonical_bytes() const {
    return encode(arrays_);
}

Result<Mesh> Mesh::from_canonical_bytes(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint64_t>() != magic) {
        return bad("not a mesh in canonical form");
    }
    const auto precision = in.get<std::uint8_t>();
    if (precision > static_cast<std::uint8_t>(Precision::Double)) {
        return bad("unknown precision of a mesh");
    }
    const auto vertices = in.get<std::uint64_t>();
    const auto triangles = in.get<std::uint64_t>();
    const auto parts = in.get<std::uint32_t>();

    MeshArrays arrays;
    arrays.precision = static_cast<Precision>(precision);
    if (arrays.precision == Precision::Float) {
        read_vertices<float>(in, vertices, arrays.vertices);
    } else {
        read_vertices<double>(in, vertices, arrays.vertices);
    }
    const auto indices = in.get_array<std::uint32_t>(
        triangles <= limits::mesh_triangles_max ? 3 * triangles : ~std::uint64_t{0});
    arrays.triangles.reserve(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        arrays.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    }
    for (std::uint32_t i = 0; i < parts && !in.failed(); ++i) {
        Part part;
        part.name = in.get_text();
        part.triangles_begin = in.get<std::uint32_t>();
        part.triangles_end = in.get<std::uint32_t>();
        arrays.parts.push_back(std::move(part));
    }
    if (!in.complete()) {
        return bad("a mesh in canonical form that is cut short or too long");
    }
    return create(std::move(arrays));
}

} // namespace cd
