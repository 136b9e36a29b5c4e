#include "client/document/motion/time_strip.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cd {

namespace {

struct StateLook {
    const char* colour;
    const char* word;
};
constexpr std::array<StateLook, 5> looks{{{"#ffffff", "not searched"},
                                          {"#a0a4a8", "free"},
                                          {"#b07fd0", "open"},
                                          {"#f08c28", "near"},
                                          {"#c8201e", "in contact"}}};

/// Returns the commands of an SVG path that draw the cells of a state; equal neighbours are one
/// rectangle.
std::string path_of(const std::array<TimeState, TimeStrip::cells>& cells, TimeState state) {
    std::string path;
    for (std::size_t begin = 0; begin < cells.size();) {
        std::size_t end = begin + 1;
        while (end < cells.size() && cells[end] == cells[begin]) {
            ++end;
        }
        if (cells[begin] == state) {
            path += fmt::format("M{0} 0h{1}v8h-{1}z", begin, end - begin);
        }
        begin = end;
    }
    return path;
}

} // namespace

TimeStrip::TimeStrip(const MotionOutcome& motion, bool is_near) {
    for (const CellRun& run : motion.runs) {
        add(run.first,
            run.end(),
            motion.depth,
            run.state == CellState::Free ? TimeState::Free : TimeState::Open);
    }
    const TimeState event = is_near ? TimeState::Near : TimeState::Contact;
    for (const CellRun& run : motion.runs) {
        if (run.has_event()) {
            add(run.event_first, run.event_last, motion.depth, event);
        }
    }
    if (motion.end == MotionEnd::Start) { // Perhaps without a run.
        add(0, 0, motion.depth, event);
    }
}

/// Adds a part of the time in units of 2^-depth. An instant is in the cell that begins with it, or
/// in the last cell.
void TimeStrip::add(std::uint32_t begin, std::uint32_t end, unsigned depth, TimeState state) {
    const std::uint64_t first = std::uint64_t{begin} * cells >> depth;
    const std::uint64_t last = ((std::uint64_t{end} * cells - (begin < end ? 1 : 0)) >> depth);
    for (std::uint64_t cell = std::min<std::uint64_t>(first, cells - 1);
         cell <= std::min<std::uint64_t>(last, cells - 1);
         ++cell) {
        cells_[cell] = std::max(cells_[cell], state);
    }
}

std::string TimeStrip::shares() const {
    std::string text;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const auto count = std::ranges::count(cells_, static_cast<TimeState>(i));
        if (count != 0) {
            text += fmt::format("{}{} {:.3g} %",
                                text.empty() ? "" : ", ",
                                looks[i].word,
                                100.0 * static_cast<double>(count) / cells);
        }
    }
    return text;
}

Html TimeStrip::svg() const {
    Html drawing;
    for (std::size_t i = 1; i < looks.size(); ++i) {
        const std::string path = path_of(cells_, static_cast<TimeState>(i));
        if (!path.empty()) {
            drawing +=
                Html::element("path", Html(), {{"class", "m" + std::to_string(i)}, {"d", path}});
        }
    }
    return Html::element("svg",
                         drawing,
                         {{"viewBox", fmt::format("0 0 {} 8", cells)},
                          {"preserveAspectRatio", "none"},
                          {"role", "img"},
                          {"aria-label", shares()},
                          {"class", "time"}});
}

std::string TimeStrip::style_sheet() {
    std::string style = ".time{width:60mm;height:4mm;vertical-align:middle;border:1px solid #555}";
    for (std::size_t i = 1; i < looks.size(); ++i) {
        style += fmt::format(".m{}{{fill:{}}}", i, looks[i].colour);
    }
    return style;
}

} // namespace cd
