#include "client/scene/scene_check.hpp"

#include "client/scene/coverage_text.hpp"
#include "client/scene/rule_pattern.hpp"
#include "common/core/words.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cd {

namespace {

std::string bodies_counted(std::uint64_t bodies) {
    return grouped(bodies) + (bodies == 1 ? " body" : " bodies");
}

/// Returns the line of an entry of [bodies], whose bodies these are.
std::string entry_line(const SceneBodySpec& entry,
                       const SceneBodies& scene,
                       const std::vector<const NamedBody*>& bodies) {
    std::uint64_t triangles = 0;
    for (const NamedBody* body : bodies) {
        triangles += scene.mesh_of(*body).triangles().size();
    }
    std::string text = "  " + entry.name + ": ";
    text += bodies.size() == 1 ? "" : bodies_counted(bodies.size()) + ", ";
    text += entry.mesh.path.filename().string() + ", ";
    text += entry.count && bodies.size() > 1
                ? counted(triangles / bodies.size(), "triangle") + " each"
                : counted(triangles, "triangle");
    return text + (entry.group.empty() ? "" : ", group " + entry.group) + "\n";
}

std::string entries_text(const SceneSpec& spec, const SceneBodies& scene) {
    std::vector<std::vector<const NamedBody*>> by_entry(spec.bodies.size());
    for (const NamedBody& body : scene.bodies) {
        by_entry[body.entry].push_back(&body);
    }
    std::string text = "bodies: " + grouped(scene.bodies.size()) + " of " +
                       grouped(scene.meshes.size()) +
                       (scene.meshes.size() == 1 ? " mesh\n" : " meshes\n");
    for (std::size_t entry = 0; entry < spec.bodies.size(); ++entry) {
        text += entry_line(spec.bodies[entry], scene, by_entry[entry]);
    }
    return text;
}

std::string lines_text(const SceneLines& lines) {
    return "lines: " + views_text(lines.spec) + ", " + counted(lines.bundles, "bundle") + " of " +
           counted(lines.mesh->triangles().size(), "line") + "\n";
}

std::string rule_line(const SceneRule& rule, const RuleEffect& effect) {
    const bool is_about_parts = RulePattern::from_text(rule.one).has_part() ||
                                RulePattern::from_text(rule.other).has_part();
    return "  line " + std::to_string(rule.line) + ": " + rule_text(rule) +
           (rule.ignores ? " ignores " : " tests ") + (is_about_parts ? "parts of " : "") +
           grouped(effect.decided) + " of the " + grouped(effect.named) +
           (effect.named == 1 ? " pair" : " pairs") + " of bodies that it names\n";
}

std::string rules_text(const RulesSpec& rules, const PreparedScene& prepared) {
    const std::uint64_t bodies = prepared.scene.bodies.size();
    std::string text = prepared.lines
                           ? "rules: lines pass by " + grouped(prepared.ignored_pairs) + " of " +
                                 bodies_counted(bodies)
                           : "rules: of " + counted(bodies * (bodies - 1) / 2, "pair") +
                                 " of bodies " + grouped(prepared.ignored_pairs) + " are ignored";
    text += prepared.ignored.empty()
                ? "\n"
                : ", and of others " + counted(prepared.ignored.size(), "range") +
                      " of pairs of triangles\n";
    for (std::size_t i = 0; i < rules.order.size(); ++i) {
        text += rule_line(rules.order[i], prepared.effects[i]);
    }
    return text;
}

std::string notes_text(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes) {
        text += "  " + note + "\n";
    }
    return text;
}

} // namespace

std::string keys_text(double moved, const std::string& unit) {
    return "keys of motions are rounded to a grid: rounding moved no body by more than " +
           fmt::format("{:.2g} {}", moved, unit);
}

std::string check_text(const JobSpec& spec, const PreparedScene& prepared) {
    const StepIndex& steps = *prepared.steps;
    const std::optional<double>& moved = prepared.facts.moved;
    return entries_text(*spec.scene, prepared.scene) +
           (prepared.lines ? lines_text(*prepared.lines) : "") +
           rules_text(spec.scene->rules, prepared) + counted(steps.steps(), "step") +
           (moved ? " of motion, " : ", ") + counted(steps.count(), "scenario") +
           (prepared.lines ? ", each of a body and a bundle" : "") + ":\n" +
           coverage_text(steps, prepared.facts.absences, prepared.scene, "  ") +
           (moved ? "  " + keys_text(*moved, spec.unit) + "\n" : "") +
           notes_text(prepared.facts.notes);
}

} // namespace cd
