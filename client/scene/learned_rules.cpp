#include "client/scene/learned_rules.hpp"

#include "client/spec/rules_spec.hpp"

#include <string_view>
#include <utility>

namespace cd {

std::string pattern_of(const std::string& body) {
    constexpr std::string_view special = "/*?[\\";
    std::string pattern;
    for (const char c : body) {
        pattern += special.find(c) == std::string_view::npos ? "" : "\\";
        pattern += c;
    }
    return pattern;
}

LearnedRules::LearnedRules(std::shared_ptr<const StepIndex> steps,
                           std::uint64_t step,
                           std::vector<std::string> bodies)
    : steps_(std::move(steps)), step_(step), bodies_(std::move(bodies)) {}

void LearnedRules::add(const ScenarioResult& result) {
    if (!is_contact(result.kind) || steps_->step_of(result.index) != step_) {
        return;
    }
    const SceneRule rule{
        true, pattern_of(bodies_[result.body_a]), pattern_of(bodies_[result.body_b])};
    text_ += rule_text(rule) + ",\n";
}

} // namespace cd
