// Prints the progress of a run to stderr.
#pragma once

#include "client/report/waiting_note.hpp"
#include "common/job/result/merge.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

namespace cd {

/// The progress of a run.
struct ProgressState {
    std::string name; ///< Name of the job.
    Summary summary;
    double seconds = 0;        ///< Time since the run began.
    WaitingNote note = {};     ///< Why the job is waiting, if it is.
    std::uint64_t resumed = 0; ///< Scenarios that an earlier run completed.
};

/// Returns the progress as one line without a newline, with or without a bar.
[[nodiscard]] std::string progress_text(const ProgressState& state, bool with_bar);

/// Writes progress to stderr: on a terminal a bar that is redrawn with the note below it, otherwise
/// a line every 10 s and each new note. Style `Notes` prints new notes only. Lines are cut at the
/// width of the terminal.
class ProgressPrinter {
  public:
    enum class Style : std::uint8_t { Silent, Notes, Lines, Bar };

    /// Returns Silent if `quiet`, Bar if stderr is a terminal that can redraw, else Lines.
    [[nodiscard]] static Style style_for(bool quiet);

    explicit ProgressPrinter(Style style, std::FILE* stream = stderr)
        : style_(style), stream_(stream) {}
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;
    /// Ends the line of a bar.
    ~ProgressPrinter();

    /// Prints if a bar or line is due at `state.seconds`, or if the note has changed.
    void update(const ProgressState& state);
    /// With a bar, prints the last state and ends the line; otherwise prints nothing.
    void finish(const ProgressState& state);

  private:
    void draw_bar(const ProgressState& state);
    void draw_lines(const ProgressState& state, bool is_due);

    Style style_;
    std::FILE* stream_;
    double next_seconds_ = 0;
    bool line_is_open_ = false;
    std::string note_; ///< The note printed last.
};

} // namespace cd
