#include "client/view/part_filter.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace cd {

namespace {

Result<std::vector<Part>> parts_of(const Mesh& mesh, const std::string& name) {
    std::vector<Part> found;
    if (name.empty()) {
        return found;
    }
    std::ranges::copy_if(mesh.parts(), std::back_inserter(found), [&](const Part& part) {
        return part.name == name;
    });
    if (found.empty()) {
        return bad_input("the mesh has no part '" + name + "'");
    }
    return found;
}

bool hold(const std::vector<Part>& parts, std::uint32_t triangle) {
    return parts.empty() || std::ranges::any_of(parts, [&](const Part& part) {
               return part.triangles_begin <= triangle && triangle < part.triangles_end;
           });
}

} // namespace

Result<PartFilter> PartFilter::make(const Mesh& a,
                                    const std::string& part_a,
                                    const Mesh& b,
                                    const std::string& part_b) {
    auto parts_a = CD_TRY(parts_of(a, part_a));
    auto parts_b = CD_TRY(parts_of(b, part_b));
    return PartFilter(std::move(parts_a), std::move(parts_b));
}

bool PartFilter::passes(const ScenarioResult& result) const {
    return is_empty() || std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
               return hold(a_, pair.a) && hold(b_, pair.b);
           });
}

} // namespace cd
