#include "client/scene/scene_bodies.hpp"

#include "client/scene/mesh_split.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <map>
#include <utility>

namespace cd {

namespace {

/// Collects the bodies of the entries, and each mesh once.
class BodyList {
  public:
    BodyList(const SceneSpec& scene,
             const std::filesystem::path& job_file,
             const RoadTraffic& traffic)
        : scene_(scene), job_file_(job_file), traffic_(traffic) {}

    Status add_entry(std::uint32_t entry, const std::shared_ptr<const Mesh>& mesh) {
        const SceneBodySpec& spec = scene_.bodies[entry];
        if (is_of_vehicles(scene_, spec)) {
            return add_vehicles(entry, mesh);
        }
        if (spec.is_split) {
            return add_parts(entry, *mesh);
        }
        if (!spec.count) {
            return add_body(entry, spec.name, mesh);
        }
        for (std::uint32_t i = 0; i < *spec.count; ++i) {
            CD_TRY(add_body(entry, spec.name + "." + std::to_string(i), mesh));
        }
        return Done{};
    }

    [[nodiscard]] SceneBodies take() { return std::move(made_); }

  private:
    Status add_vehicles(std::uint32_t entry, const std::shared_ptr<const Mesh>& mesh) {
        for (const TrafficVehicle& vehicle : traffic_.vehicles) {
            if (vehicle.body == scene_.bodies[entry].name) {
                CD_TRY(add_body(entry, vehicle.id, mesh));
            }
        }
        return Done{};
    }

    Status add_parts(std::uint32_t entry, const Mesh& mesh) {
        const SceneBodySpec& spec = scene_.bodies[entry];
        auto parts = CD_TRY(within(spec.mesh.path.string() + ": ", split_mesh(mesh)));
        for (PartMesh& part : parts) {
            CD_TRY(add_body(entry, spec.name + "." + part.name, part.mesh));
        }
        return Done{};
    }

    Status add_body(std::uint32_t entry,
                    const std::string& name,
                    const std::shared_ptr<const Mesh>& mesh) {
        const SceneBodySpec& spec = scene_.bodies[entry];
        if (scene_.shots && name == lines_name) {
            return error_in_job(job_file_,
                                spec.line,
                                "[bodies] " + spec.name +
                                    ": \"lines\" is the name of the lines of [shots]; give the "
                                    "body another name");
        }
        const auto [other, is_new] = entries_.try_emplace(name, entry);
        if (!is_new) {
            return error_in_job(job_file_,
                                spec.line,
                                "[bodies] " + spec.name + ": a body \"" + name +
                                    "\" exists already, of line " +
                                    std::to_string(scene_.bodies[other->second].line) +
                                    "; give one of them another name");
        }
        const auto [known, is_new_mesh] =
            numbers_.try_emplace(mesh.get(), static_cast<std::uint32_t>(made_.meshes.size()));
        if (is_new_mesh) {
            made_.meshes.push_back(mesh);
        }
        made_.bodies.push_back({name, spec.group, entry, known->second});
        return check_sizes(spec);
    }

    [[nodiscard]] Status check_sizes(const SceneBodySpec& spec) const {
        const auto too_many = [&](const char* what, std::size_t most) {
            return error_in_job(job_file_,
                                spec.line,
                                "[bodies] " + spec.name + ": a job has at most " + grouped(most) +
                                    " " + what);
        };
        const std::size_t bodies_max = limits::bodies_max - (scene_.shots ? 1 : 0);
        if (made_.bodies.size() > bodies_max) {
            return too_many("bodies; leave some out", bodies_max);
        }
        const std::size_t meshes_max = limits::body_meshes_max - (scene_.shots ? 1 : 0);
        if (made_.meshes.size() > meshes_max) {
            return too_many("meshes; instances (count) and bodies with one file share a mesh",
                            meshes_max);
        }
        return Done{};
    }

    const SceneSpec& scene_;
    const std::filesystem::path& job_file_;
    const RoadTraffic& traffic_;
    std::map<std::string, std::uint32_t> entries_; ///< The entry of each body's name.
    std::map<const Mesh*, std::uint32_t> numbers_; ///< The place of each mesh.
    SceneBodies made_;
};

} // namespace

Result<SceneBodies> expand_bodies(const SceneSpec& scene,
                                  std::span<const std::shared_ptr<const Mesh>> meshes,
                                  const std::filesystem::path& job_file,
                                  const RoadTraffic& traffic) {
    CD_CHECK(meshes.size() == scene.bodies.size());
    BodyList list(scene, job_file, traffic);
    for (std::uint32_t entry = 0; entry < scene.bodies.size(); ++entry) {
        CD_TRY(list.add_entry(entry, meshes[entry]));
    }
    SceneBodies made = list.take();
    const std::size_t least = scene.shots ? 1 : 2;
    if (made.bodies.size() < least) {
        return error_in_job(job_file,
                            scene.bodies.front().line,
                            scene.shots
                                ? std::string("[bodies] has no body that lines could hit")
                                : (made.bodies.empty() ? std::string("[bodies] has no body")
                                                       : "[bodies] has one body, \"" +
                                                             made.bodies.front().name + "\"") +
                                      "; at least two are tested against each other");
    }
    return made;
}

} // namespace cd
