#include "client/spec/fcd_spec.hpp"

#include "client/base/units.hpp"
#include "client/spec/body_spec.hpp"
#include "client/spec/toml_fields.hpp"

#include <array>
#include <string_view>

namespace cd {

namespace {

constexpr std::array<std::string_view, 1> other_type_words{"skip"};

std::map<std::string, std::string> read_types(const TomlFields& fcd) {
    const toml::table* table = fcd.table("types");
    std::map<std::string, std::string> types;
    if (table == nullptr || table->empty()) {
        fcd.refuse("types",
                   "types has to name a body of [bodies] for each vehicle type, such as types = { "
                   "passenger = \"car\" }");
    }
    for (const auto& [type, node] : *table) {
        const auto body = node.value_exact<std::string>();
        if (!body) {
            fcd.refuse(node, "types has the name of a body of [bodies] for each vehicle type");
        }
        types.emplace(type.str(), *body);
    }
    return types;
}

} // namespace

FcdSpec read_fcd_spec(const TomlFields& poses,
                      const std::string& job_unit,
                      const std::filesystem::path& job_file) {
    const TomlFields fields(
        poses.table("fcd"), poses, "[poses] fcd", {"file", "types", "z", "other_types"});
    const auto name = fields.text("file");
    if (!name || name->empty() || *name == "-") {
        fields.refuse("file", "the key \"file\" with the name of a file of SUMO's FCD is missing");
    }
    FcdSpec fcd;
    fcd.path = beside(job_file, *name);
    fcd.types = read_types(fields);
    fcd.z = fields.number("z").value_or(0);
    fcd.length_factor = unit_factor("m", job_unit).value_or(1);
    fcd.skips_other_types = fields.word("other_types", other_type_words).has_value();
    return fcd;
}

} // namespace cd
