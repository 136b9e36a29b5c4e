#include "client/job/clearance_warning.hpp"

#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace cd {

namespace {

double longest_edge(const Corners& corners) {
    return std::max({(corners[1] - corners[0]).stableNorm(),
                     (corners[2] - corners[1]).stableNorm(),
                     (corners[0] - corners[2]).stableNorm()});
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
    if (!job.query.clearance || job.query.level < Level::Pairs) {
        return std::nullopt;
    }
    std::set<const Mesh*> known;
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        if (!known.insert(job.meshes[i].get()).second) {
            continue;
        }
        const double edge = median_edge(*job.meshes[i]);
        if (*job.query.clearance > edge) {
            return fmt::format("warning: the clearance of {0} {1} exceeds most triangles of {2} "
                               "(median edge {3:.3g} {1}), so lists of near pairs grow long; level "
                               "any or count makes no lists",
                               exact_text(*job.query.clearance),
                               job.spec.unit,
                               job.names[i],
                               edge);
        }
    }
    return std::nullopt;
}

} // namespace cd
