#include "client/report/report.hpp"

#include "client/base/shell_word.hpp"
#include "client/scene/coverage_text.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"
#include "web/status/table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <span>

namespace cd {

namespace {

/// Returns a length as 0.0123, 1.23, 12.34 or 1234; below 0.01 and from 1e7 on with an exponent.
std::string length_text(double value) {
    if (value != 0 && (std::abs(value) < 0.01 || std::abs(value) >= 1e7)) {
        return fmt::format("{:.3g}", value);
    }
    return fixed_text(value, std::abs(value) < 0.1 ? 4 : std::abs(value) < 100 ? 2 : 0);
}

std::string box_text(const BodyLine& body) {
    return length_text(body.size.x()) + " x " + length_text(body.size.y()) + " x " +
           length_text(body.size.z()) + " " + body.unit;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
    return fixed_text(whole == 0 ? 0.0
                                 : 100.0 * static_cast<double>(part) / static_cast<double>(whole),
                      1) +
           " %";
}

} // namespace

BodyLine describe_body(const std::string& name, const std::string& unit, const Mesh& mesh) {
    BodyLine line;
    line.name = name;
    line.unit = unit;
    line.triangles = mesh.triangles().size();
    line.size = bounding_box(mesh.vertices()).size();
    line.parts = std::max<std::size_t>(1, mesh.parts().size());
    return line;
}

std::string header_text(const BodyLine& a,
                        const BodyLine& b,
                        std::uint64_t scenarios,
                        const std::string& poses) {
    const std::size_t name = std::max({a.name.size(), b.name.size(), std::size_t{14}});
    const std::size_t count =
        std::max({grouped(a.triangles).size(), grouped(b.triangles).size(), std::size_t{7}});
    const std::size_t box = std::max(box_text(a).size(), box_text(b).size());
    std::string text;
    const auto add = [&](char letter, const BodyLine& body) {
        const std::string closed = !body.closed ? "" : *body.closed ? "closed   " : "open     ";
        text += fmt::format("  {}  {:<{}}  {:>{}} triangles   {:<{}}   {}{}\n",
                            letter,
                            body.name,
                            name,
                            grouped(body.triangles),
                            count,
                            box_text(body),
                            box,
                            closed,
                            counted(body.parts, "part"));
        for (const std::string& note : body.notes) {
            text += "     " + note + "\n";
        }
    };
    add('A', a);
    add('B', b);
    return text + fmt::format("  {:<{}}  {:>{}}{}{}\n",
                              "poses",
                              name + 3,
                              grouped(scenarios),
                              count,
                              poses.empty() ? "" : "  ",
                              poses);
}

std::optional<std::string> unit_warning(const BodyLine& a, const BodyLine& b) {
    const double size_a = a.size.stableNorm();
    const double size_b = b.size.stableNorm();
    if (!(size_a > 0) || !(size_b > 0)) {
        return std::nullopt;
    }
    const double ratio = std::max(size_a, size_b) / std::min(size_a, size_b);
    for (const double suspect : {25.4, 1000.0}) {
        if (std::abs(ratio / suspect - 1) <= 0.02) {
            return "warning: " + (size_a > size_b ? a.name : b.name) + " is " +
                   fixed_text(ratio, 1) + " times as large as " +
                   (size_a > size_b ? b.name : a.name) + "; if one is in another unit (" +
                   (suspect < 100 ? "in or mm" : "mm or m") + "), give its unit";
        }
    }
    return std::nullopt;
}

namespace {

constexpr const char* green = "\x1b[32m";
constexpr const char* yellow = "\x1b[33m";
constexpr const char* red = "\x1b[31m";

std::string coloured(const std::string& text, const char* colour, bool colours) {
    return colours ? colour + text + "\x1b[0m" : text;
}

/// Says that a sum covers only the pairs that are listed; empty if all pairs are listed.
std::string first_pairs_text(const RunReport& report) {
    return report.query.limit_pairs == 0
               ? ""
               : ", of the first " + counted(report.query.limit_pairs, "pair") + " a scenario";
}

std::string map_text(const RunReport& report) {
    if (!report.map) {
        return {};
    }
    const auto& [a, b] = report.map->bodies;
    return "  map           " + counted(a.size(), "triangle") + " of A and " + grouped(b.size()) +
           " of B were in contact" + (report.query.clearance ? " or near" : "") +
           (report.query.maps ? "" : first_pairs_text(report)) + "; digest " +
           to_short_hex(digest_of(*report.map)) + "\n";
}

/// Names the parts most in contact, with shares, or with counts if not all pairs are listed.
std::string most_touched_text(const RunReport& report) {
    std::string text;
    for (const TouchedPart& part : report.findings.most_touched) {
        text += (text.empty() ? "  most touched  " : ", ") + part.part + " " +
                (report.query.limit_pairs == 0 ? percent(part.scenarios, report.summary.tested())
                                               : grouped(part.scenarios));
    }
    return text.empty() ? text : text + first_pairs_text(report) + "\n";
}

std::string least_text(const RunReport& report) {
    return !report.findings.least
               ? ""
               : "  least apart   " + length_text(report.findings.least->distance) + " " +
                     report.findings.least->unit + " in scenario " +
                     grouped(report.findings.least->scenario) + "\n";
}

/// Says what became of the pairs of bodies, and when bodies are in contact; empty for two bodies.
std::string scene_text(const RunReport& report) {
    const std::optional<SceneFindings>& scene = report.findings.scene;
    if (!scene) {
        return {};
    }
    std::string text = "  coverage      " + counted(scene->steps, "step") + ": " +
                       coverage_line(scene->coverage) + ", " + grouped(report.summary.failed) +
                       " failed\n  episodes      " + grouped(scene->episodes);
    if (scene->worst) {
        const EpisodeFound& worst = *scene->worst;
        text += "; the worst, " + std::string(to_text(worst.worst)) + ", of " + worst.body_a +
                " and " + worst.body_b + " in steps " + grouped(worst.first_step) + " to " +
                grouped(worst.last_step);
    }
    text += "\n";
    if (scene->learned_step) {
        text += "  learned       " +
                std::string(scene->learned.empty() ? "no pair" : "these pairs") +
                " in contact at step " + grouped(*scene->learned_step) +
                (scene->learned.empty() ? "\n" : ", as [rules] order has them:\n") + scene->learned;
    }
    return text;
}

/// Has a line for each of the parts that most lines cross.
std::string shots_text(const RunReport& report) {
    constexpr std::size_t parts_max = 10;
    const std::vector<ShotPart>& parts = report.findings.shots;
    std::string text;
    for (const ShotPart& part : std::span(parts).first(std::min(parts.size(), parts_max))) {
        text += "  part          " + part.name + ": crossed " + counted(part.crossings, "time") +
                " by " + counted(part.lines, "line");
        if (part.area) {
            text += ", seen area " + length_text(*part.area) + " " + part.unit + "^2";
        }
        if (part.thickness) {
            text += ", thickness " + length_text((*part.thickness)[0]) + " " + part.unit +
                    " in the mean, at most " + length_text((*part.thickness)[1]) + " " + part.unit;
        }
        text += part.is_closed ? "\n" : ", not closed: no thickness\n";
    }
    return parts.size() <= parts_max
               ? text
               : text + "  part          and " + counted(parts.size() - parts_max, "part") +
                     " more in summary.json\n";
}

/// Lists the classes. Near scenarios are listed if the query has a clearance.
std::string classes_text(const RunReport& report, bool colours) {
    const Summary& summary = report.summary;
    std::string text = "  " + coloured("separate  " + grouped(summary.separate), green, colours);
    const auto add = [&](const std::string& name, std::uint64_t count, const char* colour) {
        const std::string part = name + " " + grouped(count);
        text += "    " + coloured(part, colour, colours && count != 0);
    };
    if (report.query.question == Question::Shots) {
        add("contact", summary.contact, green);
        text += " (" + counted(summary.pairs, "hit") + ")";
    } else if (report.query.level == Level::Any) {
        add("contact", summary.contact, red);
        add("inside", summary.inside, red);
    } else {
        add("touch", summary.touch, yellow);
        add("cross", summary.cross, red);
        text += summary.pairs == 0 ? "" : " (" + counted(summary.pairs, "pair") + ")";
        add("inside", summary.inside, red);
    }
    if (report.query.clearance || summary.near + summary.near_pairs != 0) {
        add("near", summary.near, yellow);
        text += summary.near_pairs == 0 ? "" : " (" + counted(summary.near_pairs, "pair") + ")";
    }
    if (summary.undecided != 0) {
        add("undecided", summary.undecided, yellow);
    }
    add("failed", summary.failed, red);
    return text + "    tested " + grouped(summary.tested()) + " of " + grouped(summary.total) +
           "\n";
}

/// Returns a share as "99.97 %", never a nonzero one as 0, nor an incomplete one as 100 %.
std::string share_text(std::uint64_t part, std::uint64_t whole) {
    const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    if (part != 0 && share < 0.005) {
        return "< 0.01 %";
    }
    return part != whole && share >= 99.995 ? "> 99.99 %" : fixed_text(share, 2) + " %";
}

std::string settled_text(const PairStatistics& decisions) {
    std::string text;
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        const auto stage = static_cast<PairStage>(i);
        if (decisions[stage] != 0) {
            text += (text.empty() ? "; settled in " : ", ") + std::string(to_text(stage)) + " " +
                    share_text(decisions[stage], decisions.total());
        }
    }
    return text;
}

/// Describes the cost of the mean scenario by the paper's cost function.
std::string
cost_text(const SearchCost& cost, const QueryStatistics& search, std::uint64_t scenarios) {
    return "  cost          N_b C_b + N_p C_p = " + grouped(search.box_tests / scenarios) + " x " +
           fixed_text(cost.box_test_ns, 2) + " ns + " + grouped(search.triangle_tests / scenarios) +
           " x " + fixed_text(cost.triangle_test_ns, 2) + " ns = " +
           fixed_text(1e6 * cost.seconds_of(search) / static_cast<double>(scenarios), 1) +
           " us a scenario\n";
}

std::string statistics_text(const RunReport& report) {
    std::string text;
    const JobStatistics& statistics = report.execution.statistics;
    const QueryStatistics& search = statistics.search;
    const std::uint64_t scenarios = std::max<std::uint64_t>(1, report.summary.merged());
    if (search.box_tests != 0) {
        text += "  visited       " + counted(search.box_tests / scenarios, "box pair") + ", " +
                counted(search.triangle_tests / scenarios, "candidate") + " a scenario" +
                settled_text(search.decisions) + "\n";
    }
    if (report.execution.cost) {
        text += cost_text(*report.execution.cost, search, scenarios);
    }
    if (statistics.inside.scenarios != 0) {
        text += "  inside        looked at in " + counted(statistics.inside.scenarios, "scenario") +
                ", " + fixed_text(statistics.inside.seconds, 3) + " s of one thread\n";
    }
    return text;
}

/// Describes the network traffic of the job.
std::string traffic_text(const JobTraffic& traffic) {
    const BlockTraffic& blocks = traffic.blocks;
    const std::uint64_t needed = blocks.hits + blocks.misses;
    std::string text = "  geometry      " + cell_text(blocks.master_bytes, CellKind::Size) +
                       " from the master, " + cell_text(blocks.peer_bytes, CellKind::Size) +
                       " from other workers\n";
    text += "  caches        held what was needed " + grouped(blocks.hits) +
            " times, asked for it " + grouped(blocks.misses) + " times" +
            (needed == 0 ? "" : " (" + share_text(blocks.hits, needed) + ")") +
            (blocks.hinted == 0 ? "" : ", " + grouped(blocks.hinted) + " asked for ahead") + ", " +
            grouped(blocks.evictions) + " evicted\n";
    return text + "  sent back     " + cell_text(traffic.result_bytes, CellKind::Size) +
           " of results\n";
}

std::string seconds_text(double seconds) {
    return fixed_text(seconds, seconds < 10 ? 2 : 1);
}

/// Reports the time before the run, which `seconds` does not include; empty if it is short.
std::string prepared_text(const RunReport& report) {
    return report.execution.prepare_seconds < 0.05
               ? ""
               : " (" + fixed_text(report.execution.prepare_seconds, 1) + " s to read and build)";
}

std::string depths_text(const RunReport& report) {
    if (report.execution.depths.size() != 2) {
        return "";
    }
    return "  depths        A cut at " + std::to_string(report.execution.depths[0]) + ", B at " +
           std::to_string(report.execution.depths[1]) + "\n";
}

} // namespace

std::string warnings_text(const RunReport& report) {
    std::string text;
    if (!report.map_withdrawn.empty()) {
        text += "  map           withdrawn: " + report.map_withdrawn + "; run the job again\n";
    }
    if (report.folder.inputs_are_too_large) {
        text +=
            "  inputs        not kept, since they are too large: opening the folder again needs "
            "their files\n";
    }
    return text;
}

std::string summary_text(const RunReport& report, const SummaryStyle& style) {
    const Summary& summary = report.summary;
    const std::uint64_t run =
        report.execution.ran.value_or(summary.merged() - report.execution.resumed_at);
    const double rate =
        report.execution.seconds > 0 ? static_cast<double>(run) / report.execution.seconds : 0.0;
    const double whole_rate = std::round(rate);
    std::string text =
        (summary.is_complete() ? "done in " : "ended after ") +
        seconds_text(report.execution.seconds) + " s" + prepared_text(report) + "      " +
        (rate < 100 ? fixed_text(rate, 1) : grouped(static_cast<std::uint64_t>(whole_rate))) +
        " scenarios/s" + (report.execution.where.empty() ? "" : ", " + report.execution.where) +
        "\n";
    text += classes_text(report, style.colours);
    text += least_text(report);
    text += first_event_line(report.findings.first_event);
    text += scene_text(report);
    text += shots_text(report);
    if (report.execution.reused != 0) {
        text += "  reused        " + grouped(report.execution.reused) + " of " +
                counted(summary.total, "result") + " of an earlier run\n";
    }
    const auto note = [&](std::uint64_t count, const char* title, const char* meaning) {
        if (count != 0) {
            text += fmt::format("  {}  in {}: {}\n", title, counted(count, "scenario"), meaning);
        }
    };
    note(summary.surfaces_only, "surfaces only", "a body is open, so containment was not tested");
    note(summary.insides_skipped,
         "containment not tested",
         "parts are ignored, and the rest of a body is not closed");
    note(summary.cut, "cut lists", "limit_pairs was reached; the counts are true");
    note(summary.undecided,
         "undecided   ",
         report.query.motion
             ? "parts of the time stay open; a smaller resolution decides more, or more keys where "
               "a "
               "motion ends at its limit of parts"
             : "an earlier version left small boxes; pairs are those proven, not all");
    if (!report.hint.empty()) {
        text += "  hint          " + report.hint + "\n";
    }
    text += map_text(report);
    text += most_touched_text(report);
    if (style.statistics) {
        text += statistics_text(report);
        text += depths_text(report);
        text += report.execution.traffic ? traffic_text(*report.execution.traffic) : "";
    }
    if (report.digest) {
        text += "  digest        " + to_short_hex(*report.digest) + "\n";
    }
    text += warnings_text(report);
    if (!report.folder.summary_file.empty()) {
        const auto folder = std::filesystem::path(report.folder.summary_file).parent_path();
        text += "  open it: cdctl view " + shell_word(folder.string()) + "\n";
    }
    return text;
}

bool colours_wanted(std::FILE* stream) {
    const char* refused = std::getenv("NO_COLOR");
    return (refused == nullptr || *refused == '\0') && isatty(fileno(stream)) != 0;
}

} // namespace cd
