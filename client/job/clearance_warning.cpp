#include "client/job/clearance_warning.hpp"

#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace cd {

namespace {

double longest_edge(const Corners& corners) {
    return std::max({(corners[1] - corners[0]).stableNorm(),
                     (corners[2] - corners[1]).stableNorm(),
                     (corners[0] - corners[2]).stableNorm()});
}

/// A body as a warning names it.
struct WarnedBody {
    const std::string* name;
    const Mesh* mesh;
};

/// Warns of the first body whose triangles are mostly smaller than the clearance.
std::optional<std::string>
warning_of(const Query& query, const std::string& unit, std::span<const WarnedBody> bodies) {
    if (!query.clearance || query.level < Level::Pairs) {
        return std::nullopt;
    }
    std::set<const Mesh*> known;
    for (const WarnedBody& body : bodies) {
        if (!known.insert(body.mesh).second) {
            continue;
        }
        const double edge = median_edge(*body.mesh);
        if (*query.clearance > edge) {
            return fmt::format("warning: the clearance of {0} {1} exceeds most triangles of {2} "
                               "(median edge {3:.3g} {1}), so lists of near pairs grow long; level "
                               "any or count makes no lists",
                               exact_text(*query.clearance),
                               unit,
                               *body.name,
                               edge);
        }
    }
    return std::nullopt;
}

} // namespace

double median_edge(const Mesh& mesh) {
    std::vector<double> edges;
    edges.reserve(mesh.triangles().size());
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        edges.push_back(longest_edge(mesh.corners(i)));
    }
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::ranges::nth_element(edges, middle);
    return *middle;
}

std::optional<std::string> clearance_warning(const PreparedJob& job) {
    std::vector<WarnedBody> bodies;
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        bodies.push_back({&job.names[i], job.meshes[i].get()});
    }
    return warning_of(job.query, job.spec.unit, bodies);
}

std::optional<std::string> clearance_warning(const JobSpec& spec, const SceneBodies& scene) {
    std::vector<WarnedBody> bodies;
    for (const NamedBody& body : scene.bodies) {
        bodies.push_back({&body.name, scene.meshes[body.mesh].get()});
    }
    return warning_of(spec.query, spec.unit, bodies);
}

} // namespace cd
