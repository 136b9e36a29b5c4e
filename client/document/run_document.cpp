#include "client/document/run_document.hpp"

#include "client/document/class_chart.hpp"
#include "client/document/group_sections.hpp"
#include "client/document/report_style.hpp"
#include "client/document/verdict.hpp"
#include "client/report/report.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/words.hpp"
#include "common/geometry/topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <variant>

namespace cd {

namespace {

constexpr std::uint64_t coincidences_at_once = 1u << 16;

/// True if a result lacks the pairs that its picture would mark.
bool is_unmarked(const ScenarioResult& result) {
    return result.pairs.empty() && result.kind != ScenarioClass::Inside;
}

bool coincide(const PosePair& poses) {
    return poses.a.translation() == poses.b.translation() &&
           poses.a.rotation() == poses.b.rotation();
}

/// Says how many more bodies have the mesh of a shown one.
std::string others_text(const ShownBody& body) {
    return body.others == 0   ? ""
           : body.others == 1 ? " and 1 more body"
                              : " and " + grouped(body.others) + " more bodies";
}

} // namespace

Html RunDocument::digest() const {
    const auto& whole = manifest_.outcome.digest;
    if (!overview_.bodies().empty()) {
        return whole ? paragraph("Digest of the whole run " + to_hex(*whole)) : Html();
    }
    return paragraph(overview_.digest() ? "Digest " + to_hex(*overview_.digest())
                                        : "No digest, since results are missing.");
}

Html RunDocument::verdict() const {
    const Summary& summary = overview_.summary();
    const bool is_clean = summary.separate == summary.total;
    Html content = Html::element("h1", short_name(manifest_.name));
    if (!overview_.bodies().empty()) {
        content += paragraph(
            "Only scenarios of " + overview_.bodies() + ": " + grouped(summary.total) + " of " +
            grouped(manifest_.poses.count) + ". All else in this report is of these, too" +
            (scene_ == nullptr ? "" : ", but for how many pairs were tested") + ".");
    }
    const std::optional<double>& clearance = manifest_.query.clearance;
    const std::string distance = clearance ? exact_text(*clearance) + " " + manifest_.unit : "";
    content +=
        has_lines()
            ? paragraph(shots_verdict_text(summary, job_.scene ? "a body" : "A"), "verdict good")
            : paragraph(verdict_text(summary, distance), is_clean ? "verdict good" : "verdict bad");
    content +=
        has_distance() ? paragraph(DistanceSections(names_, manifest_, overview_).least()) : Html();
    content += motions_ != nullptr ? paragraph(motions_->verdict(names_)) : Html();
    std::vector<std::string> head{"separate", "touch", "cross", "inside"};
    std::vector<std::string> counts{grouped(summary.separate),
                                    grouped(summary.touch),
                                    grouped(summary.cross),
                                    grouped(summary.inside)};
    if (has_lines()) {
        head = {"separate", "contact"};
        counts = {grouped(summary.separate), grouped(summary.contact)};
    } else if (manifest_.query.level == Level::Any) {
        head = {"separate", "contact", "inside"};
        counts = {grouped(summary.separate), grouped(summary.contact), grouped(summary.inside)};
    }
    if (clearance) {
        head.emplace_back("near");
        counts.push_back(grouped(summary.near));
    }
    head.insert(head.end(),
                {"undecided", "failed", "tested", has_lines() ? "hits" : "pairs of triangles"});
    counts.insert(counts.end(),
                  {grouped(summary.undecided),
                   grouped(summary.failed),
                   grouped(summary.tested()) + " of " + grouped(summary.total),
                   manifest_.query.level == Level::Any ? "not counted" : grouped(summary.pairs)});
    if (clearance && manifest_.query.level != Level::Any) {
        head.emplace_back("near pairs");
        counts.push_back(grouped(summary.near_pairs));
    }
    content += html_table({html_texts(head), html_texts(counts)}, "counts");
    content += digest();
    const auto untested = untested_texts(summary, manifest_.query, no_groups_);
    content += paragraph(untested.empty() ? "Everything that was asked was tested."
                                          : "What was not tested, or not listed:");
    content += untested.empty() ? Html() : html_list(untested);
    for (const FailedScenario& failure : overview_.failures()) {
        content += paragraph(
            names_.label_of(failure.index) + " failed: " + short_name(failure.reason), "warning");
    }
    return content;
}

Html RunDocument::distances() const {
    const DistanceSections sections(names_, manifest_, overview_);
    const std::span<const std::string> pictures(pictures_.scenarios());
    Html content =
        sections.nearest(pictures.subspan(std::min(overview_.worst().size(), pictures.size())));
    content += sections.histogram();
    return content;
}

Html RunDocument::bodies() const {
    Html cards;
    const std::vector<ShownBody> shown = shown_bodies(job_);
    const std::size_t count = std::min(shown.size(), ReportPictures::bodies_max);
    for (std::size_t i = 0; i < count; ++i) {
        const Mesh& mesh = *job_.meshes[shown[i].body];
        const ManifestBody& body = manifest_.bodies[shown[i].body];
        const BodyLine line = describe_body(body.name, manifest_.unit, mesh);
        const std::string file = std::filesystem::path(body.file).filename().string();
        std::string words = grouped(line.triangles) + " triangles, " + counted(line.parts, "part") +
                            ", " + (analyse_topology(mesh).is_closed() ? "closed" : "open") +
                            fmt::format(", {:.4g} x {:.4g} x {:.4g} {}",
                                        line.size.x(),
                                        line.size.y(),
                                        line.size.z(),
                                        manifest_.unit);
        Html caption = Html::element("b",
                                     (job_.scene ? ""
                                      : i == 0   ? "A  "
                                                 : "B  ") +
                                         short_name(body.name) + others_text(shown[i]) + ", " +
                                         short_name(file));
        caption += Html::element("br", Html());
        caption += Html::text(words + ", SHA-256 " + to_short_hex(body.mesh));
        cards += html_figure(i < pictures_.bodies().size() ? pictures_.bodies()[i] : "",
                             caption,
                             "body " + short_name(body.name));
    }
    Html content = Html::element("div", cards, {{"class", "cards"}});
    if (count < shown.size()) {
        content += paragraph("Bodies of " + grouped(shown.size() - count) + " more meshes.");
    }
    return html_section("Bodies", content);
}

std::string RunDocument::part_pairs_of(const ScenarioResult& result) {
    constexpr std::size_t shown_max = 3;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> pairs;
    const BodyParts& a = overview_.groups().parts(result.body_a);
    const BodyParts& b = overview_.groups().parts(result.body_b);
    for (const ContactPair& pair : result.pairs) {
        ++pairs[{a.part_of(pair.a), b.part_of(pair.b)}];
    }
    std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t>> sorted(
        pairs.begin(), pairs.end());
    std::ranges::stable_sort(
        sorted, [](const auto& left, const auto& right) { return left.second > right.second; });
    std::string text;
    for (std::size_t i = 0; i < sorted.size() && i < shown_max; ++i) {
        text += "; " + names_.part_name(result.body_a, a.name(sorted[i].first.first)) + " x " +
                names_.part_name(result.body_b, b.name(sorted[i].first.second)) + " " +
                grouped(sorted[i].second);
    }
    return text + (sorted.size() > shown_max ? "; ..." : "");
}

Html RunDocument::worst() {
    const auto& worst = overview_.worst();
    if (worst.empty()) {
        return {};
    }
    Html figures;
    for (std::size_t i = 0; i < worst.size(); ++i) {
        const ScenarioResult& result = worst[i];
        std::string words =
            names_.label_of(result.index) + ", " + std::string(to_text(result.kind));
        words += result.level == Level::Any ? "" : ", " + counted(result.pair_count, "pair");
        words += result.near_count == 0 ? "" : ", " + grouped(result.near_count) + " near";
        words += motions_ != nullptr ? ", " + motions_->text(result) : "";
        words += is_unmarked(result) ? "; not marked, since running it again failed or took more "
                                       "than " +
                                           std::to_string(timing::report_run_max.count()) + " s"
                                     : "";
        figures += html_figure(i < pictures_.scenarios().size() ? pictures_.scenarios()[i] : "",
                               Html::text(words + part_pairs_of(result)),
                               "scenario " + std::to_string(result.index));
    }
    const bool has_clearance = manifest_.query.clearance.has_value();
    std::string about = std::string("The worst scenarios") +
                        (has_clearance ? " in contact or near" : "") + ": " +
                        (manifest_.query.level == Level::Any
                             ? "the first ones of the worst class."
                             : "by class, and then by the number of pairs of triangles.");
    if (!std::ranges::all_of(worst, is_unmarked)) {
        about += " Triangles in contact are red, pale where they are hidden.";
        about += has_clearance ? " Triangles that are only near are orange. Where it is known, a "
                                 "line joins the nearest points of two near triangles."
                               : "";
    }
    if (manifest_.query.level < Level::Pairs) {
        about +=
            " Since the run lists no pairs, these scenarios were run again for their pictures.";
    }
    Html content = paragraph(about);
    content += Html::element("div", figures, {{"class", "cards"}});
    return html_section("Worst scenarios", content);
}

Html RunDocument::most_hits() const {
    if (overview_.worst().empty()) {
        return {};
    }
    std::vector<std::vector<Html>> rows{html_texts({"bundle", "hits"})};
    for (const ScenarioResult& result : overview_.worst()) {
        rows.push_back(html_texts({names_.label_of(result.index), grouped(result.pair_count)}));
    }
    return html_section("Most hits", html_table(rows, "groups"));
}

Result<Html> RunDocument::coincidence(const StopCheck& stop) const {
    std::set<Sha256> hashes;
    for (const auto& mesh : job_.meshes) {
        hashes.insert(mesh->hash());
    }
    if (hashes.size() == job_.meshes.size()) {
        return Html();
    }
    std::uint64_t count = 0;
    std::string some;
    for (std::uint64_t first = 0; first < job_.poses->count(); first += coincidences_at_once) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto scenarios = CD_TRY(
            job_.poses->read(first, std::min(coincidences_at_once, job_.poses->count() - first)));
        for (const Scenario& scenario : scenarios) {
            if (overview_.classes()[scenario.index] == RunOverview::left_out) {
                continue;
            }
            const Mesh& a = *job_.meshes[scenario.body_a];
            const Mesh& b = *job_.meshes[scenario.body_b];
            if (a.hash() == b.hash() && coincide(scenario.poses)) {
                some += count < 10 ? " #" + std::to_string(scenario.index) : "";
                ++count;
            }
        }
    }
    return count == 0
               ? Html()
               : paragraph((job_.scene ? "Two bodies of one mesh coincide in "
                                       : "B coincides with A in ") +
                               counted(count, "scenario") + ":" + some + (count > 10 ? " ..." : ""),
                           "warning");
}

Result<Html> RunDocument::charts(const StopCheck& stop) const {
    const auto& classes = overview_.classes();
    Html content = CD_TRY(coincidence(stop));
    const bool is_random = manifest_.poses.kind == PosesKind::Random;
    if (is_random) {
        content += paragraph("The poses were pushed to contact: shares are of these poses, and say "
                             "nothing about how often contacts occur.");
    }
    if (job_.grid) {
        const auto* spec = std::get_if<GridSpec>(&job_.spec.poses);
        const std::vector<GridAxis> axes = spec == nullptr ? std::vector<GridAxis>() : spec->axes;
        if (is_plane(*job_.grid)) {
            content += paragraph("Each cell shows the worst of its scenarios over all other axes.");
            content += ClassChart::of_grid(*job_.grid, axes, manifest_.unit, classes).svg();
            return html_section("Pose space", content);
        }
    } else if (classes.size() > 1) {
        content += paragraph(std::string("Where B's origin is in A's frame") +
                             (motions_ != nullptr ? " when a motion begins" : "") +
                             ". Each cell shows its worst scenario.");
        const auto map = CD_TRY(ClassChart::of_poses(*job_.poses, manifest_.unit, classes, stop));
        content += map.svg();
    }
    if (!is_random) {
        content += paragraph("The scenarios in their order. Each bar shows its worst scenario.");
        content += ClassChart::strip(classes).svg();
    }
    return html_section("Pose space", content);
}

Html RunDocument::how_it_ran() const {
    const ManifestOrigin& origin = manifest_.origin;
    const ManifestPlace& where = manifest_.where;
    std::vector<std::vector<Html>> rows{html_texts({"what", "value"})};
    const auto add = [&](const char* key, const std::string& value) {
        if (!value.empty()) {
            rows.push_back(
                html_texts({key, std::string(utf8_prefix(value, limits::report_text_bytes_max))}));
        }
    };
    add("program", origin.program);
    add("commit", origin.commit);
    add("command", origin.command);
    add("started", origin.started);
    add("ended", origin.ended);
    add("here", where.threads == 0 ? "" : counted(where.threads, "thread") + ", " + where.simd);
    add("master", where.master);
    add("job", where.job);
    add("workers", where.master.empty() ? "" : grouped(where.workers));
    add("level", std::string(asked_level(manifest_.query)));
    add("poses",
        counted(manifest_.poses.count, "scenario") +
            (manifest_.poses.file.empty() ? "" : " of " + manifest_.poses.file));
    add("SHA-256 of poses", manifest_.poses.hash ? to_hex(*manifest_.poses.hash) : "");
    for (const ManifestBody& body : manifest_.bodies) {
        add("SHA-256 of a mesh", to_hex(body.mesh) + "  " + short_name(body.file));
    }
    Html content = Html::element("summary", "Job file, versions, and how it ran");
    content += html_table(rows, "facts");
    content += Html::element("pre", utf8_prefix(manifest_.job, limits::report_job_bytes_max));
    return Html::element("details", content, {{"open", "open"}});
}

Result<std::string> RunDocument::html(const StopCheck& stop) {
    Html body = verdict();
    body += bodies();
    body += scene_ != nullptr ? scene_->section() : Html();
    body += shots_ != nullptr ? shots_->parts() : Html();
    body += shots_ != nullptr ? shots_->pictures() : Html();
    body += motions_ != nullptr ? motions_->lines(names_) : Html();
    body += has_lines() ? most_hits() : worst();
    body += has_distance() ? distances() : Html();
    body += viewer_ != nullptr ? viewer_->section() : Html();
    GroupSections sections(names_, manifest_, overview_, statuses_);
    if (!has_lines()) { // Lines are one part, and where bundles stand tells nothing.
        body += sections.matrix();
        body += CD_TRY(charts(stop));
    }
    body += sections.table();
    body += sections.against(baseline_);
    body += html_section("How it ran", how_it_ran());
    body += viewer_ != nullptr ? viewer_->answers() : Html();
    return Html::document("cdcluster: " + short_name(manifest_.name),
                          report_style + ClassChart::style_sheet() +
                              (motions_ != nullptr ? TimeStrip::style_sheet() : ""),
                          body,
                          viewer_ != nullptr ? viewer_->script() : "");
}

} // namespace cd
