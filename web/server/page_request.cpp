#include "web/server/page_request.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/words.hpp"
#include "common/job/result/result.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Parameters = std::vector<std::pair<std::string_view, std::string>>;

struct NamedTopic {
    std::string_view name;
    PageTopic topic;
};
constexpr std::array<NamedTopic, 4> plain_topics{{{"source", PageTopic::Source},
                                                  {"cluster", PageTopic::Cluster},
                                                  {"history", PageTopic::History},
                                                  {"jobs", PageTopic::Jobs}}};
constexpr std::array<NamedTopic, 7> array_topics{{{"classes", PageTopic::Classes},
                                                  {"counts", PageTopic::Counts},
                                                  {"distances", PageTopic::Distances},
                                                  {"poses", PageTopic::Poses},
                                                  {"keys", PageTopic::Keys},
                                                  {"bodies", PageTopic::Bodies},
                                                  {"steps", PageTopic::Steps}}};
constexpr std::array<NamedTopic, 2> body_topics{
    {{"map", PageTopic::Map}, {"parts", PageTopic::Parts}}};
constexpr std::array<NamedTopic, 2> part_topics{
    {{"names", PageTopic::PartNames}, {"closed", PageTopic::ClosedParts}}};
constexpr std::array<NamedTopic, 3> contact_topics{
    {{"pairs", PageTopic::Pairs}, {"points", PageTopic::Points}, {"hits", PageTopic::Hits}}};

std::optional<PageTopic> topic_of(std::string_view name, std::span<const NamedTopic> topics) {
    const auto found = std::ranges::find(topics, name, &NamedTopic::name);
    return found == topics.end() ? std::nullopt : std::optional(found->topic);
}

Error no_route() {
    return {ErrorCode::NotFound, "there is no such route"};
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

Result<Parameters> parameters_of(std::string_view query) {
    Parameters parameters;
    if (query.empty()) {
        return parameters;
    }
    for (const std::string_view each : split(query, '&')) {
        const std::string_view name = each.substr(0, each.find('='));
        const auto value = percent_decoded(each.substr(std::min(name.size() + 1, each.size())));
        if (!value || value->size() > limits::page_name_bytes_max) {
            return bad_input("the value of a parameter is not valid");
        }
        parameters.emplace_back(name, *value);
    }
    return parameters;
}

Status allow_only(const Parameters& parameters, std::span<const std::string_view> names) {
    for (const auto& [name, value] : parameters) {
        if (std::ranges::find(names, name) == names.end()) {
            return bad_input("there is no parameter '" + std::string(name.substr(0, 64)) +
                             "' here");
        }
    }
    return Done{};
}

const std::string* find(const Parameters& parameters, std::string_view name) {
    const auto found = std::ranges::find(parameters, name, &Parameters::value_type::first);
    return found == parameters.end() ? nullptr : &found->second;
}

/// Returns a parameter's value; empty without it.
std::string text_of(const Parameters& parameters, std::string_view name) {
    const std::string* const text = find(parameters, name);
    return text == nullptr ? std::string() : *text;
}

Result<std::uint64_t> number_of(const Parameters& parameters, std::string_view name) {
    const std::string* const text = find(parameters, name);
    const auto number = text == nullptr ? std::nullopt : number_in<std::uint64_t>(*text);
    if (!number) {
        return bad_input("the parameter '" + std::string(name) + "' wants a whole number");
    }
    return *number;
}

Result<ScenarioChoice> choice_of(const Parameters& parameters) {
    ScenarioChoice choice;
    if (find(parameters, "sample") != nullptr) {
        CD_TRY(allow_only(parameters, std::array<std::string_view, 1>{"sample"}));
        choice.sample = CD_TRY(number_of(parameters, "sample"));
        if (choice.sample == 0) {
            return bad_input("a sample is not empty");
        }
        return choice;
    }
    CD_TRY(allow_only(parameters, std::array<std::string_view, 2>{"first", "count"}));
    choice.first = CD_TRY(number_of(parameters, "first"));
    choice.count = CD_TRY(number_of(parameters, "count"));
    return choice;
}

Result<NextContact::Kind> next_kind_of(const Parameters& parameters) {
    const std::string* const text = find(parameters, "class");
    if (text == nullptr || *text == "contact") {
        return NextContact::Kind::Contact;
    }
    if (*text != "near" && *text != "either") {
        return bad_input("the parameter 'class' is contact, near or either");
    }
    return *text == "near" ? NextContact::Kind::Near : NextContact::Kind::Either;
}

Result<NextContact> next_of(const Parameters& parameters) {
    CD_TRY(
        allow_only(parameters,
                   std::array<std::string_view, 8>{
                       "from", "step", "part_a", "part_b", "body_a", "body_b", "class", "body"}));
    NextContact next;
    next.from = CD_TRY(number_of(parameters, "from"));
    const std::string* const step = find(parameters, "step");
    if (step != nullptr && *step != "1" && *step != "-1") {
        return bad_input("the parameter 'step' is 1 or -1");
    }
    next.is_backwards = step != nullptr && *step == "-1";
    next.part_a = text_of(parameters, "part_a");
    next.part_b = text_of(parameters, "part_b");
    next.body_a = text_of(parameters, "body_a");
    next.body_b = text_of(parameters, "body_b");
    next.body = text_of(parameters, "body");
    next.kind = CD_TRY(next_kind_of(parameters));
    return next;
}

Status parse_scenario(std::span<const std::string_view> path,
                      const Parameters& parameters,
                      PageRequest& request) {
    if (path.size() == 1 && path[0] == "next") {
        request.topic = PageTopic::Next;
        request.next = CD_TRY(next_of(parameters));
        return Done{};
    }
    CD_TRY(allow_only(parameters, {}));
    const auto number = path.empty() ? std::nullopt : number_in<std::uint64_t>(path[0]);
    const auto topic = path.size() == 1   ? std::optional(PageTopic::Scenario)
                       : path.size() == 2 ? topic_of(path[1], contact_topics)
                                          : std::nullopt;
    if (!number || !topic) {
        return no_route();
    }
    request.topic = *topic;
    request.number = *number;
    return Done{};
}

/// Parses what follows /jobs/ID for what a job has of each body.
Status parse_body(std::span<const std::string_view> path,
                  const Parameters& parameters,
                  PageRequest& request) {
    const auto body = path.size() > 1 ? number_in<std::uint64_t>(path[1]) : std::nullopt;
    const bool is_of_parts = path.size() == 3 && path[0] == "parts";
    const auto topic = is_of_parts        ? topic_of(path[2], part_topics)
                       : path.size() == 2 ? topic_of(path[0], body_topics)
                                          : std::nullopt;
    if (!body || !topic) {
        return no_route();
    }
    request.topic = *topic;
    request.number = *body;
    return allow_only(parameters, {});
}

/// Parses what follows /jobs/ID.
Status parse_job(std::span<const std::string_view> path,
                 const Parameters& parameters,
                 PageRequest& request) {
    if (path.empty()) {
        request.topic = PageTopic::Job;
        return allow_only(parameters, {});
    }
    if (path[0] == "progress" && path.size() == 1) {
        request.topic = PageTopic::Progress;
        return allow_only(parameters, {});
    }
    if (path[0] == "scenarios") {
        return parse_scenario(path.subspan(1), parameters, request);
    }
    if (const auto topic = topic_of(path[0], array_topics); topic && path.size() == 1) {
        request.topic = *topic;
        request.choice = CD_TRY(choice_of(parameters));
        return Done{};
    }
    return parse_body(path, parameters, request);
}

} // namespace

bool NextContact::has_class(std::uint8_t value) const {
    const auto scenario = static_cast<ScenarioClass>(value);
    return (kind != Kind::Near && is_contact(scenario)) ||
           (kind != Kind::Contact && scenario == ScenarioClass::Near);
}

Status
ScenarioChoice::check(std::uint64_t total, std::uint64_t count_max, std::string_view noun) const {
    if (sample > limits::page_sample_max) {
        return bad_input("a sample has at most " + counted(limits::page_sample_max, noun));
    }
    if (sample == 0 && count > count_max) {
        return bad_input("at most " + counted(count_max, noun) + " at a time");
    }
    if (sample == 0 && (first > total || count > total - first)) {
        return bad_input("the job has " + counted(total, noun));
    }
    return Done{};
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i] == '+' ? ' ' : text[i];
            continue;
        }
        const auto byte = number_in<std::uint8_t>(text.substr(i + 1, 2), 16);
        if (!byte || text.size() < i + 3) {
            return std::nullopt;
        }
        decoded += static_cast<char>(*byte);
        i += 2;
    }
    return decoded;
}

Result<PageRequest> parse_page_request(std::string_view target) {
    if (!target.starts_with(page_api)) {
        return no_route();
    }
    target.remove_prefix(page_api.size());
    const std::string_view path_text = target.substr(0, target.find('?'));
    const auto parameters =
        CD_TRY(parameters_of(target.substr(std::min(path_text.size() + 1, target.size()))));
    const auto path = split(path_text, '/');
    PageRequest request;
    if (const auto topic = topic_of(path[0], plain_topics); topic && path.size() == 1) {
        CD_TRY(allow_only(parameters, {}));
        request.topic = *topic;
        return request;
    }
    if (path[0] == "jobs" && path.size() > 1 && !path[1].empty()) {
        request.job = path[1];
        CD_TRY(parse_job(std::span(path).subspan(2), parameters, request));
        return request;
    }
    const auto mesh = path.size() == 2 ? sha256_from_hex(path[1]) : std::nullopt;
    if (path[0] != "meshes" || !mesh) {
        return no_route();
    }
    CD_TRY(allow_only(parameters, {}));
    request.topic = PageTopic::Mesh;
    request.mesh = *mesh;
    return request;
}

} // namespace cd
