#include "client/export/result_writer.hpp"
#include "client/npz.hpp"

namespace cd {

namespace {

/// Ragged lists as compressed rows: the pairs of scenario i are [offsets[i], offsets[i + 1]), the
/// points of pair j are [point_offsets[j], point_offsets[j + 1]).
class NpzResults final : public ResultWriter {
  public:
    NpzResults(Level level, const std::filesystem::path& path) : level_(level), file_(path) {
        index_ = file_.add_array("index", NpyType::U8);
        class_ = file_.add_array("class", NpyType::U1);
        count_ = file_.add_array("count", NpyType::U8);
        distance_bound_ = file_.add_array("distance_bound", NpyType::F8);
        surfaces_only_ = file_.add_array("surfaces_only", NpyType::U1);
        if (level_ >= Level::Pairs) {
            offsets_ = file_.add_array("offsets", NpyType::U8);
            pairs_ = file_.add_array("pairs", NpyType::U4, 2);
            pair_class_ = file_.add_array("pair_class", NpyType::U1);
            append(offsets_, pairs_end_);
        }
        if (level_ == Level::Contacts) {
            point_origins_ = file_.add_array("point_origins", NpyType::F8, 3);
            point_offsets_ = file_.add_array("point_offsets", NpyType::U8);
            points_ = file_.add_array("points", NpyType::F8, 3);
            append(point_offsets_, points_end_);
        }
    }

    Status add(const ScenarioResult& result) override {
        append(index_, result.index);
        append(class_, static_cast<std::uint8_t>(result.kind));
        append(count_, result.pair_count);
        append(distance_bound_, result.distance_bound);
        append(surfaces_only_, static_cast<std::uint8_t>(result.surfaces_only ? 1 : 0));
        if (level_ >= Level::Pairs) {
            add_pairs(result);
        }
        if (level_ == Level::Contacts) {
            add_points(result);
        }
        return Done{};
    }

    Status finish() override { return file_.finish(); }

  private:
    template <class T>
    void append(std::size_t array, T value) {
        file_.append(array, std::span<const T>(&value, 1));
    }

    void append_point(std::size_t array, const Vec3& value) {
        file_.append(array, std::span<const double>(value.data(), 3));
    }

    void add_pairs(const ScenarioResult& result) {
        for (const ContactPair& pair : result.pairs) {
            append(pairs_, pair.a);
            append(pairs_, pair.b);
            append(pair_class_, static_cast<std::uint8_t>(pair.kind));
        }
        pairs_end_ += result.pairs.size();
        append(offsets_, pairs_end_);
    }

    void add_points(const ScenarioResult& result) {
        for (const Vec3& origin : result.point_origins) {
            append_point(point_origins_, origin);
        }
        for (const Vec3& point : result.points) {
            append_point(points_, point);
        }
        // A result's own offsets start at 0.
        for (std::size_t i = 1; i < result.point_offsets.size(); ++i) {
            append(point_offsets_, points_end_ + result.point_offsets[i]);
        }
        points_end_ += result.points.size();
    }

    Level level_;
    NpzWriter file_;
    std::size_t index_ = 0;
    std::size_t class_ = 0;
    std::size_t count_ = 0;
    std::size_t distance_bound_ = 0;
    std::size_t surfaces_only_ = 0;
    std::size_t offsets_ = 0;
    std::size_t pairs_ = 0;
    std::size_t pair_class_ = 0;
    std::size_t point_origins_ = 0;
    std::size_t point_offsets_ = 0;
    std::size_t points_ = 0;
    std::uint64_t pairs_end_ = 0;
    std::uint64_t points_end_ = 0;
};

} // namespace

Result<std::unique_ptr<ResultWriter>> make_npz_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    return std::unique_ptr<ResultWriter>(
        std::make_unique<NpzResults>(context.level, dir / "results.npz"));
}

} // namespace cd
