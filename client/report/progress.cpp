#include "client/report/progress.hpp"

#include "common/core/printable.hpp"
#include "common/core/words.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

namespace cd {

namespace {

constexpr double bar_period = 0.1;
constexpr double line_period = 10;

/// Returns how many columns a line of the stream may have; npos if it is no terminal.
std::size_t width_of(std::FILE* stream) {
    winsize size{};
    const bool is_known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return is_known ? size.ws_col - 1u : std::string::npos;
}

} // namespace

std::string progress_text(const ProgressState& state, bool with_bar) {
    const Summary& summary = state.summary;
    const std::uint64_t done = summary.merged();
    const double share =
        summary.total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(summary.total);
    std::string text = state.name + "  ";
    if (with_bar) {
        constexpr std::size_t width = 26;
        const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
        text += "[" + std::string(filled, '#') + std::string(width - filled, '-') + "]  ";
    }
    text += std::to_string(static_cast<int>(100 * share)) + "%  " + grouped(done) + "/" +
            grouped(summary.total);
    const double rate =
        state.seconds > 0 ? static_cast<double>(done - state.resumed) / state.seconds : 0;
    const std::uint64_t contacts = summary.touch + summary.cross + summary.inside + summary.contact;
    text += "   " + rate_text(rate) + "/s   contact " + grouped(contacts);
    text += summary.near == 0 ? "" : "   near " + grouped(summary.near);
    if (rate > 0 && done < summary.total && !state.note.stands_still) {
        const auto left =
            static_cast<std::uint64_t>(std::ceil(static_cast<double>(summary.total - done) / rate));
        const std::uint64_t seconds = left % 60;
        text += "   ETA " + std::to_string(left / 60) + (seconds < 10 ? ":0" : ":") +
                std::to_string(seconds);
    }
    return text;
}

ProgressPrinter::Style ProgressPrinter::style_for(bool quiet) {
    if (quiet) {
        return Style::Silent;
    }
    const char* terminal = std::getenv("TERM");
    const bool redraws = terminal != nullptr && std::string(terminal) != "dumb";
    return isatty(STDERR_FILENO) != 0 && redraws ? Style::Bar : Style::Lines;
}

ProgressPrinter::~ProgressPrinter() {
    if (line_is_open_) {
        std::fputc('\n', stream_);
    }
}

void ProgressPrinter::update(const ProgressState& state) {
    if (style_ == Style::Silent) {
        return;
    }
    if (style_ == Style::Lines && next_seconds_ == 0) {
        next_seconds_ = line_period;
    }
    const bool is_due = style_ != Style::Notes && state.seconds >= next_seconds_;
    if (!is_due && state.note.text == note_) {
        return;
    }
    if (is_due) {
        next_seconds_ = state.seconds + (style_ == Style::Bar ? bar_period : line_period);
    }
    if (style_ == Style::Bar) {
        draw_bar(state);
    } else {
        draw_lines(state, is_due);
    }
    note_ = state.note.text;
}

void ProgressPrinter::finish(const ProgressState& state) {
    if (style_ == Style::Bar) {
        draw_bar(state);
        std::fputc('\n', stream_);
        line_is_open_ = false;
    }
}

/// Rewrites the line of the bar and the line of the note below it, and moves back up.
void ProgressPrinter::draw_bar(const ProgressState& state) {
    const std::size_t width = width_of(stream_);
    std::string text =
        "\r" + std::string(utf8_prefix(progress_text(state, true), width)) + "\x1b[K";
    if (!state.note.text.empty() || !note_.empty()) {
        text += "\n" + std::string(utf8_prefix(state.note.text, width)) + "\x1b[K\x1b[A\r";
    }
    std::fputs(text.c_str(), stream_);
    std::fflush(stream_);
    line_is_open_ = true;
}

void ProgressPrinter::draw_lines(const ProgressState& state, bool is_due) {
    if (is_due) {
        std::fprintf(stream_, "%s\n", progress_text(state, false).c_str());
    }
    if (!state.note.text.empty() && state.note.text != note_) {
        std::fprintf(stream_, "%s  %s\n", state.name.c_str(), state.note.text.c_str());
    }
    std::fflush(stream_);
}

} // namespace cd
