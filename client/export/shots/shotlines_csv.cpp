#include "client/export/shots/bundle_passages.hpp"
#include "client/export/shots/shot_writers.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::string_view columns =
    "view,line,order,part,in,out,thickness,normal_thickness,cos_in,cos_out,triangle_in,"
    "triangle_out,gap\n";

class ShotlinesWriter final : public ResultWriter {
  public:
    ShotlinesWriter(std::shared_ptr<const ShotJob> job, RowFile file)
        : job_(std::move(job)), gatherer_(job_), file_(std::move(file)) {
        for (std::size_t body = 0; body < job_->bodies(); ++body) {
            bodies_.push_back(csv_field(job_->name(body)));
            const BodyParts& parts = job_->finder(body).parts();
            std::vector<std::string>& names = parts_.emplace_back();
            for (std::size_t i = 0; i < parts.count(); ++i) {
                names.push_back(csv_field(parts.name(i)));
            }
        }
    }

    Status add(const ScenarioResult& result) override {
        const auto bundle = CD_TRY(gatherer_.add(result));
        return bundle ? add_rows(*bundle) : Status(Done{});
    }

    Status finish() override {
        if (const auto bundle = gatherer_.finish()) {
            CD_TRY(add_rows(*bundle));
        }
        return file_.commit();
    }

  private:
    Status add_rows(const BundlePassages& bundle) {
        const std::uint32_t view = job_->views().view_of(bundle.bundle);
        const Mat3 axes = job_->views().rotation(view);
        std::uint32_t order = 0;
        for (std::size_t i = 0; i < bundle.passages.size(); ++i) {
            const BodyPassage& passage = bundle.passages[i];
            const std::uint32_t line = passage.way.line;
            const bool follows = i > 0 && bundle.passages[i - 1].way.line == line;
            order = follows ? order + 1 : 0;
            row_.clear();
            add_key(bundle.bodies[passage.place]);
            row_.add(view, ",", line, ",", order, ",");
            add_passage(passage.way, bundle.bodies[passage.place], axes * direction_of(line));
            if (const auto gap = gap_after(bundle, i)) {
                row_.add(*gap);
            }
            CD_TRY(file_.add(row_.text(), "\n"));
        }
        return Done{};
    }

    /// Adds the scenario, and of a scene the step, its time and the body.
    void add_key(const HitBody& body) {
        row_.add(body.scenario, ",");
        if (const auto& steps = job_->steps()) {
            const std::uint64_t step = steps->step_of(body.scenario);
            row_.add(step, ",", steps->time_of(step), ",");
            row_.add(std::string_view(bodies_[body.body]), ",");
        }
    }

    /// Returns the direction of a line in the bundle's coordinates, of length 1.
    [[nodiscard]] Vec3 direction_of(std::uint32_t line) const {
        const Corners corners = job_->lines().corners(line);
        return (corners[1] - corners[0]).stableNormalized();
    }

    /// Returns the cosine of the angle between a direction in the world and the normal of a body's
    /// triangle, whatever its sides.
    [[nodiscard]] double
    cosine(const HitBody& body, std::uint32_t triangle, const Vec3& direction) const {
        Corners corners = job_->mesh(body.body).corners(triangle);
        if (body.pose) {
            for (Vec3& corner : corners) {
                corner = body.pose->apply(corner);
            }
        }
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        return std::abs(normal.stableNormalized().dot(direction));
    }

    /// Adds the columns from the part to the triangles, and a comma.
    void add_passage(const Passage& passage, const HitBody& body, const Vec3& direction) {
        const double cos_in = cosine(body, passage.in.triangle, direction);
        row_.add(std::string_view(parts_[body.body][passage.part]), ",", passage.in.depth, ",");
        if (passage.out) {
            const double thickness = *passage.thickness();
            row_.add(passage.out->depth, ",", thickness, ",", thickness * cos_in, ",");
            row_.add(cos_in, ",", cosine(body, passage.out->triangle, direction), ",");
            row_.add(passage.in.triangle, ",", passage.out->triangle, ",");
            return;
        }
        row_.add(",,,", cos_in, ",,", passage.in.triangle, ",,");
    }

    /// Returns the way from the end of a passage to the begin of the next one of its line; negative
    /// where parts overlap. A passage of an open part ends where it begins.
    [[nodiscard]] std::optional<double> gap_after(const BundlePassages& bundle,
                                                  std::size_t i) const {
        const auto& [way, place] = bundle.passages[i];
        const bool has_next =
            i + 1 < bundle.passages.size() && bundle.passages[i + 1].way.line == way.line;
        const bool is_closed = job_->finder(bundle.bodies[place].body).is_closed(way.part);
        if (!has_next || (!way.out && is_closed)) {
            return std::nullopt;
        }
        return bundle.passages[i + 1].way.in.depth - way.out.value_or(way.in).depth;
    }

    std::shared_ptr<const ShotJob> job_;
    PassageGatherer gatherer_;
    RowFile file_;
    std::vector<std::string> bodies_;             ///< Names of bodies as CSV fields.
    std::vector<std::vector<std::string>> parts_; ///< Names of each body's parts likewise.
    TextBuffer row_;
};

} // namespace

Result<std::unique_ptr<ResultWriter>> make_shotlines_writer(std::shared_ptr<const ShotJob> job,
                                                            const std::filesystem::path& dir) {
    if (job->steps() && !job->poses()) {
        return bad_input("csv-pairs tells angles between lines and bodies, and the poses of the "
                         "scene are not at hand");
    }
    const std::string first = job->steps() ? "scenario,step,time,body," : "scenario,";
    auto file = CD_TRY(RowFile::create(dir / "shotlines.csv", first + std::string(columns)));
    return std::unique_ptr<ResultWriter>(
        std::make_unique<ShotlinesWriter>(std::move(job), std::move(file)));
}

} // namespace cd
