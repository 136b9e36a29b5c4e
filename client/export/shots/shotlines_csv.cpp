#include "client/export/shots/shot_writers.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::string_view header =
    "scenario,view,line,order,part,in,out,thickness,normal_thickness,cos_in,cos_out,triangle_in,"
    "triangle_out,gap\n";

class ShotlinesWriter final : public ResultWriter {
  public:
    ShotlinesWriter(const ExportContext& context,
                    std::shared_ptr<const PassageFinder> finder,
                    RowFile file)
        : finder_(std::move(finder)),
          a_(context.bodies[0].mesh),
          lines_(context.bodies[1].mesh),
          views_(context.bodies[1].views ? *context.bodies[1].views : ShotViews()),
          file_(std::move(file)) {
        for (std::size_t i = 0; i < finder_->parts().count(); ++i) {
            parts_.push_back(csv_field(finder_->parts().name(i)));
        }
    }

    Status add(const ScenarioResult& result) override {
        const std::vector<Passage> passages = finder_->passages(result);
        const std::uint32_t view = views_.view_of(result.index);
        const Mat3 axes = views_.rotation(view);
        std::uint32_t order = 0;
        for (std::size_t i = 0; i < passages.size(); ++i) {
            const bool follows = i > 0 && passages[i - 1].line == passages[i].line;
            order = follows ? order + 1 : 0;
            row_.clear();
            row_.add(result.index, ",", view, ",", passages[i].line, ",", order, ",");
            add_passage(passages[i], axes * direction_of(passages[i].line));
            if (const auto gap = gap_after(std::span(passages).subspan(i))) {
                row_.add(*gap);
            }
            CD_TRY(file_.add(row_.text(), "\n"));
        }
        return Done{};
    }

    Status finish() override { return file_.commit(); }

  private:
    /// Returns the direction of a line in the bundle's coordinates, of length 1.
    [[nodiscard]] Vec3 direction_of(std::uint32_t line) const {
        const Corners corners = lines_->corners(line);
        return (corners[1] - corners[0]).stableNormalized();
    }

    /// Returns the cosine of the angle between a direction and a triangle's normal, whatever its
    /// sides.
    [[nodiscard]] double cosine(std::uint32_t triangle, const Vec3& direction) const {
        const Corners corners = a_->corners(triangle);
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        return std::abs(normal.stableNormalized().dot(direction));
    }

    /// Adds the columns from the part to the triangles, and a comma.
    void add_passage(const Passage& passage, const Vec3& direction) {
        const double cos_in = cosine(passage.in.triangle, direction);
        row_.add(std::string_view(parts_[passage.part]), ",", passage.in.depth, ",");
        if (passage.out) {
            const double thickness = *passage.thickness();
            row_.add(passage.out->depth, ",", thickness, ",", thickness * cos_in, ",");
            row_.add(cos_in, ",", cosine(passage.out->triangle, direction), ",");
            row_.add(passage.in.triangle, ",", passage.out->triangle, ",");
            return;
        }
        row_.add(",,,", cos_in, ",,", passage.in.triangle, ",,");
    }

    /// Returns the way from the end of the first passage to the begin of the next one of its line;
    /// negative where parts overlap. A passage of an open part ends where it begins.
    [[nodiscard]] std::optional<double> gap_after(std::span<const Passage> passages) const {
        const Passage& passage = passages.front();
        const bool has_next = passages.size() > 1 && passages[1].line == passage.line;
        if (!has_next || (!passage.out && finder_->is_closed(passage.part))) {
            return std::nullopt;
        }
        return passages[1].in.depth - passage.out.value_or(passage.in).depth;
    }

    std::shared_ptr<const PassageFinder> finder_;
    std::shared_ptr<const Mesh> a_;
    std::shared_ptr<const Mesh> lines_;
    ShotViews views_;
    RowFile file_;
    std::vector<std::string> parts_; ///< Names of the parts of A as CSV fields.
    TextBuffer row_;
};

} // namespace

Result<std::unique_ptr<ResultWriter>>
make_shotlines_writer(const ExportContext& context,
                      std::shared_ptr<const PassageFinder> finder,
                      const std::filesystem::path& dir) {
    auto file = CD_TRY(RowFile::create(dir / "shotlines.csv", header));
    return std::unique_ptr<ResultWriter>(
        std::make_unique<ShotlinesWriter>(context, std::move(finder), std::move(file)));
}

} // namespace cd
