#include "client/export/result_writer.hpp"
#include "client/formats/npz.hpp"

#include <optional>
#include <vector>

namespace cd {

namespace {

/// Numbers of one array, buffered until a scenario is complete.
template <class T>
class Column {
  public:
    Column(NpzWriter& file, const char* name, NpyType type, std::uint64_t columns = 0)
        : array_(file.add_array(name, type, columns)) {}

    void add(T value) { values_.push_back(value); }
    void add(const Vec3& point) { values_.insert(values_.end(), point.data(), point.data() + 3); }
    [[nodiscard]] Status write(NpzWriter& file) {
        if (values_.empty()) {
            return Done{};
        }
        const Status written = file.append(array_, std::span<const T>(values_));
        values_.clear();
        return written;
    }

  private:
    std::size_t array_;
    std::vector<T> values_;
};

template <class... Columns>
[[nodiscard]] Status write_all(NpzWriter& file, Columns&... columns) {
    Status status = Done{};
    static_cast<void>(((status = columns.write(file)) && ...));
    return status;
}

/// The arrays with an entry for each scenario.
class ScenarioColumns {
  public:
    explicit ScenarioColumns(NpzWriter& file)
        : index_(file, "index", NpyType::U8),
          body_a_(file, "body_a", NpyType::U4),
          body_b_(file, "body_b", NpyType::U4),
          class_(file, "class", NpyType::U1),
          count_(file, "count", NpyType::U8),
          distance_bound_(file, "distance_bound", NpyType::F8),
          surfaces_only_(file, "surfaces_only", NpyType::U1),
          insides_skipped_(file, "insides_skipped", NpyType::U1) {}

    void add(const ScenarioResult& result) {
        index_.add(result.index);
        body_a_.add(result.body_a);
        body_b_.add(result.body_b);
        class_.add(static_cast<std::uint8_t>(result.kind));
        count_.add(result.pair_count);
        distance_bound_.add(result.distance_bound);
        surfaces_only_.add(result.surfaces_only ? 1 : 0);
        insides_skipped_.add(result.insides_skipped ? 1 : 0);
    }
    [[nodiscard]] Status write(NpzWriter& file) {
        return write_all(file,
                         index_,
                         body_a_,
                         body_b_,
                         class_,
                         count_,
                         distance_bound_,
                         surfaces_only_,
                         insides_skipped_);
    }

  private:
    Column<std::uint64_t> index_;
    Column<std::uint32_t> body_a_;
    Column<std::uint32_t> body_b_;
    Column<std::uint8_t> class_;
    Column<std::uint64_t> count_;
    Column<double> distance_bound_;
    Column<std::uint8_t> surfaces_only_;
    Column<std::uint8_t> insides_skipped_;
};

/// The arrays of all pairs. Scenario i has the pairs [offsets[i], offsets[i + 1]).
class PairColumns {
  public:
    explicit PairColumns(NpzWriter& file)
        : offsets_(file, "offsets", NpyType::U8),
          pairs_(file, "pairs", NpyType::U4, 2),
          class_(file, "pair_class", NpyType::U1) {
        offsets_.add(0);
    }

    void add(const ScenarioResult& result) {
        for (const ContactPair& pair : result.pairs) {
            pairs_.add(pair.a);
            pairs_.add(pair.b);
            class_.add(static_cast<std::uint8_t>(pair.kind));
        }
        end_ += result.pairs.size();
        offsets_.add(end_);
    }
    [[nodiscard]] Status write(NpzWriter& file) {
        return write_all(file, offsets_, pairs_, class_);
    }

  private:
    Column<std::uint64_t> offsets_;
    Column<std::uint32_t> pairs_;
    Column<std::uint8_t> class_;
    std::uint64_t end_ = 0;
};

/// The points of all pairs at full precision, relative to an origin for each pair.
class ExactPointColumns {
  public:
    explicit ExactPointColumns(NpzWriter& file)
        : origins_(file, "point_origins", NpyType::F8, 3),
          points_(file, "points", NpyType::F8, 3) {}

    void add(const ScenarioResult& result) {
        for (const Vec3& origin : result.point_origins) {
            origins_.add(origin);
        }
        for (const Vec3& point : result.points) {
            points_.add(point);
        }
    }
    [[nodiscard]] Status write(NpzWriter& file) { return write_all(file, origins_, points_); }

  private:
    Column<double> origins_;
    Column<double> points_;
};

/// The arrays of all points. Pair j has the points [point_offsets[j], point_offsets[j + 1]).
class PointColumns {
  public:
    explicit PointColumns(NpzWriter& file)
        : offsets_(file, "point_offsets", NpyType::U8),
          points_(file, "points_world", NpyType::F8, 3) {
        offsets_.add(0);
    }

    void add(const ScenarioResult& result) {
        for (std::size_t pair = 0; pair < result.pairs.size(); ++pair) {
            for_each_point(result, pair, [&](const Vec3& point) { points_.add(point); });
        }
        // The offsets in a result start at 0 and count only the result's own points.
        for (std::size_t i = 1; i < result.point_offsets.size(); ++i) {
            offsets_.add(end_ + result.point_offsets[i]);
        }
        end_ += result.points.size();
    }
    [[nodiscard]] Status write(NpzWriter& file) { return write_all(file, offsets_, points_); }

  private:
    Column<std::uint64_t> offsets_;
    Column<double> points_;
    std::uint64_t end_ = 0;
};

class NpzResults final : public ResultWriter {
  public:
    NpzResults(const ExportContext& context, const std::filesystem::path& path)
        : file_(path, context.stop), scenarios_(file_) {
        if (context.level >= Level::Pairs) {
            pairs_.emplace(file_);
        }
        if (context.level == Level::Contacts) {
            points_.emplace(file_);
        }
        if (context.level == Level::Contacts && context.exact_points) {
            exact_points_.emplace(file_);
        }
    }

    Status add(const ScenarioResult& result) override {
        Status written = write(scenarios_, result);
        if (written && pairs_) {
            written = write(*pairs_, result);
        }
        if (written && points_) {
            written = write(*points_, result);
        }
        if (written && exact_points_) {
            written = write(*exact_points_, result);
        }
        return written;
    }

    Status finish() override {
        // Without scenarios, the first entries of the offsets are not written yet.
        Status written = pairs_ ? pairs_->write(file_) : Status(Done{});
        if (written && points_) {
            written = points_->write(file_);
        }
        return written ? file_.finish() : written;
    }

  private:
    template <class Columns>
    [[nodiscard]] Status write(Columns& columns, const ScenarioResult& result) {
        columns.add(result);
        return columns.write(file_);
    }

    NpzWriter file_;
    ScenarioColumns scenarios_;
    std::optional<PairColumns> pairs_;
    std::optional<PointColumns> points_;
    std::optional<ExactPointColumns> exact_points_;
};

} // namespace

Result<std::unique_ptr<ResultWriter>> make_npz_writer(const ExportContext& context,
                                                      const std::filesystem::path& dir) {
    return std::unique_ptr<ResultWriter>(
        std::make_unique<NpzResults>(context, dir / "results.npz"));
}

} // namespace cd
