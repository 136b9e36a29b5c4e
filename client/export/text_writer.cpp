#include "client/export/result_writer.hpp"
#include "client/formats/csv_rows.hpp"
#include "client/formats/part_finder.hpp"
#include "common/core/printable.hpp"
#include "common/core/words.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "common/shots/line_hit.hpp"

#include <cmath>
#include <optional>

namespace cd {

namespace {

std::string triangle_text(PartFinder& parts, std::uint32_t triangle) {
    const std::string number = std::to_string(triangle);
    const auto part_number = parts.find(triangle);
    if (!part_number || parts.parts()[*part_number].name.empty()) {
        return number;
    }
    const Part& part = parts.parts()[*part_number];
    return number + " (" + valid_utf8(part.name) + " " +
           std::to_string(triangle - part.triangles_begin) + ")";
}

std::string point_text(const Vec3& point) {
    return "  " + exact_text(point.x()) + " " + exact_text(point.y()) + " " + exact_text(point.z());
}

/// Tells how a line meets a triangle: "enters at depth 3".
std::string hit_text(const PairHit& hit) {
    const bool crosses = (hit.flags & hit_flag::crosses) != 0;
    const bool enters = (hit.flags & hit_flag::front) != 0;
    return std::string(!crosses ? "grazes"
                       : enters ? "enters"
                                : "leaves") +
           " at depth " + exact_text(hit.depth);
}

/// Whether a result of contacts, which an earlier version wrote, is undecided.
bool is_undecided_contact(const ScenarioResult& result) {
    return result.kind == ScenarioClass::Undecided && result.question == Question::Contacts;
}

/// Tells the bound of an undecided result; empty if nothing bounds the distance.
std::string bound_text(const ScenarioResult& result) {
    if (std::isinf(result.distance_bound)) {
        return is_undecided_contact(result) ? "  at most inf apart" : "";
    }
    const std::string bound = exact_text(result.distance_bound);
    return is_undecided_contact(result) ? "  at most " + bound + " apart"
                                        : "  open where at most " + bound + " apart";
}

class TextWriter final : public ResultWriter {
  public:
    TextWriter(const ExportContext& context, OutputFile file)
        : steps_(context.steps),
          up_to_(context.up_to),
          times_(context.times),
          file_(std::move(file)) {
        for (const ExportBody& body : context.bodies) {
            parts_.emplace_back(body.mesh);
            names_.push_back(valid_utf8(body.name));
        }
    }

    Status add(const ScenarioResult& result) override {
        text_.clear();
        text_.add(result.index, "  ", place_text(result), to_text(result.kind));
        if (result.level != Level::Any && result.kind != ScenarioClass::Failed) {
            const bool is_shots = result.question == Question::Shots;
            text_.add(is_undecided_contact(result) ? "  at least " : "  ",
                      counted(result.pair_count, is_shots ? "hit" : "pair"));
            if (result.has_clearance) {
                text_.add(", ", grouped(result.near_count), " near");
            }
        }
        if (result.is_cut()) {
            text_.add(", the first ", grouped(result.pairs.size()));
        }
        text_.add(result.kind == ScenarioClass::Undecided ? bound_text(result) : "",
                  motion_text(result),
                  nearest_text(result),
                  result.surfaces_only ? "  surfaces only" : "",
                  result.insides_skipped ? "  containment not tested" : "",
                  result.failure.empty() ? "" : "  ",
                  result.failure,
                  "\n");
        const std::vector<double> distances =
            result.near_distances.empty() ? std::vector<double>() : pair_distances(result);
        for (std::size_t i = 0; i < result.pairs.size(); ++i) {
            text_.add(pair_text(result, i, distances));
        }
        return file_.write(text_.text());
    }

    Status finish() override { return file_.commit(); }

  private:
    /// Names the step and the bodies of a scene's result; empty for a job of two bodies.
    [[nodiscard]] std::string place_text(const ScenarioResult& result) const {
        return steps_ ? "step " + std::to_string(steps_->step_of(result.index)) + "  " +
                            names_[result.body_a] + "  " + names_[result.body_b] + "  "
                      : "";
    }

    /// Says what is proven of a motion.
    [[nodiscard]] std::string motion_text(const ScenarioResult& result) const {
        const std::string text = result.motion ? times_.text(result) : "";
        return text.empty() ? text : "  " + text;
    }

    [[nodiscard]] std::string pair_text(const ScenarioResult& result,
                                        std::size_t number,
                                        const std::vector<double>& distances) {
        const ContactPair& pair = result.pairs[number];
        std::string text = "    A " + triangle_text(parts_[result.body_a], pair.a) + "  B " +
                           triangle_text(parts_[result.body_b], pair.b) + "  ";
        if (!result.hits.empty()) {
            return text + hit_text(result.hits[number]) + "\n";
        }
        text += pair_class_name(pair.kind);
        if (pair.kind == PairClass::Near && !distances.empty()) {
            text += "  " + exact_text(distances[number]) + " apart";
        }
        for_each_point(result, number, [&](const Vec3& point) { text += point_text(point); });
        return text + "\n";
    }

    /// Returns the distance with its triangles and points; empty without one.
    [[nodiscard]] std::string nearest_text(const ScenarioResult& result) {
        if (!result.nearest) {
            const bool is_beyond = up_to_ && result.kind == ScenarioClass::Separate;
            return is_beyond ? "  farther than " + exact_text(*up_to_) + " apart" : "";
        }
        std::string text = "  " + exact_text(result.nearest->distance) + " apart  A " +
                           triangle_text(parts_[result.body_a], result.nearest->a) + "  B " +
                           triangle_text(parts_[result.body_b], result.nearest->b);
        for (const Vec3& point : witness_points(*result.nearest)) {
            text += point_text(point);
        }
        return text;
    }

    std::vector<PartFinder> parts_;          ///< Finds the parts of each body.
    std::vector<std::string> names_;         ///< Of each body.
    std::shared_ptr<const StepIndex> steps_; ///< Null for a job of two bodies.
    std::optional<double> up_to_;
    MotionTimes times_;
    OutputFile file_;
    TextBuffer text_; ///< Of one scenario.
};

} // namespace

std::unique_ptr<ResultWriter> make_text_writer(const ExportContext& context, OutputFile file) {
    return std::make_unique<TextWriter>(context, std::move(file));
}

} // namespace cd
