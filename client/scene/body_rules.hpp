// The rules of a scene, applied to its bodies.
#pragma once

#include "client/scene/ignored_areas.hpp"
#include "client/scene/scene_bodies.hpp"
#include "client/spec/rules_spec.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/scene/pair_set.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cd {

/// For how many pairs of bodies a rule matters. Each pair counts once.
struct RuleEffect {
    std::uint64_t named = 0; ///< Pairs that the rule names, whole or by their parts.
    /// Pairs of which no later rule names both bodies whole: the rule decides about them, or about
    /// their parts that it names.
    std::uint64_t decided = 0;
};

struct BodyRules {
    PairSet ignored;                 ///< Pairs of bodies that are not tested at all.
    IgnoredAreas ranges;             ///< Ignored parts of other pairs, by pair, a < b.
    std::vector<RuleEffect> effects; ///< Of each rule.
};

/// Finds out which pairs of bodies, and which of their triangles, the rules ignore. Of the rules
/// that name two bodies, or a part of each, the last decides about these.
///
/// Errors: BadInput naming the line, for a rule that names no two different bodies, with the names
/// that exist; also above `limits::scene_rules_max` pairs of bodies with rules about parts, or
/// ranges.
[[nodiscard]] Result<BodyRules> apply_rules(const RulesSpec& rules,
                                            const SceneBodies& scene,
                                            const std::filesystem::path& job_file);

/// Applies the rules of a scene with lines, which are a body after all others. The result has that
/// body, too, and only pairs of which it is one. Errors: as `apply_rules`; BadInput naming the line
/// for a rule that does not name the lines, and where the rules leave no body that lines may hit.
[[nodiscard]] Result<BodyRules> apply_rules_of_lines(const SceneSpec& scene,
                                                     const SceneBodies& bodies,
                                                     const std::filesystem::path& job_file);

} // namespace cd
