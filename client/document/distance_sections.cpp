#include "client/document/distance_sections.hpp"

#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

constexpr std::size_t bars_max = 20;
constexpr double width = 640;
constexpr double height = 160;

Html label(double x, double y, const char* anchor, const std::string& text) {
    return Html::element("text",
                         text,
                         {{"x", fmt::format("{:.1f}", x)},
                          {"y", fmt::format("{:.1f}", y)},
                          {"text-anchor", anchor}});
}

/// Returns a bar's rectangle and number; `most` is the count of the highest bar.
Html bar_of(const DistanceBar& bar, std::size_t place, double step, std::size_t most) {
    const double tall = height * static_cast<double>(bar.count) / static_cast<double>(most);
    const double left = step * static_cast<double>(place);
    Html drawing = Html::element("rect",
                                 Html(),
                                 {{"x", fmt::format("{:.1f}", left + 1)},
                                  {"y", fmt::format("{:.1f}", height - tall)},
                                  {"width", fmt::format("{:.1f}", step - 2)},
                                  {"height", fmt::format("{:.1f}", tall)},
                                  {"fill", "#5b7fa6"}});
    if (bar.count != 0) {
        drawing += label(left + step / 2, height - tall - 3, "middle", grouped(bar.count));
    }
    return drawing;
}

Html chart_of(const std::vector<DistanceBar>& bars, const std::string& unit) {
    std::size_t most = 1;
    for (const DistanceBar& bar : bars) {
        most = std::max(most, bar.count);
    }
    const double step = width / static_cast<double>(bars.size());
    Html drawing;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        drawing += bar_of(bars[i], i, step, most);
    }
    drawing += Html::element("line",
                             Html(),
                             {{"x1", "0"},
                              {"x2", fmt::format("{:.0f}", width)},
                              {"y1", fmt::format("{:.0f}", height)},
                              {"y2", fmt::format("{:.0f}", height)},
                              {"stroke", "#555"}});
    drawing += label(0, height + 16, "start", fmt::format("{:.4g}", bars.front().from));
    drawing += label(width / 2, height + 16, "middle", "distance [" + unit + "]");
    drawing += label(width, height + 16, "end", fmt::format("{:.4g}", bars.back().to));
    return Html::element(
        "svg",
        drawing,
        {{"viewBox", fmt::format("-10 -16 {:.0f} {:.0f}", width + 20, height + 40)},
         {"role", "img"},
         {"class", "chart"}});
}

} // namespace

std::vector<DistanceBar> distance_bars(std::span<const double> distances) {
    if (distances.empty()) {
        return {};
    }
    const double greatest = *std::ranges::max_element(distances);
    if (greatest == 0) {
        return {{0, 0, distances.size()}};
    }
    std::vector<DistanceBar> bars(bars_max);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        bars[i].from = static_cast<double>(i) / bars_max * greatest;
        bars[i].to = static_cast<double>(i + 1) / bars_max * greatest;
    }
    for (const double distance : distances) {
        const auto place = static_cast<std::size_t>(distance / greatest * bars_max);
        ++bars[std::min(place, bars_max - 1)].count;
    }
    return bars;
}

std::string DistanceSections::length(double value) const {
    return fmt::format("{:.6g} ", value) + manifest_.unit;
}

std::string DistanceSections::least() const {
    if (overview_.nearest().empty()) {
        const std::optional<double>& up_to = manifest_.query.up_to;
        return std::string("No scenario has a distance: the bodies are in contact") +
               (up_to ? ", or farther apart than " + length(*up_to) : "") + ".";
    }
    const ScenarioResult& first = overview_.nearest().front();
    return "The least distance is " + length(first.nearest->distance) + ", in " +
           names_.label_of(first.index) + ".";
}

std::string DistanceSections::caption(const ScenarioResult& result) const {
    const NearestWitness& nearest = *result.nearest;
    const BodyParts& a = overview_.groups().parts(result.body_a);
    const BodyParts& b = overview_.groups().parts(result.body_b);
    return names_.label_of(result.index) + ", " + std::string(to_text(result.kind)) + ", " +
           length(nearest.distance) + " apart; " +
           names_.part_name(result.body_a, a.name(a.part_of(nearest.a))) + " x " +
           names_.part_name(result.body_b, b.name(b.part_of(nearest.b)));
}

Html DistanceSections::nearest(std::span<const std::string> pictures) const {
    const std::vector<ScenarioResult>& nearest = overview_.nearest();
    if (nearest.empty()) {
        return {};
    }
    Html figures;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        figures += html_figure(i < pictures.size() ? pictures[i] : "",
                               Html::text(caption(nearest[i])),
                               "scenario " + std::to_string(nearest[i].index));
    }
    Html content = paragraph("The scenarios in which the bodies share no point and are least "
                             "apart. A line joins the nearest points; the triangles that have "
                             "them are orange, pale where they are hidden.");
    content += Html::element("div", figures, {{"class", "cards"}});
    return html_section("Least distances", content);
}

Html DistanceSections::histogram() const {
    const std::vector<DistanceBar> bars = distance_bars(overview_.distances());
    if (bars.empty()) {
        return {};
    }
    Html content = paragraph("How far the bodies are apart: the number of scenarios by distance, " +
                             counted(overview_.distances().size(), "scenario") + " in all.");
    content += chart_of(bars, manifest_.unit);
    return html_section("Distances", content);
}

} // namespace cd
