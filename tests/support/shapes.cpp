#include "tests/support/shapes.hpp"

#include "common/core/check.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

namespace cd::tests {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Returns the normalised sum, computed in one fixed order.
Vec3 middle_on_sphere(const Vec3& a, const Vec3& b) {
    const double x = a.x() + b.x();
    const double y = a.y() + b.y();
    const double z = a.z() + b.z();
    const double length = std::sqrt((x * x + y * y) + z * z);
    return {x / length, y / length, z / length};
}

/// Numbers vertices by grid position, each once.
class GridVertices {
  public:
    using Place = std::array<std::size_t, 3>;

    explicit GridVertices(std::array<std::vector<double>, 3> ticks) : ticks_(std::move(ticks)) {}

    std::uint32_t at(const Place& place) {
        const auto [found, is_new] =
            numbers_.emplace(place, static_cast<std::uint32_t>(vertices.size()));
        if (is_new) {
            vertices.emplace_back(ticks_[0][place[0]], ticks_[1][place[1]], ticks_[2][place[2]]);
        }
        return found->second;
    }

    std::vector<Vec3> vertices;

  private:
    std::array<std::vector<double>, 3> ticks_;
    std::map<Place, std::uint32_t> numbers_;
};

} // namespace

void add_quad(std::vector<Triangle>& triangles, const std::array<std::uint32_t, 4>& corners) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
}

double uniform(std::mt19937_64& random, double low, double high) {
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
    return low + (high - low) * unit;
}

Vec3 random_point(std::mt19937_64& random, double half_width) {
    const double x = uniform(random, -half_width, half_width);
    const double y = uniform(random, -half_width, half_width);
    const double z = uniform(random, -half_width, half_width);
    return {x, y, z};
}

Mesh make_mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
    MeshArrays arrays;
    arrays.vertices = std::move(vertices);
    arrays.triangles = std::move(triangles);
    auto mesh = Mesh::create(std::move(arrays));
    CD_CHECK(mesh.has_value());
    return std::move(mesh.value());
}

std::shared_ptr<const Mesh> share(Mesh mesh) {
    return std::make_shared<const Mesh>(std::move(mesh));
}

Mesh make_soup(std::vector<Vec3> corners) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) {
        triangles.push_back({i, i + 1, i + 2});
    }
    return make_mesh(std::move(corners), std::move(triangles));
}

Mesh make_triangle_soup(std::mt19937_64& random, std::uint32_t count, double size) {
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 center = random_point(random, 1.0);
        for (int corner = 0; corner < 3; ++corner) {
            corners.emplace_back(center + random_point(random, 0.5 * size));
        }
    }
    return make_soup(std::move(corners));
}

Mesh make_sphere(int subdivisions) {
    std::vector<Vec3> vertices{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Triangle> triangles{
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int round = 0; round < subdivisions; ++round) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, is_new] =
                middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices.size()));
            if (is_new) {
                vertices.push_back(middle_on_sphere(vertices[a], vertices[b]));
            }
            return place->second;
        };
        std::vector<Triangle> finer;
        for (const Triangle& t : triangles) {
            const std::uint32_t ab = middle(t[0], t[1]);
            const std::uint32_t bc = middle(t[1], t[2]);
            const std::uint32_t ca = middle(t[2], t[0]);
            finer.insert(finer.end(),
                         {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_box(const Vec3& size) {
    return make_gridded_box(size, 1);
}

Mesh make_gridded_box(const Vec3& size, int n) {
    std::array<std::vector<double>, 3> ticks;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int i = 0; i <= n; ++i) {
            const double share = static_cast<double>(i) / n - 0.5;
            ticks[axis].push_back(size[static_cast<Eigen::Index>(axis)] * share);
        }
    }
    return make_ticked_box(ticks[0], ticks[1], ticks[2]);
}

Mesh make_box_between(const Vec3& low, const Vec3& high) {
    return make_ticked_box({low.x(), high.x()}, {low.y(), high.y()}, {low.z(), high.z()});
}

Mesh make_ticked_box(const std::vector<double>& x,
                     const std::vector<double>& y,
                     const std::vector<double>& z) {
    const std::array<std::size_t, 3> cells{x.size() - 1, y.size() - 1, z.size() - 1};
    GridVertices grid({x, y, z});
    std::vector<Triangle> triangles;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        for (const bool top : {false, true}) {
            for (std::size_t i = 0; i < cells[u]; ++i) {
                for (std::size_t j = 0; j < cells[v]; ++j) {
                    const auto corner = [&](std::size_t du, std::size_t dv) {
                        GridVertices::Place place{};
                        place[axis] = top ? cells[axis] : 0;
                        place[u] = i + du;
                        place[v] = j + dv;
                        return grid.at(place);
                    };
                    std::array<std::uint32_t, 4> quad{
                        corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (!top) {
                        std::swap(quad[1], quad[3]);
                    }
                    add_quad(triangles, quad);
                }
            }
        }
    }
    return make_mesh(std::move(grid.vertices), std::move(triangles));
}

Mesh make_torus(double radius, double tube, int around, int across) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int i = 0; i < around; ++i) {
        const double u = 2 * pi * i / around;
        for (int j = 0; j < across; ++j) {
            const double v = 2 * pi * j / across;
            const double r = radius + tube * std::cos(v);
            vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
        }
    }
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            add_quad(triangles,
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_degenerate_soup(std::mt19937_64& random, std::uint32_t count) {
    std::vector<Vec3> vertices;
    for (int x = -2; x <= 2; ++x) {
        for (int y = -2; y <= 2; ++y) {
            for (int z = -2; z <= 2; ++z) {
                vertices.emplace_back(0.5 * x, 0.5 * y, 0.5 * z);
            }
        }
    }
    const auto any_vertex = [&] { return static_cast<std::uint32_t>(random() % vertices.size()); };
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        Triangle triangle{any_vertex(), any_vertex(), any_vertex()};
        switch (random() % 5) {
        case 0:
            triangle[2] = triangle[0]; // A segment.
            break;
        case 1:
            triangle = {triangle[0], triangle[0], triangle[0]}; // A point.
            break;
        case 2:
            if (!triangles.empty()) { // A duplicate with rotated corners.
                const Triangle& earlier = triangles[random() % triangles.size()];
                triangle = {earlier[1], earlier[2], earlier[0]};
            }
            break;
        default:
            break;
        }
        triangles.push_back(triangle);
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh make_staircase(std::uint32_t count) {
    std::vector<Vec3> vertices = {Vec3::Zero()};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double size = 1.0 + 0.01 * i;
        vertices.emplace_back(size, 0, 0);
        vertices.emplace_back(size, 1e-3, 0);
        triangles.push_back({0, 2 * i + 1, 2 * i + 2});
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh join(const std::vector<Mesh>& meshes) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Mesh& mesh : meshes) {
        const auto offset = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
        for (const Triangle& t : mesh.triangles()) {
            triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
        }
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

Mesh reversed(const Mesh& mesh) {
    std::vector<Triangle> triangles = mesh.triangles();
    for (Triangle& triangle : triangles) {
        std::swap(triangle[1], triangle[2]);
    }
    return make_mesh(mesh.vertices(), std::move(triangles));
}

Mesh mapped(const Mesh& mesh, const std::function<Vec3(const Vec3&)>& map) {
    std::vector<Vec3> vertices;
    for (const Vec3& vertex : mesh.vertices()) {
        vertices.push_back(map(vertex));
    }
    return make_mesh(std::move(vertices), mesh.triangles());
}

Mesh unshared(const Mesh& mesh) {
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        const Corners of_one = mesh.corners(i);
        corners.insert(corners.end(), of_one.begin(), of_one.end());
    }
    return make_soup(std::move(corners));
}

Mesh scaled(const Mesh& mesh, double factor) {
    return mapped(mesh, [&](const Vec3& vertex) { return Vec3(factor * vertex); });
}

Mesh as_floats(const Mesh& mesh) {
    MeshArrays arrays{{}, mesh.triangles(), {}, Precision::Float};
    // Goes through memory: in place, GCC 12 drops the rounding when it vectorises by two.
    std::vector<float> narrow;
    for (const Vec3& vertex : mesh.vertices()) {
        for (const double coordinate : vertex) {
            narrow.push_back(static_cast<float>(coordinate));
        }
    }
    for (std::size_t i = 0; i < narrow.size(); i += 3) {
        arrays.vertices.emplace_back(narrow[i], narrow[i + 1], narrow[i + 2]);
    }
    return Mesh::create(std::move(arrays)).value();
}

Mesh translated(const Mesh& mesh, const Vec3& offset) {
    return mapped(mesh, [&](const Vec3& vertex) { return Vec3(vertex + offset); });
}

Pose make_pose(std::mt19937_64& random, double reach) {
    Quaternion q;
    double norm = 0;
    do {
        q.w = uniform(random, -1, 1);
        q.x = uniform(random, -1, 1);
        q.y = uniform(random, -1, 1);
        q.z = uniform(random, -1, 1);
        norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    } while (norm > 1 || norm < 0.01);
    const double scale = 1 / std::sqrt(norm);
    q = {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
    return Pose::from_quaternion(q, random_point(random, reach));
}

Pose make_matrix_pose(std::mt19937_64& random, double reach) {
    const Pose pose = make_pose(random, reach);
    return Pose::from_matrix(pose.rotation(), pose.translation());
}

Pose translation_pose(double x, double y, double z) {
    return Pose::from_matrix(Mat3::Identity(), {x, y, z});
}

std::optional<std::filesystem::path> find_model(const std::string& name) {
    const char* folder = std::getenv("CD_MESHES");
    const std::filesystem::path path =
        std::filesystem::path(folder != nullptr ? folder : CD_MESHES) / name;
    return std::filesystem::exists(path) ? std::optional(path) : std::nullopt;
}

bool skips_are_failures() {
    const char* ci = std::getenv("CI");
    return ci != nullptr && std::string_view(ci) == "true";
}

} // namespace cd::tests
