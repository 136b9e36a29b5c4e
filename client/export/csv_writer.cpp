#include "client/export/csv_rows.hpp"
#include "client/export/result_writer.hpp"

#include <optional>

namespace cd {

namespace {

class ScenariosCsvWriter final : public ResultWriter {
  public:
    explicit ScenariosCsvWriter(OutputFile file) : file_(std::move(file)) {}

    Status add(const ScenarioResult& result) override {
        const std::string_view yes_or_no[] = {"0", "1"}; // NOLINT(modernize-avoid-c-arrays)
        row_.clear();
        row_.add(header_once(), result.index, ",", to_text(result.kind), ",");
        if (result.level != Level::Any) {
            row_.add(result.pair_count);
        }
        row_.add(",", yes_or_no[result.is_cut() ? 1 : 0], ",");
        if (result.kind == ScenarioClass::Undecided) {
            row_.add(result.distance_bound);
        }
        row_.add(
            ",", yes_or_no[result.surfaces_only ? 1 : 0], ",", csv_field(result.failure), "\n");
        return file_.write(row_.text());
    }

    Status finish() override {
        if (Status written = file_.write(header_once()); !written) {
            return written;
        }
        return file_.commit();
    }

  private:
    [[nodiscard]] std::string_view header_once() {
        const bool first = !has_header_;
        has_header_ = true;
        return first ? "scenario,class,count,cut,distance_bound,surfaces_only,failure\n" : "";
    }

    OutputFile file_;
    TextBuffer row_;
    bool has_header_ = false;
};

class CsvWriter final : public ResultWriter {
  public:
    CsvWriter(const ExportContext& context,
              std::unique_ptr<ResultWriter> scenarios,
              std::optional<RowFile> pairs,
              std::optional<RowFile> points)
        : parts_a_(context.meshes[0]),
          parts_b_(context.meshes[1]),
          scenarios_(std::move(scenarios)),
          pairs_(std::move(pairs)),
          points_(std::move(points)) {}

    Status add(const ScenarioResult& result) override {
        Status status = scenarios_->add(result);
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
            if (Status done = (*file)->commit(); !done) {
                return done;
            }
        }
        return scenarios_->finish();
    }

  private:
    Status add_pair(const ScenarioResult& result, std::size_t place) {
        const ContactPair& pair = result.pairs[place];
        key_.clear();
        key_.add(result.index, ",", pair.a, ",", pair.b, ",");
        Status status = pairs_->add(key_.text(),
                                    pair_class_name(pair.kind),
                                    ",",
                                    parts_a_.of(pair.a),
                                    ",",
                                    parts_b_.of(pair.b),
                                    "\n");
        for_each_point(result, place, [&](const Vec3& point) {
            if (status && points_) {
                status = points_->add(key_.text(), point.x(), ",", point.y(), ",", point.z(), "\n");
            }
        });
        return status;
    }

    PartFields parts_a_;
    PartFields parts_b_;
    std::unique_ptr<ResultWriter> scenarios_;
    std::optional<RowFile> pairs_;
    std::optional<RowFile> points_;
    TextBuffer key_;
};

} // namespace

std::unique_ptr<ResultWriter> make_scenarios_csv_writer(OutputFile file) {
    return std::make_unique<ScenariosCsvWriter>(std::move(file));
}

Result<std::unique_ptr<ResultWriter>> make_csv_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    auto scenarios = OutputFile::create(dir / "scenarios.csv");
    if (!scenarios) {
        return scenarios.error();
    }
    std::optional<RowFile> pairs;
    std::optional<RowFile> points;
    if (context.level >= Level::Pairs) {
        auto created = RowFile::create(dir / "pairs.csv",
                                       "scenario,triangle_a,triangle_b,class,part_a,part_b\n");
        if (!created) {
            return created.error();
        }
        pairs.emplace(std::move(created.value()));
    }
    if (context.level == Level::Contacts) {
        auto created =
            RowFile::create(dir / "points.csv", "scenario,triangle_a,triangle_b,x,y,z\n");
        if (!created) {
            return created.error();
        }
        points.emplace(std::move(created.value()));
    }
    return std::unique_ptr<ResultWriter>(
        std::make_unique<CsvWriter>(context,
                                    make_scenarios_csv_writer(std::move(scenarios.value())),
                                    std::move(pairs),
                                    std::move(points)));
}

} // namespace cd
