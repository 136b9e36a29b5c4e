#include "client/export/result_writer.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/result/drawn_witness.hpp"

#include <optional>

namespace cd {

namespace {

class ScenariosCsvWriter final : public ResultWriter {
  public:
    ScenariosCsvWriter(const ExportContext& context, OutputFile file)
        : file_(std::move(file)),
          context_(context),
          steps_(context.steps),
          has_hits_(context.question == Question::Shots),
          times_(context.has_motions() ? std::optional(context.times) : std::nullopt) {
        for (const ExportBody& body : context.bodies) {
            names_.push_back(csv_field(body.name));
        }
    }

    Status add(const ScenarioResult& result) override {
        const std::string_view yes_or_no[] = {"0", "1"}; // NOLINT(modernize-avoid-c-arrays)
        row_.clear();
        row_.add(header_once());
        add_key(result);
        row_.add(",", to_text(result.kind), ",");
        if (result.level != Level::Any) {
            row_.add(result.pair_count);
        }
        row_.add(context_.clearance ? "," : "");
        if (context_.clearance && result.level != Level::Any) {
            row_.add(result.near_count);
        }
        if (context_.has_distance()) {
            add_nearest(result.nearest);
        }
        if (has_hits_) {
            row_.add(",", result.pair_count);
        }
        if (const auto bundle = context_.bundle_of(result)) {
            row_.add(",", *bundle, ",", csv_field(context_.bodies.back().views->id_of(*bundle)));
        }
        if (times_) {
            add_motion(result);
        }
        row_.add(",", yes_or_no[result.is_cut() ? 1 : 0], ",");
        if (result.kind == ScenarioClass::Undecided) {
            row_.add(result.distance_bound);
        }
        row_.add(",",
                 yes_or_no[result.surfaces_only ? 1 : 0],
                 ",",
                 yes_or_no[result.insides_skipped ? 1 : 0],
                 ",",
                 csv_field(result.failure),
                 "\n");
        return file_.write(row_.text());
    }

    Status finish() override {
        CD_TRY(file_.write(header_once()));
        return file_.commit();
    }

  private:
    /// Adds the scenario and its bodies, and of a scene before all the step and its time.
    void add_key(const ScenarioResult& result) {
        const std::string_view body_a = names_[result.body_a];
        const std::string_view body_b = names_[result.body_b];
        if (!steps_) {
            row_.add(result.index, ",", body_a, ",", body_b);
            return;
        }
        const std::uint64_t step = steps_->step_of(result.index);
        row_.add(step, ",", steps_->time_of(step), ",", body_a, ",", body_b, ",", result.index);
    }

    /// Adds a comma before each column of the distance and the nearest points.
    void add_nearest(const std::optional<NearestWitness>& nearest) {
        if (!nearest) {
            row_.add(",,,,,,,,,");
            return;
        }
        row_.add(",", nearest->distance, ",", nearest->a, ",", nearest->b);
        for (const Vec3& point : witness_points(*nearest)) {
            row_.add(",", point.x(), ",", point.y(), ",", point.z());
        }
    }

    /// Adds a comma before each column of a motion.
    void add_motion(const ScenarioResult& result) {
        row_.add(",", result.motion ? to_text(result.motion->end) : "", ",");
        const auto times = times_->bracket(result);
        if (times) {
            row_.add(times->first, ",", times->second);
        } else {
            row_.add(",");
        }
    }

    [[nodiscard]] std::string header_once() {
        if (has_header_) {
            return {};
        }
        has_header_ = true;
        return std::string(steps_ ? "step,time,body_a,body_b,scenario" : "scenario,body_a,body_b") +
               ",class,count," + (context_.clearance ? "near_count," : "") +
               (context_.has_distance() ? "distance,triangle_a,triangle_b,ax,ay,az,bx,by,bz,"
                                        : "") +
               (has_hits_ ? "hits," : "") + (has_hits_ && steps_ ? "bundle,bundle_id," : "") +
               (times_ ? "end,t0,t1," : "") +
               "cut,distance_bound,surfaces_only,insides_skipped,failure\n";
    }

    OutputFile file_;
    ExportContext context_;
    std::vector<std::string> names_; ///< Names of the bodies as CSV fields.
    TextBuffer row_;
    std::shared_ptr<const StepIndex> steps_; ///< Null for a job of two bodies.
    bool has_hits_;
    std::optional<MotionTimes> times_; ///< Of motions.
    bool has_header_ = false;
};

class PairsCsvWriter final : public ResultWriter {
  public:
    PairsCsvWriter(const ExportContext& context,
                   std::optional<RowFile> pairs,
                   std::optional<RowFile> points)
        : pairs_(std::move(pairs)), points_(std::move(points)) {
        for (const ExportBody& body : context.bodies) {
            parts_.emplace_back(body.mesh);
        }
    }

    Status add(const ScenarioResult& result) override {
        Status status = Done{};
        for (std::size_t i = 0; status && pairs_ && i < result.pairs.size(); ++i) {
            status = add_pair(result, i);
        }
        return status;
    }

    Status finish() override {
        for (std::optional<RowFile>* file : {&pairs_, &points_}) {
            if (!file->has_value()) {
                continue;
            }
            CD_TRY((*file)->commit());
        }
        return Done{};
    }

  private:
    Status add_pair(const ScenarioResult& result, std::size_t number) {
        const ContactPair& pair = result.pairs[number];
        key_.clear();
        key_.add(result.index, ",", pair.a, ",", pair.b, ",");
        Status status = pairs_->add(key_.text(),
                                    pair_class_name(pair.kind),
                                    ",",
                                    parts_[result.body_a].of(pair.a),
                                    ",",
                                    parts_[result.body_b].of(pair.b),
                                    "\n");
        for_each_point(result, number, [&](const Vec3& point) {
            if (status && points_) {
                status = points_->add(key_.text(), point.x(), ",", point.y(), ",", point.z(), "\n");
            }
        });
        return status;
    }

    std::vector<PartFields> parts_; ///< The names of each body's parts.
    std::optional<RowFile> pairs_;
    std::optional<RowFile> points_;
    TextBuffer key_;
};

} // namespace

std::unique_ptr<ResultWriter> make_scenarios_csv_writer(const ExportContext& context,
                                                        OutputFile file) {
    return std::make_unique<ScenariosCsvWriter>(context, std::move(file));
}

Result<std::unique_ptr<ResultWriter>> make_pairs_csv_writer(const ExportContext& context,
                                                            const std::filesystem::path& dir) {
    std::optional<RowFile> pairs;
    std::optional<RowFile> points;
    if (context.level >= Level::Pairs) {
        auto created = CD_TRY(RowFile::create(
            dir / "pairs.csv", "scenario,triangle_a,triangle_b,class,part_a,part_b\n"));
        pairs.emplace(std::move(created));
    }
    if (context.level == Level::Contacts) {
        auto created =
            CD_TRY(RowFile::create(dir / "points.csv", "scenario,triangle_a,triangle_b,x,y,z\n"));
        points.emplace(std::move(created));
    }
    return std::unique_ptr<ResultWriter>(
        std::make_unique<PairsCsvWriter>(context, std::move(pairs), std::move(points)));
}

} // namespace cd
