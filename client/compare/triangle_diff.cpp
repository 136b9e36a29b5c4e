#include "client/compare/triangle_diff.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t latest_bytes_max = 16u << 20;

} // namespace

void TriangleDiff::Map::add(const ScenarioResult& result) {
    latest.add(result.pairs);
    if (latest.bytes() > latest_bytes_max) {
        total.add(latest.take());
    }
}

ContactMap TriangleDiff::Map::whole() {
    total.add(latest.take());
    return total.map();
}

void TriangleDiff::add(const PairedResult& pair) {
    if (pair.is_comparable()) {
        earlier_.add(*pair.was);
        later_.add(*pair.is);
    }
}

void TriangleDiff::add(const ContactMap& earlier, const ContactMap& later) {
    earlier_.total.add(earlier);
    later_.total.add(later);
}

/// Returns the triangles that are in contact in one run or both, ascending.
std::vector<TriangleChange> TriangleDiff::all(std::size_t body) {
    std::vector<TriangleChange> all;
    const ContactMap was = earlier_.whole();
    const ContactMap is = later_.whole();
    auto left = was.bodies[body].begin();
    auto right = is.bodies[body].begin();
    while (left != was.bodies[body].end() || right != is.bodies[body].end()) {
        const bool has_left = left != was.bodies[body].end() &&
                              (right == is.bodies[body].end() || left->triangle <= right->triangle);
        const bool has_right =
            right != is.bodies[body].end() &&
            (left == was.bodies[body].end() || right->triangle <= left->triangle);
        all.push_back({has_left ? left->triangle : right->triangle,
                       has_left ? left->scenarios : 0,
                       has_right ? right->scenarios : 0});
        left += has_left ? 1 : 0;
        right += has_right ? 1 : 0;
    }
    return all;
}

std::vector<TriangleChange> TriangleDiff::changes(std::size_t body) {
    std::vector<TriangleChange> changes = all(body);
    std::erase_if(changes,
                  [](const TriangleChange& change) { return change.earlier == change.later; });
    return changes;
}

TriangleCounts TriangleDiff::counts(std::size_t body) {
    TriangleCounts counts;
    for (const TriangleChange& change : all(body)) {
        ++(change.earlier == 0 ? counts.only_later
           : change.later == 0 ? counts.only_earlier
                               : counts.in_both);
    }
    return counts;
}

} // namespace cd
