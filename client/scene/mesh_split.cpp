#include "client/scene/mesh_split.hpp"

#include "common/core/errors.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace cd {

namespace {

/// Collects triangles of a mesh, and the vertices that they use.
class SubMesh {
  public:
    explicit SubMesh(const Mesh& mesh) : mesh_(mesh), number_(mesh.vertices().size(), unused) {}

    void add(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            Triangle triangle = mesh_.triangles()[i];
            for (std::uint32_t& corner : triangle) {
                corner = number_of(corner);
            }
            arrays_.triangles.push_back(triangle);
        }
    }
    [[nodiscard]] bool is_empty() const { return arrays_.triangles.empty(); }
    /// Returns the mesh of all triangles added since the last call.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> take(const std::string& name) {
        arrays_.parts = {{name, 0, static_cast<std::uint32_t>(arrays_.triangles.size())}};
        arrays_.precision = mesh_.precision();
        for (const std::uint32_t vertex : used_) {
            number_[vertex] = unused;
        }
        used_.clear();
        auto made = CD_TRY(Mesh::create(std::exchange(arrays_, {})));
        return std::make_shared<const Mesh>(std::move(made));
    }

  private:
    static constexpr std::uint32_t unused = UINT32_MAX;

    std::uint32_t number_of(std::uint32_t vertex) {
        if (number_[vertex] == unused) {
            number_[vertex] = static_cast<std::uint32_t>(used_.size());
            used_.push_back(vertex);
            arrays_.vertices.push_back(mesh_.vertices()[vertex]);
        }
        return number_[vertex];
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> number_; ///< The new number of each vertex, or `unused`.
    std::vector<std::uint32_t> used_;   ///< The vertices that have a new number.
    MeshArrays arrays_;
};

/// Names parts differently, of which some have one name.
class FreeNames {
  public:
    /// Returns the name, with a number behind it if it is taken, and takes it.
    std::string take(const std::string& name) {
        std::string free = name;
        int& number = next_.try_emplace(name, 2).first->second;
        while (!taken_.insert(free).second) {
            free = name + "#" + std::to_string(number++);
        }
        return free;
    }

  private:
    std::set<std::string> taken_;
    std::map<std::string, int> next_; ///< For each name the number to try next.
};

} // namespace

Result<std::vector<PartMesh>> split_mesh(const Mesh& mesh) {
    std::vector<PartMesh> split;
    FreeNames names;
    SubMesh part_mesh(mesh);
    SubMesh others(mesh);
    std::uint32_t end = 0;
    for (const Part& part : mesh.parts()) {
        others.add(end, part.triangles_begin);
        end = part.triangles_end;
        part_mesh.add(part.triangles_begin, part.triangles_end);
        if (!part_mesh.is_empty()) {
            auto made = CD_TRY(part_mesh.take(part.name));
            split.push_back({names.take(part.name), std::move(made)});
        }
    }
    others.add(end, static_cast<std::uint32_t>(mesh.triangles().size()));
    if (!others.is_empty()) {
        const std::string name = mesh.parts().empty() ? "whole" : "others";
        auto made = CD_TRY(others.take(name));
        split.push_back({names.take(name), std::move(made)});
    }
    return split;
}

} // namespace cd
