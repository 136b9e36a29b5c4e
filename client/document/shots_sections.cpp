#include "client/document/shots_sections.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>

namespace cd {

namespace {

constexpr std::size_t parts_max = 100;

/// Calls `take` with each result.
template <class Take>
Status for_each_shot(const RecordFile& records, const StopCheck& stop, Take take) {
    return records.for_each([&](const RecordView& record) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        return take(record.result);
    });
}

std::string file_name_of(const ShotView& view) {
    return "thickness-az" + exact_text(view.azimuth_deg) + "-el" + exact_text(view.elevation_deg) +
           ".png";
}

} // namespace

Result<ShotsSections>
ShotsSections::read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop) {
    const auto shots = std::make_shared<const ShotJob>(export_context(job));
    const ShotViews& views = shots->views();
    ShotSums sums(shots, job.spec.unit);
    ThicknessPictures pictures(shots);
    CD_TRY(for_each_shot(records, stop, [&](const ScenarioResult& result) -> Status {
        CD_TRY(sums.add(result));
        return pictures.add(result);
    }));
    sums.finish();
    pictures.finish();
    ShotsSections sections;
    sections.is_scene_ = job.scene.has_value();
    sections.unit_ = job.spec.unit;
    sections.parts_ = sums.parts();
    sections.directions_ = views.count();
    for (std::uint32_t i = 0; i < pictures.count(); ++i) {
        View shown;
        shown.png = CD_TRY(png_bytes(pictures.image(i)));
        shown.caption = views.direction_text(i) + ": at most " +
                        sections.length(pictures.largest(i)) + " thick";
        sections.views_.push_back(std::move(shown));
    }
    return sections;
}

std::string ShotsSections::length(double value) const {
    return fmt::format("{:.6g} {}", value, unit_);
}

Html ShotsSections::parts() const {
    if (parts_.empty()) {
        return html_section(
            "Parts that lines cross",
            paragraph(is_scene_ ? "No line crosses a body." : "No line crosses A."));
    }
    std::vector<std::vector<Html>> rows{html_texts(
        {"part", "lines", "crossings", "seen area", "mean thickness", "largest thickness"})};
    for (const ShotPart& part : std::span(parts_).first(std::min(parts_.size(), parts_max))) {
        const std::string none = part.is_closed ? "" : "open";
        rows.push_back(html_texts({short_name(part.name),
                                   grouped(part.lines),
                                   grouped(part.crossings),
                                   part.area ? length(*part.area) + "\u00b2" : "",
                                   part.thickness ? length((*part.thickness)[0]) : none,
                                   part.thickness ? length((*part.thickness)[1]) : none}));
    }
    Html content = paragraph("The seen area is that of the cells whose line crosses the part, in "
                             "the mean over all directions" +
                             std::string(is_scene_ ? " and steps" : "") +
                             ". Only parts with a closed surface have "
                             "a thickness: from where a line enters to where it leaves.");
    content += html_table(rows, "groups");
    if (parts_.size() > parts_max) {
        content += paragraph(counted(parts_.size() - parts_max, "part") + " more in summary.json.");
    }
    return html_section("Parts that lines cross", content);
}

Html ShotsSections::pictures() const {
    if (views_.empty()) {
        return {};
    }
    Html figures;
    for (const View& view : views_) {
        figures += html_figure(view.png, Html::text(view.caption), view.caption);
    }
    const std::string seen = is_scene_ ? "The bodies as lines from each direction see them, at the "
                                         "step where they are thickest. "
                                       : "A as lines from each direction see it. ";
    Html content = paragraph(seen +
                             "The darker the blue, the thicker are all parts together; grey are "
                             "surfaces without an inside, white is where no line crosses " +
                             (is_scene_ ? "a body." : "A.") +
                             (directions_ > views_.size()
                                  ? " The first " + std::to_string(views_.size()) + " of " +
                                        counted(directions_, "direction") + "."
                                  : std::string()));
    content += Html::element("div", figures, {{"class", "cards"}});
    return html_section("Thickness", content);
}

Status write_thickness_pictures(const std::filesystem::path& folder,
                                const RecordFile& records,
                                const PreparedJob& job,
                                const StopCheck& stop) {
    const auto shots = std::make_shared<const ShotJob>(export_context(job));
    ThicknessPictures pictures(shots, large_thickness);
    CD_TRY(for_each_shot(
        records, stop, [&](const ScenarioResult& result) { return pictures.add(result); }));
    pictures.finish();
    for (std::uint32_t i = 0; i < pictures.count(); ++i) {
        const Image image = pictures.image(i);
        const auto side = static_cast<unsigned>(large_thickness.side);
        const unsigned times = std::max(1u, side / std::max(image.width, image.height));
        CD_TRY(write_png(enlarged(image, times), folder / file_name_of(shots->views().view(i))));
    }
    return Done{};
}

} // namespace cd
