#include "client/prepared_job.hpp"
#include "client/words.hpp"

#include <fnmatch.h>

namespace cd {

namespace {

using Ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The triangles of all parts that match; neighbours are joined.
Ranges matching(const std::string& pattern, const Mesh& mesh) {
    Ranges ranges;
    for (const Part& part : mesh.parts()) {
        if (fnmatch(pattern.c_str(), part.name.c_str(), 0) != 0) {
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

Error no_match(const IgnoreRule& rule,
               const std::string& pattern,
               char body,
               const Mesh& mesh,
               const std::filesystem::path& job_file) {
    constexpr std::size_t names_max = 20;
    std::vector<std::string_view> names;
    for (const Part& part : mesh.parts()) {
        if (names.size() < names_max) {
            names.push_back(part.name);
        }
    }
    const std::string place =
        rule.line == 0 ? "" : job_file.string() + ":" + std::to_string(rule.line) + ": ";
    return {ErrorCode::BadInput,
            place + "ignore: no part of " + body + " matches \"" + pattern + "\"" +
                (names.empty() ? "; it has no named parts" : suggestion(pattern, names))};
}

} // namespace

Result<std::vector<IgnoredRange>> resolve_ignored(const std::vector<IgnoreRule>& rules,
                                                  const Mesh& a,
                                                  const Mesh& b,
                                                  const std::filesystem::path& job_file) {
    std::vector<IgnoredRange> ignored;
    for (const IgnoreRule& rule : rules) {
        const Ranges of_a = matching(rule.a, a);
        const Ranges of_b = matching(rule.b, b);
        if (of_a.empty()) {
            return no_match(rule, rule.a, 'A', a, job_file);
        }
        if (of_b.empty()) {
            return no_match(rule, rule.b, 'B', b, job_file);
        }
        for (const auto& [a_begin, a_end] : of_a) {
            for (const auto& [b_begin, b_end] : of_b) {
                ignored.push_back({a_begin, a_end, b_begin, b_end});
            }
        }
    }
    return ignored;
}

} // namespace cd
