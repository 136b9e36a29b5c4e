#include "client/scene/rule_pattern.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <set>

namespace cd {

namespace {

constexpr std::string_view group_mark = "group:";

bool matches(const std::string& pattern, const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

/// Returns the names closest to a mistyped one, for the end of an error.
std::string suggested(const std::string& pattern, const std::set<std::string>& names) {
    std::vector<std::string_view> words;
    for (const std::string& name : names) {
        words.push_back(name);
    }
    return suggestion(pattern, words);
}

} // namespace

RulePattern RulePattern::from_text(std::string_view text) {
    RulePattern pattern;
    pattern.text_ = text;
    pattern.is_group_ = text.starts_with(group_mark);
    const PartPattern split =
        PartPattern::from_text(text.substr(pattern.is_group_ ? group_mark.size() : 0));
    pattern.body_ = split.body.value_or(split.part);
    pattern.part_ = split.body ? std::optional(split.part) : std::nullopt;
    return pattern;
}

bool RulePattern::names(const NamedBody& body) const {
    return is_group_ ? !body.group.empty() && matches(body_, body.group)
                     : matches(body_, body.name);
}

Result<std::vector<std::uint32_t>> RulePattern::bodies_of(const SceneBodies& scene) const {
    std::vector<std::uint32_t> named;
    for (std::uint32_t body = 0; body < scene.bodies.size(); ++body) {
        if (names(scene.bodies[body])) {
            named.push_back(body);
        }
    }
    if (named.empty()) {
        return no_body(scene);
    }
    if (!part_) {
        return named;
    }
    std::vector<bool> has_part(scene.meshes.size());
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        has_part[mesh] = !ranges_of(*scene.meshes[mesh]).empty();
    }
    std::vector<std::uint32_t> with_part;
    std::ranges::copy_if(named, std::back_inserter(with_part), [&](std::uint32_t body) {
        return has_part[scene.bodies[body].mesh];
    });
    return with_part.empty() ? Result<std::vector<std::uint32_t>>(no_part(scene, named))
                             : Result(std::move(with_part));
}

std::vector<TriangleRange> RulePattern::ranges_of(const Mesh& mesh) const {
    if (!part_) {
        return {{0, static_cast<std::uint32_t>(mesh.triangles().size())}};
    }
    std::vector<TriangleRange> ranges;
    for (const Part& part : mesh.parts()) {
        if (part.triangles_begin == part.triangles_end || !matches(*part_, part.name)) {
            continue;
        }
        if (!ranges.empty() && ranges.back().second == part.triangles_begin) {
            ranges.back().second = part.triangles_end;
        } else {
            ranges.emplace_back(part.triangles_begin, part.triangles_end);
        }
    }
    return ranges;
}

Error RulePattern::no_body(const SceneBodies& scene) const {
    std::set<std::string> names;
    for (const NamedBody& body : scene.bodies) {
        names.insert(is_group_ ? body.group : body.name);
    }
    names.erase("");
    if (names.empty()) {
        return bad_input("\"" + text_ + "\" names a group, but no body of [bodies] has one");
    }
    return bad_input("\"" + text_ + "\" names no " + (is_group_ ? "group" : "body") +
                     suggested(body_, names));
}

Error RulePattern::no_part(const SceneBodies& scene,
                           const std::vector<std::uint32_t>& bodies) const {
    std::set<std::string> names;
    for (const std::uint32_t body : bodies) {
        for (const Part& part : scene.mesh_of(scene.bodies[body]).parts()) {
            names.insert(part.name);
        }
    }
    if (names.empty()) {
        return bad_input("\"" + text_ +
                         "\" names a part, but the meshes of these bodies have none");
    }
    return bad_input("\"" + text_ + "\" names no part of these bodies" + suggested(*part_, names));
}

} // namespace cd
