#include "client/scene/coverage_text.hpp"

#include "client/formats/csv_rows.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cd {

namespace {

constexpr std::size_t bodies_named_max = 10; ///< Absent bodies that a text names.

StepCoverage sum_over(const StepIndex& steps) {
    StepCoverage sum;
    for (const StepCoverage& step : steps.coverage()) {
        sum += step;
    }
    return sum;
}

/// Names the bodies that are absent at some step; empty if there is none.
std::string absences_text(std::span<const std::uint64_t> absences, const SceneBodies& scene) {
    std::string text;
    std::size_t absent = 0;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const std::uint64_t steps = absences[body];
        if (steps == 0 || ++absent > bodies_named_max) {
            continue;
        }
        text +=
            (text.empty() ? "" : ", ") + scene.bodies[body].name + " at " + counted(steps, "step");
    }
    return absent > bodies_named_max ? text + " and " + counted(absent - bodies_named_max, "other")
                                     : text;
}

} // namespace

std::string coverage_line(const StepCoverage& coverage) {
    std::string text = grouped(coverage.tested) + " of " + grouped(coverage.total()) +
                       " pairs tested, " + grouped(coverage.apart) + " apart by their boxes";
    text += coverage.ignored == 0 ? "" : ", " + grouped(coverage.ignored) + " ignored";
    text += coverage.fixed == 0 ? "" : ", " + grouped(coverage.fixed) + " of fixed bodies";
    text += coverage.absent == 0 ? "" : ", " + grouped(coverage.absent) + " of an absent body";
    return text;
}

std::string coverage_text(const StepIndex& steps,
                          std::span<const std::uint64_t> absences,
                          const SceneBodies& scene,
                          const std::string& indent) {
    const auto coverage = steps.coverage();
    std::string text = indent + coverage_line(sum_over(steps)) + "\n";
    if (coverage.size() > 1) {
        const auto most = std::ranges::max_element(coverage, {}, &StepCoverage::tested);
        text += indent + "most at step " +
                grouped(static_cast<std::uint64_t>(most - coverage.begin())) + ": " +
                coverage_line(*most) + "\n";
    }
    const std::string absent = absences_text(absences, scene);
    return text + (absent.empty() ? "" : indent + "absent: " + absent + "\n");
}

std::string coverage_row(const StepIndex& steps, std::uint64_t step) {
    const StepCoverage& coverage = steps.coverage()[step];
    TextBuffer row;
    row.add(step,
            ",",
            steps.time_of(step),
            ",",
            coverage.tested,
            ",",
            coverage.apart,
            ",",
            coverage.ignored,
            ",",
            coverage.fixed,
            ",",
            coverage.absent);
    return std::string(row.text());
}

std::string coverage_csv(const StepIndex& steps) {
    std::string text = std::string(coverage_columns) + "\n";
    for (std::uint64_t step = 0; step < steps.steps(); ++step) {
        text += coverage_row(steps, step) + "\n";
    }
    return text;
}

} // namespace cd
