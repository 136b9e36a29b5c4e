// The page's viewer in a report: its script, and what it shows.
#pragma once

#include "client/document/html.hpp"
#include "client/view/held_answers.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace cd {

/// A viewer of some scenarios. For each request of the page's script, the document has an inert
/// element (`template`) with the request's path and its answer, as gzip in Base64.
class EmbeddedViewer {
  public:
    EmbeddedViewer();

    void add(const HeldAnswer& answer);
    /// Adds answers that are of use only together, if the viewer then has at most so many bytes.
    /// Returns whether it added them.
    [[nodiscard]] bool add_if_room(std::span<const HeldAnswer> answers, std::uint64_t bytes_max);
    /// Returns the size of the viewer in the document.
    [[nodiscard]] std::uint64_t bytes() const { return script().size() + answers_.markup().size(); }

    /// Returns the section of the report in which the viewer appears. Without scripts it says what
    /// is missing; on paper it is left out.
    [[nodiscard]] static Html section();
    /// Returns the elements that hold the answers.
    [[nodiscard]] const Html& answers() const { return answers_; }
    /// Returns the page's script, a module.
    [[nodiscard]] static std::string_view script();

  private:
    Html answers_;
};

} // namespace cd
