#include "web/server/part_filter.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <string>

namespace cd {

namespace {

/// Returns the number of the part with this name; nothing for an empty name.
Result<std::optional<std::uint32_t>> number_of(const NamedParts& parts, const std::string& name) {
    if (name.empty()) {
        return std::optional<std::uint32_t>();
    }
    const auto found = std::ranges::find(parts.names, name);
    if (found == parts.names.end()) {
        return bad_input("the body has no part '" + name + "'");
    }
    return std::optional(static_cast<std::uint32_t>(found - parts.names.begin()));
}

} // namespace

Result<PartFilter> PartFilter::make(const PartsOfBodies& parts, const NextContact& wanted) {
    PartFilter filter;
    filter.parts_ = parts;
    filter.next_ = wanted;
    filter.wanted_ = {CD_TRY(number_of(*parts[0], wanted.part_a)),
                      CD_TRY(number_of(*parts[1], wanted.part_b))};
    return filter;
}

bool PartFilter::has(std::size_t body, std::uint32_t triangle) const {
    const auto& wanted = wanted_[body];
    if (!wanted) {
        return true;
    }
    const PartRuns& runs = parts_[body]->runs;
    return runs.runs()[runs.run_of(triangle)].part == *wanted;
}

bool PartFilter::passes(const ScenarioResult& result) const {
    return is_empty() || std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
               return next_.has_pair(pair.kind) && has(0, pair.a) && has(1, pair.b);
           });
}

} // namespace cd
