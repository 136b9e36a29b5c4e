#include "client/picture/body_picture.hpp"

#include "client/picture/rasteriser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cd {

namespace {

constexpr unsigned samples = 3;
constexpr std::array<Colour, 8> part_colours{{{110, 150, 200},
                                              {220, 170, 90},
                                              {130, 180, 120},
                                              {190, 130, 170},
                                              {150, 150, 150},
                                              {110, 190, 190},
                                              {200, 140, 110},
                                              {170, 170, 220}}};

Viewpoint front_right() {
    return {{0.7, -1, 0.6}};
}

/// Returns the 26 directions to the faces, edges and corners of a cube.
std::vector<Viewpoint> viewpoints() {
    std::vector<Viewpoint> found;
    for (const int z : {1, 0, -1}) {
        for (const int y : {-1, 1, 0}) {
            for (const int x : {1, -1, 0}) {
                const bool is_vertical = x == 0 && y == 0;
                if (x != 0 || y != 0 || z != 0) {
                    found.push_back({Vec3(x, y, z), is_vertical ? Vec3(0, 1, 0) : Vec3(0, 0, 1)});
                }
            }
        }
    }
    return found;
}

/// A body with its vertices in world coordinates.
struct PosedBody {
    const PicturedBody* body;
    std::vector<Vec3> vertices;

    [[nodiscard]] std::span<const Triangle> triangles() const { return body->mesh->triangles(); }
    [[nodiscard]] Corners corners(const Triangle& triangle) const {
        return {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
    }
};

std::vector<PosedBody> posed(std::span<const PicturedBody> bodies) {
    std::vector<PosedBody> found;
    for (const PicturedBody& body : bodies) {
        PosedBody& added = found.emplace_back(PosedBody{&body, {}});
        for (const Vec3& vertex : body.mesh->vertices()) {
            added.vertices.push_back(body.pose.apply(vertex));
        }
    }
    return found;
}

Aabb box_of(std::span<const PosedBody> bodies) {
    Aabb box;
    for (const PosedBody& body : bodies) {
        for (const Vec3& vertex : body.vertices) {
            box.add(vertex);
        }
    }
    return box;
}

void draw_marks(std::span<const PosedBody> bodies, Rasteriser& picture) {
    for (const PosedBody& body : bodies) {
        for (const std::uint32_t triangle : body.body->contacts) {
            picture.mark(body.corners(body.triangles()[triangle]), contact_colour);
        }
        for (const std::uint32_t triangle : body.body->near) {
            picture.mark(body.corners(body.triangles()[triangle]), near_colour);
        }
    }
}

/// Hides the marks behind the bodies.
void hide_marks(std::span<const PosedBody> bodies, Rasteriser& picture) {
    for (const PosedBody& body : bodies) {
        picture.hide(body.vertices, body.triangles());
    }
}

void sort_triangles_once(std::vector<std::uint32_t>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

/// Returns the shortest line if the bodies are only near, and it has a direction.
std::optional<GapLine> gap_of(std::span<const PosedBody> bodies, std::span<const GapLine> lines) {
    const auto is_in_contact = [](const PosedBody& body) { return !body.body->contacts.empty(); };
    if (lines.empty() || std::ranges::any_of(bodies, is_in_contact)) {
        return std::nullopt;
    }
    const auto length = [](const GapLine& line) { return (line[1] - line[0]).stableNorm(); };
    const GapLine& gap = *std::ranges::min_element(lines, {}, length);
    const double shortest = length(gap);
    return shortest > 0 && std::isfinite(shortest) ? std::optional(gap) : std::nullopt;
}

/// Returns the sine of the angle between two directions; 0 below 45 degrees.
double sine_of_large_angle(const Vec3& direction, const GapLine& gap) {
    constexpr double half = 0.5 * (1 + 1e-9); // Directions to a cube's edges may be at 45 degrees.
    const double cosine = direction.normalized().dot((gap[1] - gap[0]).stableNormalized());
    return cosine * cosine <= half ? std::sqrt(1 - cosine * cosine) : 0;
}

/// Returns the viewpoint of the 26 from which a gap is seen best.
Viewpoint best_of_gap(std::span<const PosedBody> bodies, const Aabb& scene, const GapLine& gap) {
    constexpr PictureSize small{160, 100};
    Viewpoint best = front_right();
    double most = 0;
    for (const Viewpoint& eye : viewpoints()) {
        const double sine = sine_of_large_angle(eye.towards_eye, gap);
        if (sine == 0) {
            continue;
        }
        Rasteriser picture(small.width, small.height, 1, eye, scene);
        draw_marks(bodies, picture);
        picture.mark_line(gap[0], gap[1], gap_colour);
        hide_marks(bodies, picture);
        const double seen = sine * static_cast<double>(1 + picture.marks_in_sight());
        if (seen > most) {
            most = seen;
            best = eye;
        }
    }
    return best;
}

Viewpoint best_viewpoint(std::span<const PosedBody> bodies, const Aabb& scene) {
    constexpr PictureSize small{160, 100};
    Viewpoint best = front_right();
    std::size_t most = 0;
    for (const Viewpoint& eye : viewpoints()) {
        Rasteriser picture(small.width, small.height, 1, eye, scene);
        draw_marks(bodies, picture);
        hide_marks(bodies, picture);
        const std::size_t seen = picture.marks_in_sight();
        if (seen > most) {
            most = seen;
            best = eye;
        }
    }
    return best;
}

Viewpoint
viewpoint_of(std::span<const PosedBody> bodies, const Aabb& scene, std::span<const GapLine> lines) {
    if (const std::optional<GapLine> gap = gap_of(bodies, lines)) {
        return best_of_gap(bodies, scene, *gap);
    }
    const bool has_marks = std::ranges::any_of(bodies, [](const PosedBody& body) {
        return !body.body->contacts.empty() || !body.body->near.empty();
    });
    return has_marks ? best_viewpoint(bodies, scene) : front_right();
}

} // namespace

std::vector<PicturedBody>
pictured(const Mesh& a, const Mesh& b, const PosePair& poses, std::span<const ContactPair> pairs) {
    std::vector<PicturedBody> bodies{{&a, poses.a, body_colours[0], {}},
                                     {&b, poses.b, body_colours[1], {}}};
    for (const ContactPair& pair : pairs) {
        const auto list =
            pair.kind == PairClass::Near ? &PicturedBody::near : &PicturedBody::contacts;
        (bodies[0].*list).push_back(pair.a);
        (bodies[1].*list).push_back(pair.b);
    }
    for (PicturedBody& body : bodies) {
        sort_triangles_once(body.contacts);
        sort_triangles_once(body.near);
        std::erase_if(body.near, [&](std::uint32_t triangle) {
            return std::ranges::binary_search(body.contacts, triangle);
        });
    }
    return bodies;
}

Image draw_parts(const Mesh& mesh, PictureSize size) {
    Rasteriser picture(
        size.width, size.height, samples, front_right(), bounding_box(mesh.vertices()));
    std::size_t part = 0;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        while (part < mesh.parts().size() && i >= mesh.parts()[part].triangles_end) {
            ++part;
        }
        picture.draw(mesh.corners(i), part_colours[part % part_colours.size()]);
    }
    return picture.image();
}

std::vector<GapLine> gap_lines(const ScenarioResult& result) {
    std::vector<GapLine> lines;
    for (std::size_t i = 0; i < result.pairs.size() && i + 1 < result.point_offsets.size(); ++i) {
        if (result.pairs[i].kind == PairClass::Near) {
            const Vec3* const ends = &result.points[result.point_offsets[i]];
            const Vec3& origin = result.point_origins[i];
            lines.push_back({origin + ends[0], origin + ends[1]});
        }
    }
    return lines;
}

Viewpoint viewpoint_of(std::span<const PicturedBody> bodies, std::span<const GapLine> lines) {
    const std::vector<PosedBody> in_world = posed(bodies);
    return viewpoint_of(in_world, box_of(in_world), lines);
}

Image draw_contacts(std::span<const PicturedBody> pictured_bodies,
                    PictureSize size,
                    std::span<const GapLine> lines) {
    const std::vector<PosedBody> bodies = posed(pictured_bodies);
    const Aabb scene = box_of(bodies);
    const Viewpoint eye = viewpoint_of(bodies, scene, lines);
    Rasteriser picture(size.width, size.height, samples, eye, scene);
    for (const PosedBody& body : bodies) {
        for (const Triangle& triangle : body.triangles()) {
            picture.draw(body.corners(triangle), body.body->colour);
        }
    }
    draw_marks(bodies, picture);
    for (const GapLine& line : lines) {
        picture.mark_line(line[0], line[1], gap_colour);
    }
    return picture.image();
}

} // namespace cd
