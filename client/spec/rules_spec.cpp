#include "client/spec/rules_spec.hpp"

#include "client/spec/toml_fields.hpp"
#include "client/spec/toml_text.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <string_view>
#include <utility>

namespace cd {

namespace {

/// Reads the two patterns of a rule's key.
std::pair<std::string, std::string> read_patterns(const TomlFields& fields, std::string_view key) {
    const toml::array* patterns = fields.array(key);
    const bool are_two = patterns != nullptr && patterns->size() == 2 &&
                         patterns->get(0)->is_string() && patterns->get(1)->is_string();
    if (!are_two) {
        fields.refuse(key,
                      std::string(key) + " has to be two names or patterns, such as [\"car.*\", "
                                         "\"ground\"]");
    }
    std::pair<std::string, std::string> read(patterns->get(0)->value_or(std::string()),
                                             patterns->get(1)->value_or(std::string()));
    if (read.first.empty() || read.second.empty()) {
        fields.refuse(key, std::string(key) + " has an empty name; \"*\" stands for all bodies");
    }
    return read;
}

SceneRule read_rule(const TomlFields& rules, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr || table->size() != 1) {
        rules.refuse(node,
                     "order is an array of rules, such as { ignore = [\"car.*\", \"ground\"] } or "
                     "{ test = [\"car.1\", \"ground\"] }");
    }
    const TomlFields fields(table, rules, "[rules] order", {"ignore", "test"});
    SceneRule rule;
    rule.ignores = fields.has("ignore");
    auto [one, other] = read_patterns(fields, rule.ignores ? "ignore" : "test");
    rule.one = std::move(one);
    rule.other = std::move(other);
    rule.line = node.source().begin.line;
    return rule;
}

} // namespace

RulesSpec read_rules(const TomlFields& job) {
    const toml::table* table = job.table("rules");
    if (table == nullptr) {
        return {};
    }
    const TomlFields fields(table, job, "[rules]", {"order", "learn"});
    RulesSpec rules;
    rules.learn = fields.integer("learn", 0, limits::scenarios_max);
    const toml::array* order = fields.array("order");
    if (order == nullptr) {
        return rules;
    }
    if (order->size() > limits::scene_rules_max) {
        fields.refuse("order",
                      "order has more than " + grouped(limits::scene_rules_max) +
                          " rules; patterns such as \"car.*\" and groups make them fewer");
    }
    for (const toml::node& node : *order) {
        rules.order.push_back(read_rule(fields, node));
    }
    return rules;
}

std::string rule_text(const SceneRule& rule) {
    return "{ " + std::string(rule.ignores ? "ignore" : "test") + " = [" + toml_quoted(rule.one) +
           ", " + toml_quoted(rule.other) + "] }";
}

} // namespace cd
