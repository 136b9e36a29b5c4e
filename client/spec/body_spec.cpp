#include "client/spec/body_spec.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/units.hpp"
#include "client/spec/toml_fields.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace cd {

namespace {

constexpr std::array<std::string_view, 2> up_axes{"y", "z"};
/// "auto": floats if they hold every coordinate, else doubles.
constexpr std::array<std::string_view, 2> precision_names{"auto", "float"};

} // namespace

std::filesystem::path beside(const std::filesystem::path& job, const std::string& path) {
    return path == "-" ? std::filesystem::path(path) : job.parent_path() / path;
}

BodySpec read_mesh(const TomlFields& fields, const std::filesystem::path& job) {
    const auto mesh = fields.text("mesh");
    if (!mesh || mesh->empty()) {
        fields.refuse("mesh", "the key \"mesh\" with the file's name is missing");
    }
    BodySpec body;
    body.path = beside(job, *mesh);
    body.unit = fields.word("unit", unit_names()).value_or("");
    body.up = fields.word("up", up_axes).value_or("");
    body.rounds_to_float = fields.word("precision", precision_names) == "float";
    if (const auto origin = fields.numbers("origin", 3, "[x, y, z]")) {
        std::ranges::copy(*origin, body.origin.begin());
    }
    return body;
}

Result<ImportOptions> import_options(const BodySpec& body, const std::string& job_unit) {
    const std::string& unit = body.unit.empty() ? job_unit : body.unit;
    const auto factor = unit_factor(unit, job_unit);
    if (!factor) {
        return bad_input("unit \"" + unit + "\" is not known");
    }
    ImportOptions options{*factor};
    options.declared_unit_to = body.unit.empty() ? job_unit : "";
    options.is_y_up = body.up == "y";
    options.origin = body.origin;
    options.rounds_to_float = body.rounds_to_float;
    options.is_stopped = &InterruptGuard::has_come;
    return options;
}

Error error_in_job(const std::filesystem::path& job,
                   std::uint32_t line,
                   const std::string& detail) {
    return bad_input(job.string() + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + detail);
}

} // namespace cd
