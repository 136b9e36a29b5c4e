#include "client/export/result_writer.hpp"
#include "client/formats/npz.hpp"

#include <vector>

namespace cd {

namespace {

/// Numbers of one array, buffered until a scenario is complete.
template <class T>
struct Column {
    std::size_t array = 0;
    std::vector<T> values;
};

/// Ragged lists as compressed rows: the pairs of scenario i are [offsets[i], offsets[i + 1]), the
/// points of pair j are [point_offsets[j], point_offsets[j + 1]).
class NpzResults final : public ResultWriter {
  public:
    NpzResults(const ExportContext& context, const std::filesystem::path& path)
        : level_(context.level), exact_points_(context.exact_points), file_(path, context.stop) {
        add_array(index_, "index", NpyType::U8);
        add_array(body_a_, "body_a", NpyType::U4);
        add_array(body_b_, "body_b", NpyType::U4);
        add_array(class_, "class", NpyType::U1);
        add_array(count_, "count", NpyType::U8);
        add_array(distance_bound_, "distance_bound", NpyType::F8);
        add_array(surfaces_only_, "surfaces_only", NpyType::U1);
        add_array(insides_skipped_, "insides_skipped", NpyType::U1);
        if (level_ >= Level::Pairs) {
            add_array(offsets_, "offsets", NpyType::U8);
            add_array(pairs_, "pairs", NpyType::U4, 2);
            add_array(pair_class_, "pair_class", NpyType::U1);
            offsets_.values.push_back(0);
        }
        if (level_ == Level::Contacts) {
            add_array(point_offsets_, "point_offsets", NpyType::U8);
            add_array(points_world_, "points_world", NpyType::F8, 3);
            point_offsets_.values.push_back(0);
        }
        if (level_ == Level::Contacts && exact_points_) {
            add_array(point_origins_, "point_origins", NpyType::F8, 3);
            add_array(points_, "points", NpyType::F8, 3);
        }
    }

    Status add(const ScenarioResult& result) override {
        index_.values.push_back(result.index);
        body_a_.values.push_back(result.body_a);
        body_b_.values.push_back(result.body_b);
        class_.values.push_back(static_cast<std::uint8_t>(result.kind));
        count_.values.push_back(result.pair_count);
        distance_bound_.values.push_back(result.distance_bound);
        surfaces_only_.values.push_back(result.surfaces_only ? 1 : 0);
        insides_skipped_.values.push_back(result.insides_skipped ? 1 : 0);
        if (level_ >= Level::Pairs) {
            add_pairs(result);
        }
        if (level_ == Level::Contacts) {
            add_points(result);
        }
        return write();
    }

    Status finish() override {
        if (Status written = write(); !written) {
            return written;
        }
        return file_.finish();
    }

  private:
    template <class T>
    void add_array(Column<T>& column, const char* name, NpyType type, std::uint64_t columns = 0) {
        column.array = file_.add_array(name, type, columns);
    }

    static void append_point(Column<double>& column, const Vec3& point) {
        column.values.insert(column.values.end(), point.data(), point.data() + 3);
    }

    void add_pairs(const ScenarioResult& result) {
        for (const ContactPair& pair : result.pairs) {
            pairs_.values.insert(pairs_.values.end(), {pair.a, pair.b});
            pair_class_.values.push_back(static_cast<std::uint8_t>(pair.kind));
        }
        pairs_end_ += result.pairs.size();
        offsets_.values.push_back(pairs_end_);
    }

    void add_points(const ScenarioResult& result) {
        for (std::size_t pair = 0; pair < result.pairs.size(); ++pair) {
            for_each_point(
                result, pair, [&](const Vec3& point) { append_point(points_world_, point); });
        }
        // A result's own offsets start at 0.
        for (std::size_t i = 1; i < result.point_offsets.size(); ++i) {
            point_offsets_.values.push_back(points_end_ + result.point_offsets[i]);
        }
        points_end_ += result.points.size();
        if (exact_points_) {
            for (const Vec3& origin : result.point_origins) {
                append_point(point_origins_, origin);
            }
            for (const Vec3& point : result.points) {
                append_point(points_, point);
            }
        }
    }

    template <class T>
    [[nodiscard]] Status write(Column<T>& column) {
        if (column.values.empty()) {
            return Done{};
        }
        const Status written = file_.append(column.array, std::span<const T>(column.values));
        column.values.clear();
        return written;
    }

    template <class... Columns>
    [[nodiscard]] Status write_all(Columns&... columns) {
        Status status = Done{};
        static_cast<void>(((status = write(columns)) && ...));
        return status;
    }

    [[nodiscard]] Status write() {
        return write_all(index_,
                         body_a_,
                         body_b_,
                         class_,
                         count_,
                         distance_bound_,
                         surfaces_only_,
                         insides_skipped_,
                         offsets_,
                         pairs_,
                         pair_class_,
                         point_offsets_,
                         points_world_,
                         point_origins_,
                         points_);
    }

    Level level_;
    bool exact_points_;
    NpzWriter file_;
    Column<std::uint64_t> index_;
    Column<std::uint32_t> body_a_;
    Column<std::uint32_t> body_b_;
    Column<std::uint8_t> class_;
    Column<std::uint64_t> count_;
    Column<double> distance_bound_;
    Column<std::uint8_t> surfaces_only_;
    Column<std::uint8_t> insides_skipped_;
    Column<std::uint64_t> offsets_;
    Column<std::uint32_t> pairs_;
    Column<std::uint8_t> pair_class_;
    Column<std::uint64_t> point_offsets_;
    Column<double> points_world_;
    Column<double> point_origins_;
    Column<double> points_;
    std::uint64_t pairs_end_ = 0;
    std::uint64_t points_end_ = 0;
};

} // namespace

Result<std::unique_ptr<ResultWriter>> make_npz_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    return std::unique_ptr<ResultWriter>(
        std::make_unique<NpzResults>(context, dir / "results.npz"));
}

} // namespace cd
