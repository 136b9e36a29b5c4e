#include "client/commands/doctor/finding.hpp"

#include "common/core/printable.hpp"
#include "web/status/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cd {

namespace {

const char* grade_text(Finding::Grade grade) {
    return grade == Finding::Grade::Ok ? "ok" : grade == Finding::Grade::Warn ? "warn" : "FAIL";
}

} // namespace

std::string findings_text(std::span<const Finding> findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += fmt::format(
            "{:<5} {:<16} {}\n", grade_text(finding.grade), finding.topic, escaped(finding.text));
    }
    return text;
}

std::string findings_json(std::span<const Finding> findings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings) {
        nlohmann::ordered_json object;
        object["grade"] = grade_text(finding.grade);
        object["topic"] = finding.topic;
        object["text"] = finding.text;
        list.push_back(std::move(object));
    }
    return json_text(list);
}

} // namespace cd
