#include "client/scene/body_rules.hpp"

#include "client/scene/rule_pattern.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <ranges>
#include <utility>

namespace cd {

namespace {

/// One of the two names of a rule, and the bodies that it names.
struct RuleSide {
    RulePattern pattern;
    std::vector<std::uint32_t> bodies;
};

struct ResolvedRule {
    bool ignores = true;
    RuleSide one;
    RuleSide other;

    [[nodiscard]] bool is_about_parts() const {
        return one.pattern.has_part() || other.pattern.has_part();
    }
};

/// A rule about parts of a pair of bodies.
struct PartRule {
    const ResolvedRule* rule = nullptr;
    bool one_is_a = true; ///< The rule's first name is for body a of the pair.
};

/// Returns the number of pairs of different bodies, one in each list. The lists ascend.
std::uint64_t pairs_between(const std::vector<std::uint32_t>& one,
                            const std::vector<std::uint32_t>& other) {
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(one, other, std::back_inserter(common));
    const std::uint64_t both = common.size();
    // A pair of bodies that are in both lists is among the products twice, a body with itself once.
    return one.size() * other.size() - both - (both < 2 ? 0 : both * (both - 1) / 2);
}

/// Leaves only the pairs of a rule that have this body. Does nothing if neither name has it.
void narrow_to(std::uint32_t body, ResolvedRule& rule) {
    const auto has_it = [&](const RuleSide& side) {
        return std::ranges::find(side.bodies, body) != side.bodies.end();
    };
    const bool is_one = has_it(rule.one);
    if (is_one && has_it(rule.other)) { // Then neither name is about parts: the lines have none.
        std::vector<std::uint32_t> all;
        std::ranges::set_union(rule.one.bodies, rule.other.bodies, std::back_inserter(all));
        std::erase(all, body);
        rule.other.bodies = std::move(all);
    }
    if (is_one || has_it(rule.other)) {
        (is_one ? rule.one : rule.other).bodies = {body};
    }
}

class RuleExpansion {
  public:
    /// With lines, which are the last body, all counts and results are of pairs that have them.
    RuleExpansion(const RulesSpec& rules,
                  const SceneBodies& scene,
                  const std::filesystem::path& job_file,
                  bool has_lines = false)
        : rules_(rules),
          scene_(scene),
          job_file_(job_file),
          has_lines_(has_lines),
          decided_(scene.bodies.size()),
          made_{PairSet(scene.bodies.size()), {}, std::vector<RuleEffect>(rules.order.size())} {}

    Result<BodyRules> run() {
        for (const SceneRule& rule : rules_.order) {
            auto resolved = CD_TRY(resolve(rule));
            resolved_.push_back(std::move(resolved));
        }
        // The last rule that names a pair decides, so the first does if they are taken in reverse.
        for (std::size_t i = resolved_.size(); i-- > 0;) {
            CD_TRY(resolved_[i].is_about_parts() ? take_parts(i) : take_bodies(i));
        }
        for (const auto& [pair, rules] : parts_) {
            CD_TRY(settle(pair, rules));
        }
        return std::move(made_);
    }

  private:
    /// Returns the error of a rule, with its line.
    [[nodiscard]] Error problem(const SceneRule& rule, const std::string& what) const {
        return error_in_job(job_file_, rule.line, "[rules] " + rule_text(rule) + ": " + what);
    }

    [[nodiscard]] Result<ResolvedRule> resolve(const SceneRule& rule) const {
        ResolvedRule resolved;
        resolved.ignores = rule.ignores;
        for (const auto& [side, text] :
             {std::pair(&resolved.one, &rule.one), std::pair(&resolved.other, &rule.other)}) {
            side->pattern = RulePattern::from_text(*text);
            auto bodies = side->pattern.bodies_of(scene_);
            if (!bodies) {
                return problem(rule, bodies.error().detail);
            }
            side->bodies = std::move(bodies.value());
        }
        if (pairs_between(resolved.one.bodies, resolved.other.bodies) == 0) {
            return problem(rule,
                           "both names are those of the body \"" +
                               scene_.bodies[resolved.one.bodies.front()].name +
                               "\" alone, and no body is tested against itself; remove the rule");
        }
        if (has_lines_) {
            const auto lines = static_cast<std::uint32_t>(scene_.bodies.size() - 1);
            narrow_to(lines, resolved);
            if (resolved.one.bodies.back() != lines && resolved.other.bodies.back() != lines) {
                return problem(rule,
                               "with [shots], bodies are tested against \"lines\" alone, and "
                               "neither name is that of the lines; write { ignore = [\"body\", "
                               "\"lines\"] }, or leave out the rule");
            }
        }
        return resolved;
    }

    /// Takes a rule about whole bodies, in reverse order.
    Status take_bodies(std::size_t number) {
        const ResolvedRule& rule = resolved_[number];
        if (rule.ignores) {
            made_.ignored.add_except(rule.one.bodies, rule.other.bodies, decided_);
        }
        made_.effects[number].named = pairs_between(rule.one.bodies, rule.other.bodies);
        made_.effects[number].decided = decided_.add(rule.one.bodies, rule.other.bodies);
        return Done{};
    }

    /// Takes a rule about parts, in reverse order.
    Status take_parts(std::size_t number) {
        const ResolvedRule& rule = resolved_[number];
        RuleEffect& effect = made_.effects[number];
        effect.named = pairs_between(rule.one.bodies, rule.other.bodies);
        if (effect.named > limits::scene_rules_max) {
            return too_many(number);
        }
        for (const std::uint32_t one : rule.one.bodies) {
            for (const std::uint32_t other : rule.other.bodies) {
                const BodyPair pair{std::min(one, other), std::max(one, other)};
                if (one == other || decided_.has(pair)) {
                    continue;
                }
                std::vector<PartRule>& rules = parts_[pair];
                // A rule may name a pair in both orders.
                effect.decided += rules.empty() || rules.back().rule != &rule ? 1 : 0;
                rules.push_back({&rule, one < other});
                if (++part_rules_ > limits::scene_rules_max) {
                    return too_many(number);
                }
            }
        }
        return Done{};
    }

    /// Finds the ranges of a pair whose parts have rules, which are in reverse order.
    Status settle(BodyPair pair, const std::vector<PartRule>& rules) {
        const IgnoredRange all{0, triangles_of(pair.a), 0, triangles_of(pair.b), pair.a, pair.b};
        IgnoredAreas areas;
        if (made_.ignored.has(pair)) {
            areas.push_back(all);
        }
        for (const PartRule& part : std::views::reverse(rules)) {
            for (const IgnoredRange& range : ranges_of(pair, part)) {
                if (part.rule->ignores) {
                    areas.push_back(range);
                } else {
                    subtract(areas, range);
                }
            }
        }
        if (std::ranges::find(areas, all) != areas.end()) {
            made_.ignored.add({&pair.a, 1}, {&pair.b, 1});
            return Done{};
        }
        made_.ignored.remove(pair);
        if (made_.ranges.size() + areas.size() > limits::scene_rules_max) {
            return too_many(static_cast<std::size_t>(rules.front().rule - resolved_.data()));
        }
        made_.ranges.insert(made_.ranges.end(), areas.begin(), areas.end());
        return Done{};
    }

    [[nodiscard]] std::vector<IgnoredRange> ranges_of(BodyPair pair, const PartRule& part) const {
        const RuleSide& side_a = part.one_is_a ? part.rule->one : part.rule->other;
        const RuleSide& side_b = part.one_is_a ? part.rule->other : part.rule->one;
        std::vector<IgnoredRange> ranges;
        for (const auto& [a_begin, a_end] : side_a.pattern.ranges_of(mesh_of(pair.a))) {
            for (const auto& [b_begin, b_end] : side_b.pattern.ranges_of(mesh_of(pair.b))) {
                ranges.push_back({a_begin, a_end, b_begin, b_end, pair.a, pair.b});
            }
        }
        return ranges;
    }

    [[nodiscard]] Error too_many(std::size_t number) const {
        return problem(rules_.order[number],
                       "with this rule, more than " + grouped(limits::scene_rules_max) +
                           " pairs of parts have rules; name whole bodies, or fewer of them");
    }
    [[nodiscard]] const Mesh& mesh_of(std::uint32_t body) const {
        return scene_.mesh_of(scene_.bodies[body]);
    }
    [[nodiscard]] std::uint32_t triangles_of(std::uint32_t body) const {
        return static_cast<std::uint32_t>(mesh_of(body).triangles().size());
    }

    const RulesSpec& rules_;
    const SceneBodies& scene_;
    const std::filesystem::path& job_file_;
    bool has_lines_ = false;
    std::vector<ResolvedRule> resolved_; ///< Of each rule.
    PairSet decided_;                    ///< Pairs that a rule taken so far names whole.
    /// Rules about parts of pairs, taken before the one that decides about the whole bodies.
    std::map<BodyPair, std::vector<PartRule>> parts_;
    std::size_t part_rules_ = 0; ///< Number of all rules in `parts_`.
    BodyRules made_;
};

/// Adds the lines to the bodies of a scene. The mesh has as many lines as that of the job, which
/// waits for the rules: they tell what lines have to cover.
Result<SceneBodies> with_lines(const SceneSpec& scene, SceneBodies bodies) {
    constexpr double any = 1;
    const Aabb box{Vec3::Constant(-any), Vec3::Constant(any)};
    Mesh lines = CD_TRY(shot_mesh(*scene.shots, scene.shots->box.value_or(box)));
    bodies.bodies.push_back({std::string(lines_name),
                             {},
                             static_cast<std::uint32_t>(scene.bodies.size()),
                             static_cast<std::uint32_t>(bodies.meshes.size())});
    bodies.meshes.push_back(std::make_shared<const Mesh>(std::move(lines)));
    return bodies;
}

} // namespace

Result<BodyRules> apply_rules(const RulesSpec& rules,
                              const SceneBodies& scene,
                              const std::filesystem::path& job_file) {
    return RuleExpansion(rules, scene, job_file).run();
}

Result<BodyRules> apply_rules_of_lines(const SceneSpec& scene,
                                       const SceneBodies& bodies,
                                       const std::filesystem::path& job_file) {
    if (scene.rules.order.empty()) {
        return BodyRules{PairSet(bodies.bodies.size() + 1), {}, {}};
    }
    const SceneBodies all = CD_TRY(with_lines(scene, bodies));
    auto rules = CD_TRY(RuleExpansion(scene.rules, all, job_file, true).run());
    if (rules.ignored.count() == bodies.bodies.size()) {
        return bad_input(job_file,
                         "[rules] ignore every body with \"lines\", so that lines can hit none; "
                         "leave out a rule, or test a body with them");
    }
    return rules;
}

} // namespace cd
