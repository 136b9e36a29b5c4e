#include "client/document/verdict.hpp"

#include "client/spec/query_spec.hpp"
#include "common/core/words.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace cd {

namespace {

std::uint64_t contacts_of(const Summary& summary) {
    return summary.touch + summary.cross + summary.inside + summary.contact;
}

std::string kinds_text(const Summary& summary) {
    const std::array<std::pair<const char*, std::uint64_t>, 4> kinds{
        {{"cross", summary.cross},
         {"inside", summary.inside},
         {"touch", summary.touch},
         {"contact", summary.contact}}};
    std::string text;
    for (const auto& [word, count] : kinds) {
        if (count != 0) {
            text += (text.empty() ? "" : ", ") + std::string(word) + " " + grouped(count);
        }
    }
    return text;
}

/// Says which scenarios are neither in contact nor free: "; 2 have no answer, 1 is undecided."
std::string rest_text(const Summary& summary) {
    const std::uint64_t missing = summary.total - summary.tested();
    std::string text;
    if (missing != 0) {
        text = "; " + grouped(missing) + (missing == 1 ? " has no answer" : " have no answer");
    }
    if (summary.undecided != 0) {
        text += (text.empty() ? "; " : ", ") + grouped(summary.undecided) +
                (summary.undecided == 1 ? " is undecided" : " are undecided");
    }
    return text + ".";
}

} // namespace

std::string verdict_text(const Summary& summary, const std::string& clearance) {
    const std::uint64_t contacts = contacts_of(summary);
    const std::string rest = rest_text(summary);
    const bool is_whole = summary.tested() == summary.total && summary.undecided == 0;
    if (contacts != 0) {
        return "The bodies are in contact in " + grouped(contacts) + " of " +
               counted(summary.total, "scenario") + " (" + kinds_text(summary) + ")" +
               (summary.near == 0 ? ""
                                  : ", and at most " + clearance + " apart in " +
                                        grouped(summary.near) + " more") +
               rest;
    }
    if (summary.near != 0) {
        return std::string(is_whole ? "No contact" : "No contact was found") +
               ", but the bodies are at most " + clearance + " apart in " + grouped(summary.near) +
               " of " + counted(summary.total, "scenario") + rest;
    }
    const std::string separate =
        clearance.empty() ? "separate" : "more than " + clearance + " apart";
    if (is_whole) {
        return "No contact: the bodies are " + separate + " in all of " +
               counted(summary.total, "scenario") + ".";
    }
    return "No contact was found: the bodies are " + separate + " in " + grouped(summary.separate) +
           " of " + counted(summary.total, "scenario") + rest;
}

std::string shots_verdict_text(const Summary& summary, const std::string& target) {
    const std::string rest = rest_text(summary);
    return summary.contact == 0
               ? "No line hits " + target + " in " + counted(summary.tested(), "bundle") + rest
               : "Lines hit " + target + " in " + grouped(summary.contact) + " of " +
                     counted(summary.total, "bundle") + ", with " + counted(summary.pairs, "hit") +
                     rest;
}

std::vector<std::string>
untested_texts(const Summary& summary, const Query& query, const std::string& no_groups) {
    std::vector<std::string> texts;
    const auto add = [&](std::uint64_t count, const std::string& what) {
        if (count != 0) {
            texts.push_back(counted(count, "scenario") + ": " + what);
        }
    };
    add(summary.total - summary.merged(), "without a result");
    add(summary.failed, "failed, without an answer");
    add(summary.undecided,
        query.motion ? "undecided, since parts of the time stay open at this resolution"
                     : "undecided, since an earlier version left small boxes untested");
    add(summary.surfaces_only,
        "a body is open, so it was not tested whether one body is inside the other");
    add(summary.insides_skipped,
        "parts are ignored and the rest is not closed, so insides were not tested");
    add(summary.cut,
        "the list of pairs ends at " + counted(query.limit_pairs, "pair") +
            "; groups and pictures are of listed pairs");
    if (!query.ignored.empty()) {
        texts.emplace_back("Pairs of parts that the job ignores were not tested (see the job "
                           "file below).");
    }
    if (query.level < Level::Pairs) {
        const std::string what = query.question == Question::Shots ? "hits" : "pairs of triangles";
        texts.push_back("The run lists no " + what + " (level " + std::string(asked_level(query)) +
                        ").");
    }
    if (!no_groups.empty()) {
        texts.push_back("The groups are unknown: " + no_groups + ".");
    }
    return texts;
}

} // namespace cd
