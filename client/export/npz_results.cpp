#include "client/export/result_writer.hpp"
#include "client/formats/npz.hpp"

#include <array>
#include <span>
#include <vector>

namespace cd {

namespace {

/// An array of results.npz; docs/formats.md describes each.
struct NpzColumn {
    const char* name;
    NpyType type;
    std::uint64_t columns = 0; ///< Columns of an array of rows; 0: the array has one dimension.
};

/// The arrays in the order of the archive. Each higher level adds arrays at the end.
constexpr std::array<NpzColumn, 15> columns{{{"index", NpyType::U8},
                                             {"body_a", NpyType::U4},
                                             {"body_b", NpyType::U4},
                                             {"class", NpyType::U1},
                                             {"count", NpyType::U8},
                                             {"distance_bound", NpyType::F8},
                                             {"surfaces_only", NpyType::U1},
                                             {"insides_skipped", NpyType::U1},
                                             {"offsets", NpyType::U8},
                                             {"pairs", NpyType::U4, 2},
                                             {"pair_class", NpyType::U1},
                                             {"point_offsets", NpyType::U8},
                                             {"points_world", NpyType::F8, 3},
                                             {"point_origins", NpyType::F8, 3},
                                             {"points", NpyType::F8, 3}}};
constexpr std::size_t offsets = 8; ///< The first array that `level pairs` adds.
constexpr std::size_t pairs = 9;
constexpr std::size_t pair_class = 10;
constexpr std::size_t point_offsets = 11; ///< The first array that `level contacts` adds.
constexpr std::size_t points_world = 12;
constexpr std::size_t point_origins = 13; ///< The first array that exact points add.
constexpr std::size_t points = 14;

class NpzResults final : public ResultWriter {
  public:
    NpzResults(const ExportContext& context, const std::filesystem::path& path)
        : file_(path, context.stop),
          count_(context.level < Level::Pairs       ? offsets
                 : context.level != Level::Contacts ? point_offsets
                 : context.exact_points             ? columns.size()
                                                    : point_origins) {
        for (std::size_t i = 0; i < count_; ++i) {
            file_.add_array(columns[i].name, columns[i].type, columns[i].columns);
        }
        for (const std::size_t array : {offsets, point_offsets}) {
            if (array < count_) {
                put(array, std::uint64_t{0});
            }
        }
    }

    Status add(const ScenarioResult& result) override {
        put(0, result.index);
        put(1, result.body_a);
        put(2, result.body_b);
        put(3, static_cast<std::uint8_t>(result.kind));
        put(4, result.pair_count);
        put(5, result.distance_bound);
        put(6, static_cast<std::uint8_t>(result.surfaces_only ? 1 : 0));
        put(7, static_cast<std::uint8_t>(result.insides_skipped ? 1 : 0));
        if (count_ > offsets) {
            add_pairs(result);
        }
        if (count_ > point_offsets) {
            add_points(result);
        }
        if (count_ > point_origins) {
            append(point_origins, numbers_of(result.point_origins));
            append(points, numbers_of(result.points));
        }
        return status_;
    }

    Status finish() override { return status_ ? file_.finish() : status_; }

  private:
    /// Adds a scenario's pairs; scenario i has the pairs [offsets[i], offsets[i + 1]).
    void add_pairs(const ScenarioResult& result) {
        std::vector<std::uint32_t> triangles;
        std::vector<std::uint8_t> classes;
        for (const ContactPair& pair : result.pairs) {
            triangles.insert(triangles.end(), {pair.a, pair.b});
            classes.push_back(static_cast<std::uint8_t>(pair.kind));
        }
        append(pairs, triangles);
        append(pair_class, classes);
        pairs_end_ += result.pairs.size();
        put(offsets, pairs_end_);
    }

    /// Adds a scenario's points; pair j has the points [point_offsets[j], point_offsets[j + 1]).
    void add_points(const ScenarioResult& result) {
        std::vector<Vec3> world;
        for (std::size_t pair = 0; pair < result.pairs.size(); ++pair) {
            for_each_point(result, pair, [&](const Vec3& point) { world.push_back(point); });
        }
        append(points_world, numbers_of(world));
        // The result's own offsets start at 0; those in the file count the points of all results.
        for (std::size_t i = 1; i < result.point_offsets.size(); ++i) {
            put(point_offsets, points_end_ + result.point_offsets[i]);
        }
        points_end_ += result.points.size();
    }

    static std::vector<double> numbers_of(const std::vector<Vec3>& vectors) {
        std::vector<double> numbers;
        for (const Vec3& v : vectors) {
            numbers.insert(numbers.end(), v.data(), v.data() + 3);
        }
        return numbers;
    }

    template <class T>
    void append(std::size_t array, const std::vector<T>& values) {
        status_ = status_ ? file_.append(array, std::span<const T>(values)) : status_;
    }
    template <class T>
    void put(std::size_t array, T value) {
        status_ = status_ ? file_.append(array, std::span<const T>(&value, 1)) : status_;
    }

    NpzWriter file_;
    std::size_t count_; ///< How many of `columns` are written.
    std::uint64_t pairs_end_ = 0;
    std::uint64_t points_end_ = 0;
    Status status_ = Done{};
};

} // namespace

std::unique_ptr<ResultWriter> make_npz_writer(const ExportContext& context,
                                              const std::filesystem::path& dir) {
    return std::make_unique<NpzResults>(context, dir / "results.npz");
}

} // namespace cd
