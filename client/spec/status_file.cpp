#include "client/spec/status_file.hpp"

#include "client/formats/output_file.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/core/errors.hpp"

#include <array>
#include <utility>

namespace cd {

namespace {

constexpr std::array<std::string_view, 2> status_words{"reviewed", "approved"};

PartPattern pattern_of(const TomlFields& fields, std::string_view key) {
    const auto text = fields.text(key);
    if (!text || text->empty()) {
        fields.refuse(key, std::string(key) + " is missing: the name of a part, or a pattern");
    }
    return PartPattern::from_text(*text);
}

StatusRule rule_of(const toml::node& node, const TomlFields& document, const std::string& file) {
    const toml::table* clash = node.as_table();
    if (clash == nullptr) {
        document.refuse(node, "clash has to be a table: [[clash]]");
    }
    const TomlFields fields(clash, document, "clash", {"a", "b", "status", "note", "pairs_max"});
    StatusRule rule;
    rule.a = pattern_of(fields, "a");
    rule.b = pattern_of(fields, "b");
    const auto status = fields.word("status", status_words);
    if (!status) {
        fields.refuse("status", "status is missing: \"reviewed\" or \"approved\"");
    }
    rule.is_approved = *status == "approved";
    rule.note = fields.text("note").value_or("");
    rule.pairs_max = fields.integer("pairs_max", 0, INT64_MAX);
    rule.place = file + ":" + std::to_string(clash->source().begin.line) + ": clash \"" +
                 *fields.text("a") + "\", \"" + *fields.text("b") + "\"";
    return rule;
}

} // namespace

Result<std::vector<StatusRule>> parse_statuses(std::string_view text, const std::string& file) {
    try {
        const toml::table document = toml::parse(text, std::string_view(file));
        const TomlFields fields(document, file, "the file", {"clash"});
        std::vector<StatusRule> rules;
        if (const toml::array* clashes = fields.array("clash")) {
            for (const toml::node& node : *clashes) {
                rules.push_back(rule_of(node, fields, file));
            }
        }
        return rules;
    } catch (const toml::parse_error& error) {
        return error_at(file, error.source(), std::string(error.description()));
    } catch (const Refusal& refusal) {
        return refusal.error;
    }
}

Result<std::vector<StatusRule>> read_status_file(const std::filesystem::path& path) {
    const std::string text = CD_TRY(read_file(path));
    return parse_statuses(text, path.string());
}

} // namespace cd
