#include "web/server/part_filter.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <cstdint>

namespace cd {

namespace {

/// Marks the triangles of all parts with this name. Errors: BadInput if there is none.
Result<std::vector<bool>> triangles_of(const Mesh& mesh, const std::string& name) {
    std::vector<bool> marks;
    if (name.empty()) {
        return marks;
    }
    for (const Part& part : mesh.parts()) {
        if (part.name == name) {
            marks.resize(mesh.triangles().size());
            std::fill(
                marks.begin() + part.triangles_begin, marks.begin() + part.triangles_end, true);
        }
    }
    return marks.empty() ? bad_input("the mesh has no part '" + name + "'") : Result(marks);
}

bool has(const std::vector<bool>& marks, std::uint32_t triangle) {
    return marks.empty() || (triangle < marks.size() && marks[triangle]);
}

} // namespace

Result<PartFilter> PartFilter::make(const Mesh& a,
                                    const std::string& part_a,
                                    const Mesh& b,
                                    const std::string& part_b) {
    auto marks_a = CD_TRY(triangles_of(a, part_a));
    auto marks_b = CD_TRY(triangles_of(b, part_b));
    return PartFilter(std::move(marks_a), std::move(marks_b));
}

bool PartFilter::passes(const ScenarioResult& result) const {
    return is_empty() || std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
               return has(a_, pair.a) && has(b_, pair.b);
           });
}

} // namespace cd
