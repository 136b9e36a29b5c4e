#include "web/server/part_filter.hpp"

#include "common/core/errors.hpp"
#include "web/server/scene/body_filter.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// Returns the number of the part with this name.
Result<std::uint32_t> number_of(const NamedParts& parts, const std::string& name) {
    const auto found = std::ranges::find(parts.names, name);
    if (found == parts.names.end()) {
        return bad_input("the body has no part '" + name + "'");
    }
    return static_cast<std::uint32_t>(found - parts.names.begin());
}

/// Returns the number of a part's body; `side` is its number in a job of two bodies, where the body
/// may be left out.
Result<std::uint32_t>
body_of(std::span<const std::string> bodies, const std::string& body, std::uint32_t side) {
    if (!body.empty()) {
        return body_number(bodies, body);
    }
    if (bodies.size() != 2) {
        return bad_input("the parts of a scene are looked for with their bodies: body_a, body_b");
    }
    return side;
}

} // namespace

Result<PartFilter> PartFilter::make(std::span<const std::string> bodies,
                                    const PartsOfBody& parts,
                                    const NextContact& wanted) {
    PartFilter filter;
    filter.next_ = wanted;
    const std::array sides{std::tuple(&wanted.part_a, &wanted.body_a, 0u),
                           std::tuple(&wanted.part_b, &wanted.body_b, 1u)};
    for (const auto& [part, body, side] : sides) {
        if (part->empty()) {
            continue;
        }
        Wanted one;
        one.body = CD_TRY(body_of(bodies, *body, side));
        one.parts = CD_TRY(parts(one.body));
        one.part = CD_TRY(number_of(*one.parts, *part));
        filter.wanted_.push_back(std::move(one));
    }
    return filter;
}

bool PartFilter::Wanted::has(const ScenarioHead& result, const ContactPair& pair) const {
    const PartRuns& runs = parts->runs;
    return runs.runs()[runs.run_of(result.body_a == body ? pair.a : pair.b)].part == part;
}

bool PartFilter::passes(const ScenarioResult& result) const {
    const auto is_in = [&](const Wanted& one) { return one.is_in(result); };
    return is_empty() || (std::ranges::all_of(wanted_, is_in) &&
                          std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
                              return next_.has_pair(pair.kind) &&
                                     std::ranges::all_of(wanted_, [&](const Wanted& one) {
                                         return one.has(result, pair);
                                     });
                          }));
}

} // namespace cd
