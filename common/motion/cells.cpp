#include "common/motion/cells.hpp"

#include "common/core/limits/engine.hpp"
#include "common/pair/numbers/double_double.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Returns the least double that is at least the sum of two numbers, which are not negative.
double sum_above(double left, double right) {
    const DoubleDouble sum = exact_sum(left, right);
    return sum.low > 0 ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum.high) + 1)
                       : sum.high;
}

class CellSearch {
  public:
    CellSearch(const Motion& motion, Until until, double clearance, const CellQuestions& questions)
        : motion_(motion), until_(until), clearance_(clearance), questions_(questions) {
        answer_.until = until;
        answer_.depth = motion.depth();
    }

    MotionAnswer run() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        waiting_.push_back({{}, infinity});
        while (!waiting_.empty() && !is_done_) {
            if (answer_.cells == limits::motion_cells_max) {
                answer_.end = MotionEnd::Limit;
                break;
            }
            ++answer_.cells;
            const Waiting next = waiting_.back();
            waiting_.pop_back();
            visit(next.cell, motion_.bound(next.cell, next.bound_of_parent));
        }
        conclude();
        return std::move(answer_);
    }

  private:
    struct Waiting {
        TimeCell cell;
        double bound_of_parent;
    };

    void visit(const TimeCell& cell, double bound) {
        const double within = sum_above(bound, clearance_);
        // A sum that overflows proves nothing.
        const bool may_meet =
            !std::isfinite(within) || questions_.is_within(motion_.at_middle(cell), within);
        poll_stop();
        if (is_done_) {
            return;
        }
        if (!may_meet) {
            add_free(cell);
        } else if (bound <= motion_.resolution()) {
            answer_.open_within = std::max(answer_.open_within, within);
            add_open(cell);
        } else {
            const TimeCell left{cell.level + 1, 2 * cell.index};
            waiting_.push_back({{left.level, left.index + 1}, bound});
            waiting_.push_back({left, bound});
        }
    }

    void add_free(const TimeCell& cell) {
        extend(CellState::Free, cell);
        is_done_ = until_ == Until::Free;
    }

    /// Decides the event at both ends of an open leaf. A free leaf before it proves that there is
    /// none at their common end; an open one has asked already.
    void add_open(const TimeCell& cell) {
        if (cell.index == 0 && is_event(0)) {
            note_start();
        }
        if (is_done_) {
            return;
        }
        const std::uint32_t end = extend(CellState::Open, cell);
        if (is_event(end)) {
            note_event(end);
        }
    }

    /// Notes that the event holds at tau = 0, before the first run exists.
    void note_start() {
        if (until_ == Until::Free) {
            starts_with_event_ = true;
            return;
        }
        answer_.end = MotionEnd::Start;
        has_bracket_ = true;
        is_done_ = until_ == Until::Contact;
        starts_with_event_ = !is_done_;
    }

    void note_event(std::uint32_t instant) {
        CellRun& run = answer_.runs.back();
        run.event_first = run.has_event() ? run.event_first : instant;
        run.event_last = instant;
        if (until_ != Until::Free && !has_bracket_) {
            has_bracket_ = true;
            answer_.end = MotionEnd::Contact;
            answer_.t0 = run.first;
            answer_.t1 = instant;
            is_done_ = until_ == Until::Contact;
        }
    }

    [[nodiscard]] bool is_event(std::uint32_t instant) {
        const bool is = questions_.is_event(motion_.at(instant, answer_.depth));
        poll_stop();
        return is && !answer_.is_stopped;
    }

    /// Appends a leaf to the runs, and returns its end.
    std::uint32_t extend(CellState state, const TimeCell& cell) {
        const unsigned above = answer_.depth - cell.level;
        if (answer_.runs.empty() || answer_.runs.back().state != state) {
            answer_.runs.push_back({state, cell.index << above, 0});
        }
        ++answer_.leaves;
        CellRun& run = answer_.runs.back();
        run.count += 1u << above;
        if (starts_with_event_) {
            run.event_first = 0;
            run.event_last = 0;
            starts_with_event_ = false;
        }
        return run.end();
    }

    void poll_stop() {
        if (questions_.stop && questions_.stop()) {
            answer_.is_stopped = true;
            is_done_ = true;
        }
    }

    /// Sets what is known only once the search has ended.
    void conclude() {
        if (has_bracket_ || answer_.runs.empty()) {
            return;
        }
        const CellRun& last = answer_.runs.back();
        const auto with_event = std::find_if(answer_.runs.rbegin(),
                                             answer_.runs.rend(),
                                             [](const CellRun& run) { return run.has_event(); });
        const bool is_free = until_ == Until::Free && last.state == CellState::Free;
        answer_.t1 = is_free ? last.first : last.end();
        answer_.t0 = with_event == answer_.runs.rend() ? answer_.t1 : with_event->event_last;
        if (until_ == Until::Free && !is_free && answer_.end != MotionEnd::Limit) {
            answer_.end = MotionEnd::Contact;
        }
    }

    const Motion& motion_;
    Until until_;
    double clearance_;
    const CellQuestions& questions_;
    MotionAnswer answer_;
    std::vector<Waiting> waiting_; ///< The last is next; at most one of each level, and one more.
    bool is_done_ = false;
    bool has_bracket_ = false;       ///< t0 and t1 are those of the first event.
    bool starts_with_event_ = false; ///< The first run, which does not exist yet, has it at 0.
};

} // namespace

MotionAnswer
search_cells(const Motion& motion, Until until, double clearance, const CellQuestions& questions) {
    return CellSearch(motion, until, clearance, questions).run();
}

} // namespace cd
