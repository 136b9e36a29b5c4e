#include "client/import/mesh_builder.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/hash.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace cd {

namespace {

constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t slots_min = 1024; // A power of two, so that a mask gives the slot.

std::size_t hash_of(const Vec3& position) {
    return static_cast<std::size_t>(checksum(std::as_bytes(std::span(position.data(), 3))));
}

} // namespace

void MeshBuilder::begin_part(const std::string& name) {
    end_part();
    const auto begin = static_cast<std::uint32_t>(arrays_.triangles.size());
    arrays_.parts.push_back({name, begin, begin});
}

void MeshBuilder::end_part() {
    if (arrays_.parts.empty()) {
        return;
    }
    Part& part = arrays_.parts.back();
    part.triangles_end = static_cast<std::uint32_t>(arrays_.triangles.size());
    if (part.triangles_begin == part.triangles_end) {
        arrays_.parts.pop_back();
        return;
    }
    part.name = unique_name(part.name);
}

std::string MeshBuilder::unique_name(const std::string& name) {
    if (names_.insert(name).second) {
        return name;
    }
    std::uint64_t& last = repetitions_.try_emplace(name, 1).first->second;
    std::string unique;
    do {
        unique = name + "#" + std::to_string(++last);
    } while (!names_.insert(unique).second);
    return unique;
}

std::uint32_t MeshBuilder::vertex(const Vec3& position) {
    if (2 * arrays_.vertices.size() >= slots_.size()) {
        grow();
    }
    const Vec3 place = position.array() + 0.0; // Turns -0 into 0.
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_of(place) & mask;
    while (slots_[slot] != empty && arrays_.vertices[slots_[slot]] != place) {
        slot = (slot + 1) & mask;
    }
    if (slots_[slot] == empty) {
        slots_[slot] = static_cast<std::uint32_t>(arrays_.vertices.size());
        arrays_.vertices.push_back(place);
    }
    return slots_[slot];
}

void MeshBuilder::grow() {
    slots_.assign(std::max(slots_min, 2 * slots_.size()), empty);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < arrays_.vertices.size(); ++i) {
        std::size_t slot = hash_of(arrays_.vertices[i]) & mask;
        while (slots_[slot] != empty) {
            slot = (slot + 1) & mask;
        }
        slots_[slot] = static_cast<std::uint32_t>(i);
    }
}

void MeshBuilder::add(const Corners& corners) {
    Triangle triangle{};
    std::transform(corners.begin(), corners.end(), triangle.begin(), [this](const Vec3& corner) {
        return vertex(corner);
    });
    add(triangle);
}

Result<Mesh> MeshBuilder::finish(Precision precision) {
    end_part();
    arrays_.precision = precision;
    slots_ = {};
    return Mesh::create(std::move(arrays_));
}

Result<Mesh> MeshBuilder::finish() {
    return finish(precision_of(arrays_.vertices));
}

Result<ImportedMesh> finish_import(const std::filesystem::path& path,
                                   MeshBuilder& builder,
                                   std::optional<Precision> precision) {
    ImportedMesh imported;
    imported.mesh = std::make_shared<const Mesh>(CD_TRY(
        within(path.string() + ": ", precision ? builder.finish(*precision) : builder.finish())));
    return imported;
}

} // namespace cd
