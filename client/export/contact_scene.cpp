#include "client/export/contact_scene.hpp"

#include "client/export/glb_file.hpp"
#include "client/export/result_writer.hpp"
#include "client/export/vtp_body.hpp"
#include "client/export/vtp_file.hpp"
#include "client/picture/body_picture.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace cd {

namespace {

constexpr Colour touch_colour{240, 200, 0};
constexpr Colour mark_colour{0, 0, 0};

Colour colour_of(PairClass kind) {
    return kind == PairClass::Proper ? contact_colour
           : kind == PairClass::Near ? near_colour
                                     : touch_colour;
}

/// Returns a number that is larger for worse classes.
int badness(PairClass kind) {
    return kind == PairClass::Near ? 0 : static_cast<int>(kind);
}

std::uint8_t component(const Colour& colour, std::uint64_t number) {
    return number == 0 ? colour.red : number == 1 ? colour.green : colour.blue;
}

/// Returns the triangles of one body, ascending, each once with its worst class.
std::vector<SceneContact> contacts_of(const std::vector<ContactPair>& pairs,
                                      std::uint32_t ContactPair::*triangle) {
    std::vector<SceneContact> contacts;
    for (const ContactPair& pair : pairs) {
        contacts.push_back({pair.*triangle, pair.kind});
    }
    std::ranges::sort(contacts, [](const SceneContact& left, const SceneContact& right) {
        return std::pair(left.triangle, badness(right.kind)) <
               std::pair(right.triangle, badness(left.kind));
    });
    const auto rest = std::ranges::unique(contacts, {}, &SceneContact::triangle);
    contacts.erase(rest.begin(), rest.end());
    return contacts;
}

void place(SceneBody& body, const Pose& pose) {
    for (const Vec3& vertex : body.mesh->vertices()) {
        body.points.push_back(pose.apply(vertex));
    }
}

void add_marks(const ContactPair& pair, const std::vector<Vec3>& points, ContactScene& scene) {
    if (pair.kind == PairClass::Near) {
        for (const Vec3& point : points) {
            scene.gaps.push_back({pair, point});
        }
        return;
    }
    if (points.size() == 1) {
        scene.dots.push_back({pair, points[0]});
    }
    // An area's outline is closed; a segment has one side.
    const std::size_t sides = points.size() > 2 ? points.size() : points.size() / 2;
    for (std::size_t i = 0; i < sides; ++i) {
        scene.segments.push_back({pair, points[i]});
        scene.segments.push_back({pair, points[(i + 1) % points.size()]});
    }
}

// ---- VTP ----------------------------------------------------------------------------------------

/// The points and cells of a file of contacts, in the order of its cells.
struct ContactCells {
    struct Cell {
        PairClass kind;
        std::int64_t a; ///< Triangle of A, or -1.
        std::int64_t b; ///< Triangle of B, or -1.
        Colour colour;
    };
    std::vector<Vec3> points;
    std::vector<Cell> cells;

    void add_marks(const std::vector<SceneMark>& marks, std::size_t points_each, Colour colour) {
        for (std::size_t i = 0; i < marks.size(); ++i) {
            points.push_back(marks[i].point);
            if (i % points_each == 0) {
                const ContactPair& pair = marks[i].pair;
                cells.push_back({pair.kind, pair.a, pair.b, colour});
            }
        }
    }

    void add_triangles(const SceneBody& body, bool is_a) {
        for (const SceneContact& contact : body.contacts) {
            for (const std::uint32_t vertex : body.mesh->triangles()[contact.triangle]) {
                points.push_back(body.points[vertex]);
            }
            const std::int64_t triangle = contact.triangle;
            cells.push_back({contact.kind,
                             is_a ? triangle : -1,
                             is_a ? -1 : triangle,
                             colour_of(contact.kind)});
        }
    }
};

/// Returns an array with a number of each cell. The cells must outlive it.
template <class Number, class NumberOf>
VtpArray cell_array(const char* name, const ContactCells& all, NumberOf number_of) {
    return {name, make_numbers<Number>(all.cells.size(), [&all, number_of](std::uint64_t i) {
                return number_of(all.cells[i]);
            })};
}

// ---- GLB ----------------------------------------------------------------------------------------

constexpr std::size_t proper_material = 2; ///< After the materials of the two bodies.
constexpr std::size_t touch_material = 3;
constexpr std::size_t mark_material = 4;
constexpr std::size_t near_material = 5; ///< Only in a scene with near pairs.

GlbPrimitive
triangles_of(const Mesh& mesh, std::vector<std::uint32_t> triangles, std::size_t material) {
    const std::uint64_t corners = 3 * triangles.size();
    return {GlbPrimitive::Mode::Triangles,
            material,
            make_numbers<std::uint32_t>(corners,
                                        [&mesh, triangles = std::move(triangles)](std::uint64_t i) {
                                            return mesh.triangles()[triangles[i / 3]][i % 3];
                                        })};
}

/// Returns the material of a triangle in a pair.
std::size_t material_of(PairClass kind) {
    return kind == PairClass::Proper ? proper_material
           : kind == PairClass::Near ? near_material
                                     : touch_material;
}

/// Returns a body's mesh: its triangles in no pair, and those in pairs by class.
GlbMesh glb_body(const SceneBody& body, std::size_t number) {
    std::vector<std::uint32_t> rest;
    std::map<std::size_t, std::vector<std::uint32_t>> in_pairs{
        {proper_material, {}}, {touch_material, {}}}; // By material.
    auto contact = body.contacts.begin();
    for (std::uint32_t i = 0; i < body.mesh->triangles().size(); ++i) {
        if (contact == body.contacts.end() || contact->triangle != i) {
            rest.push_back(i);
            continue;
        }
        in_pairs[material_of(contact->kind)].push_back(i);
        ++contact;
    }
    GlbMesh mesh{body.name, body.points, {triangles_of(*body.mesh, std::move(rest), number)}};
    for (auto& [material, triangles] : in_pairs) {
        mesh.primitives.push_back(triangles_of(*body.mesh, std::move(triangles), material));
    }
    return mesh;
}

std::vector<Vec3> points_of(const std::vector<SceneMark>& marks) {
    std::vector<Vec3> points;
    for (const SceneMark& mark : marks) {
        points.push_back(mark.point);
    }
    return points;
}

GlbMesh glb_marks(const char* name,
                  const std::vector<Vec3>& points,
                  GlbPrimitive::Mode mode,
                  std::size_t material = mark_material) {
    return {name,
            points,
            {{mode, material, make_numbers<std::uint32_t>(points.size(), [](std::uint64_t i) {
                  return i;
              })}}};
}

} // namespace

ContactScene make_contact_scene(std::array<SceneBody, 2> bodies,
                                const Scenario& scenario,
                                const ScenarioResult& result) {
    ContactScene scene{std::move(bodies), {}, {}, {}};
    place(scene.bodies[0], scenario.poses.a);
    place(scene.bodies[1], scenario.poses.b);
    scene.bodies[0].contacts = contacts_of(result.pairs, &ContactPair::a);
    scene.bodies[1].contacts = contacts_of(result.pairs, &ContactPair::b);
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        std::vector<Vec3> points;
        for_each_point(result, i, [&](const Vec3& point) { points.push_back(point); });
        add_marks(result.pairs[i], points, scene);
    }
    return scene;
}

Status write_scene_body(const ContactScene& scene,
                        std::size_t number,
                        const std::filesystem::path& path,
                        const StopCheck& stop) {
    const SceneBody& body = scene.bodies[number];
    VtpData data = vtp_body(body.mesh, body.points);
    const Colour colour = body_colours[number];
    VtpArray colours{
        "colour",
        make_numbers<std::uint8_t>(3 * body.mesh->triangles().size(),
                                   [colour](std::uint64_t i) { return component(colour, i % 3); }),
        3};
    data.cell_arrays.insert(data.cell_arrays.begin(), std::move(colours));
    return write_vtp(data, path, stop);
}

Status write_scene_contacts(const ContactScene& scene,
                            const std::filesystem::path& path,
                            const StopCheck& stop) {
    ContactCells all;
    all.add_marks(scene.dots, 1, mark_colour);
    all.add_marks(scene.segments, 2, mark_colour);
    all.add_marks(scene.gaps, 2, near_colour);
    all.add_triangles(scene.bodies[0], true);
    all.add_triangles(scene.bodies[1], false);
    const std::uint64_t dots = scene.dots.size();
    const std::uint64_t lines = (scene.segments.size() + scene.gaps.size()) / 2;
    VtpData data;
    data.points = coordinates(all.points, NpyType::F8);
    data.dots = consecutive_cells(dots, 1);
    data.lines = consecutive_cells(lines, 2, dots);
    data.triangles = consecutive_cells(all.cells.size() - dots - lines, 3, dots + 2 * lines);
    using Cell = ContactCells::Cell;
    data.cell_arrays = {
        {"colour",
         make_numbers<std::uint8_t>(
             3 * all.cells.size(),
             [&](std::uint64_t i) { return component(all.cells[i / 3].colour, i % 3); }),
         3},
        cell_array<std::uint8_t>(
            "class", all, [](const Cell& cell) { return static_cast<std::uint8_t>(cell.kind); }),
        cell_array<std::int64_t>("triangle_a", all, [](const Cell& cell) { return cell.a; }),
        cell_array<std::int64_t>("triangle_b", all, [](const Cell& cell) { return cell.b; })};
    return write_vtp(data, path, stop);
}

Status write_scene_glb(const ContactScene& scene,
                       double metres,
                       const std::filesystem::path& path,
                       const StopCheck& stop) {
    const auto& [a, b] = scene.bodies;
    const std::vector<Vec3> ends = points_of(scene.segments);
    const std::vector<Vec3> dots = points_of(scene.dots);
    const std::vector<Vec3> gaps = points_of(scene.gaps);
    GlbScene glb{metres,
                 {{a.name, body_colours[0]},
                  {b.name, body_colours[1]},
                  {"proper contact", contact_colour},
                  {"touch or coplanar", touch_colour},
                  {"shared", mark_colour}},
                 {glb_body(a, 0),
                  glb_body(b, 1),
                  glb_marks("segments", ends, GlbPrimitive::Mode::Lines),
                  glb_marks("points", dots, GlbPrimitive::Mode::Dots)}};
    if (!gaps.empty()) {
        glb.materials.push_back({"near", near_colour});
        glb.meshes.push_back(glb_marks("gaps", gaps, GlbPrimitive::Mode::Lines, near_material));
    }
    return write_glb(glb, path, stop);
}

} // namespace cd
