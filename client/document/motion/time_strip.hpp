// The time of a motion as a drawn line: where it is free, open, or with the event.
#pragma once

#include "client/document/html.hpp"
#include "common/motion/motion_outcome.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cd {

/// What is known of a part of a motion's time; later ones are worse.
enum class TimeState : std::uint8_t {
    Unknown = 0, ///< The search ended before.
    Free = 1,
    Open = 2,
    Near = 3,    ///< Between the first and the last instant of a run at which the bodies are near.
    Contact = 4, ///< Likewise in contact.
};

/// The time of a motion in equal cells, each with the worst that is known in it.
class TimeStrip {
  public:
    static constexpr std::size_t cells = 256;

    /// `is_near`: the event is that the bodies are near.
    TimeStrip(const MotionOutcome& motion, bool is_near);

    [[nodiscard]] TimeState at(std::size_t cell) const { return cells_[cell]; }
    /// Returns the drawing, of a fixed size. Readers that do not show it read the shares of the
    /// time: "free 75 %, open 25 %".
    [[nodiscard]] Html svg() const;
    /// Returns the rules for the colours, without angle brackets.
    [[nodiscard]] static std::string style_sheet();

  private:
    void add(std::uint32_t begin, std::uint32_t end, unsigned depth, TimeState state);
    [[nodiscard]] std::string shares() const;

    std::array<TimeState, cells> cells_{};
};

} // namespace cd
