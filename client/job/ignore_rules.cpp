#include "client/groups/part_pattern.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <array>
#include <utility>

namespace cd {

namespace {

using Ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A body: its letter in messages, and its name in patterns.
struct IgnoredBody {
    char letter = 'A';
    const std::string& name;
    const Mesh& mesh;
};

/// Returns the triangles of all parts whose names match, with adjacent ranges joined.
Ranges matching(const PartPattern& pattern, const Mesh& mesh) {
    Ranges ranges;
    for (const Part& part : mesh.parts()) {
        if (!pattern.is_of_part(part.name)) {
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

std::string place_of(const IgnoreRule& rule, const std::filesystem::path& job_file) {
    return rule.line == 0 ? "" : job_file.string() + ":" + std::to_string(rule.line) + ": ";
}

Error no_body(const IgnoreRule& rule,
              const std::string& pattern,
              const IgnoredBody& body,
              const std::filesystem::path& job_file) {
    return bad_input(place_of(rule, job_file) + "ignore: \"" + pattern +
                     "\" is of another body than " + body.letter + ", which is called \"" +
                     body.name + "\"; a / within the name of a part is written \\/");
}

Error no_match(const IgnoreRule& rule,
               const std::string& pattern,
               const IgnoredBody& body,
               const std::filesystem::path& job_file) {
    constexpr std::size_t names_max = 20;
    std::vector<std::string_view> names;
    for (const Part& part : body.mesh.parts()) {
        if (names.size() < names_max) {
            names.push_back(part.name);
        }
    }
    return bad_input(place_of(rule, job_file) + "ignore: no part of " + body.letter +
                     " matches \"" + pattern + "\"" +
                     (names.empty() ? "; it has no named parts" : suggestion(pattern, names)));
}

/// Returns the triangles of a body that the pattern `text` matches. Errors: BadInput for a pattern
/// that names another body or matches no part.
Result<Ranges> ranges_of(const IgnoreRule& rule,
                         const std::string& text,
                         const IgnoredBody& body,
                         const std::filesystem::path& job_file) {
    const PartPattern pattern = PartPattern::from_text(text);
    if (!pattern.is_of_body(body.name)) {
        return no_body(rule, text, body, job_file);
    }
    Ranges ranges = matching(pattern, body.mesh);
    return ranges.empty() ? Result<Ranges>(no_match(rule, pattern.part, body, job_file))
                          : Result<Ranges>(std::move(ranges));
}

} // namespace

Result<std::vector<IgnoredRange>>
resolve_ignored(const JobSpec& spec, const Mesh& a, const Mesh& b) {
    const std::array<std::string, 2> names{export_name(spec, 0), export_name(spec, 1)};
    std::vector<IgnoredRange> ignored;
    for (const IgnoreRule& rule : spec.ignore) {
        const auto of_a = ranges_of(rule, rule.a, {'A', names[0], a}, spec.file);
        const auto of_b = ranges_of(rule, rule.b, {'B', names[1], b}, spec.file);
        if (!of_a || !of_b) {
            return of_a ? of_b.error() : of_a.error();
        }
        for (const auto& [a_begin, a_end] : of_a.value()) {
            for (const auto& [b_begin, b_end] : of_b.value()) {
                ignored.push_back({a_begin, a_end, b_begin, b_end});
            }
        }
    }
    return ignored;
}

} // namespace cd
