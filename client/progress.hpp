// The progress of a run on stderr.
#pragma once

#include "client/waiting_note.hpp"
#include "common/job/merge.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace cd {

/// How far a run is.
struct ProgressState {
    std::string name; ///< Of the job.
    Summary summary;
    double seconds = 0;        ///< Since it began.
    WaitingNote note = {};     ///< What it waits for.
    std::uint64_t resumed = 0; ///< Scenarios that were done before it began.
};

/// One line without its end; with a bar for a terminal.
[[nodiscard]] std::string progress_text(const ProgressState& state, bool with_bar);

/// Writes progress to stderr: on a terminal a bar that is redrawn, with the note below it,
/// otherwise a line each 10 s and each new note; or new notes alone. Lines on a terminal are cut at
/// its width.
class ProgressPrinter {
  public:
    enum class Style : std::uint8_t { Silent, Notes, Lines, Bar };

    /// Silent when quiet; a bar when stderr is a terminal that can redraw.
    [[nodiscard]] static Style style_for(bool quiet);

    explicit ProgressPrinter(Style style, std::FILE* stream = stderr)
        : style_(style), stream_(stream) {}
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;
    /// Ends the line of a bar.
    ~ProgressPrinter();

    /// Prints where it is due, judged by `state.seconds`, and where the note is another one.
    void update(const ProgressState& state);
    /// Prints the last state and ends the line of a bar.
    void finish(const ProgressState& state);

  private:
    void draw_bar(const ProgressState& state);
    void draw_lines(const ProgressState& state, bool is_due);

    Style style_;
    std::FILE* stream_;
    double next_seconds_ = 0;
    bool line_is_open_ = false;
    std::string note_; ///< As it was printed last.
};

} // namespace cd
