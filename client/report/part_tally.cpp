#include "client/report/part_tally.hpp"

#include <algorithm>

namespace cd {

PartTally::PartTally(const std::vector<std::shared_ptr<const Mesh>>& meshes) {
    for (const auto& mesh : meshes) {
        const std::vector<std::uint64_t> zeros(mesh->parts().size());
        bodies_.push_back({PartFinder(mesh), zeros, zeros});
    }
}

void PartTally::note(Body& body, std::uint32_t triangle, std::uint64_t stamp) {
    const auto part = body.parts.find(triangle);
    if (part && body.last_seen[*part] != stamp) {
        body.last_seen[*part] = stamp;
        ++body.scenarios[*part];
    }
}

void PartTally::add(const ScenarioResult& result) {
    ++stamp_;
    for (const ContactPair& pair : result.pairs) {
        note(bodies_[result.body_a], pair.a, stamp_);
        note(bodies_[result.body_b], pair.b, stamp_);
    }
}

std::vector<PartTally::Touched> PartTally::most_touched(std::size_t count) const {
    std::vector<Touched> touched;
    for (const Body& body : bodies_) {
        const auto parts = body.parts.parts();
        for (std::size_t i = 0; parts.size() > 1 && i < parts.size(); ++i) {
            if (body.scenarios[i] != 0) {
                touched.push_back({parts[i].name, body.scenarios[i]});
            }
        }
    }
    std::stable_sort(touched.begin(), touched.end(), [](const Touched& left, const Touched& right) {
        return left.scenarios > right.scenarios;
    });
    touched.resize(std::min(touched.size(), count));
    return touched;
}

} // namespace cd
