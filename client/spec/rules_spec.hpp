// The rules of a scene: which pairs of its bodies, or of their parts, are tested.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

class TomlFields;

/// Tests or ignores the pairs of different bodies that the patterns name, in either order. A
/// pattern is "body", "body/part", or either with "group:NAME" as the body, which names all bodies
/// of a group. It has the wildcards of a shell; a backslash makes the next of / * ? [ an ordinary
/// character.
struct SceneRule {
    bool ignores = true; ///< If false, the rule tests the pairs.
    std::string one;
    std::string other;
    std::uint32_t line = 0; ///< Line in the job file; 0 without a file.
};

/// The table [rules]. Of the rules that name a pair the last decides; a pair without a rule is
/// tested.
struct RulesSpec {
    std::vector<SceneRule> order;
    /// The step whose pairs in contact are listed as rules to paste.
    std::optional<std::uint64_t> learn = std::nullopt;
};

/// Reads the table [rules], which may be missing. Throws a `Refusal`.
[[nodiscard]] RulesSpec read_rules(const TomlFields& job);

/// Returns a rule as a job file has it: { ignore = ["car.*", "ground"] }.
[[nodiscard]] std::string rule_text(const SceneRule& rule);

} // namespace cd
