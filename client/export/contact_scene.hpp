// A scenario to look at: both bodies in the world, and what their triangles share.
#pragma once

#include "client/picture/body_picture.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/types.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// A triangle of a pair. If it is in several pairs: the worst class, which is the last of near,
/// touch, coplanar, proper.
struct SceneContact {
    std::uint32_t triangle = 0;
    PairClass kind = PairClass::Touch;
};

struct SceneBody {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    std::vector<Vec3> points;           ///< The mesh's vertices in the world, rounded.
    std::vector<SceneContact> contacts; ///< By ascending triangles.
};

/// A point that a pair of triangles shares, or an end of a segment: of a shared one, or of that
/// between the nearest points of a near pair.
struct SceneMark {
    ContactPair pair;
    Vec3 point;
};

struct ContactScene {
    std::array<SceneBody, 2> bodies;
    std::vector<SceneMark> dots;     ///< Of the pairs that share a single point.
    std::vector<SceneMark> segments; ///< Two for each shared segment; areas have their outline.
    std::vector<SceneMark> gaps;     ///< Two for each near pair, the point of A first.
};

/// Places the bodies. `result` is the scenario's, at `level contacts`.
[[nodiscard]] ContactScene make_contact_scene(std::array<SceneBody, 2> bodies,
                                              const Scenario& scenario,
                                              const ScenarioResult& result);

/// Writes a body as a surface with the arrays of `vtp_body` and `colour`. Errors: Io naming the
/// file; Interrupted.
[[nodiscard]] Status write_scene_body(const ContactScene& scene,
                                      std::size_t body,
                                      const std::filesystem::path& path,
                                      const StopCheck& stop);
/// Writes the triangles in contact and the marks as a VTP file; docs/exports.md describes its
/// arrays. Errors: Io naming the file; Interrupted.
[[nodiscard]] Status write_scene_contacts(const ContactScene& scene,
                                          const std::filesystem::path& path,
                                          const StopCheck& stop);
/// Writes the whole scene as a GLB file. `metres` is the length of a unit. Errors: as `write_glb`.
[[nodiscard]] Status write_scene_glb(const ContactScene& scene,
                                     double metres,
                                     const std::filesystem::path& path,
                                     const StopCheck& stop);

} // namespace cd
