#include "client/export/result_writer.hpp"
#include "client/formats/array_file.hpp"
#include "common/job/result/drawn_witness.hpp"

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// What a job must have or ask for so that the file has an array.
enum class ArrayNeed : std::uint8_t {
    Nothing,
    Pairs,     ///< `level pairs` or above, unless shots.npz or shots.h5 has the pairs.
    Contacts,  ///< `level contacts`.
    Exact,     ///< `level contacts`, and exact points.
    Clearance, ///< A clearance.
    Distances, ///< `level contacts`, and a clearance.
    Nearest,   ///< The question of the distance.
    Offsets,   ///< That question, and exact points.
    Steps,     ///< A scene.
    Motion,    ///< The question of motions.
};

/// An array of the results; docs/formats.md describes each.
struct ArrayColumn {
    const char* name;
    NpyType type;
    std::uint64_t columns = 0; ///< Columns of an array of rows; 0: the array has one dimension.
    ArrayNeed need = ArrayNeed::Nothing;
    std::uint64_t rows_each = 1; ///< Above 1: so many rows a scenario, in a dimension of their own.
};

/// The arrays in the order of the file.
constexpr std::array<ArrayColumn, 30> columns{
    {{"index", NpyType::U8},
     {"body_a", NpyType::U4},
     {"body_b", NpyType::U4},
     {"class", NpyType::U1},
     {"count", NpyType::U8},
     {"distance_bound", NpyType::F8},
     {"surfaces_only", NpyType::U1},
     {"insides_skipped", NpyType::U1},
     {"offsets", NpyType::U8, 0, ArrayNeed::Pairs},
     {"pairs", NpyType::U4, 2, ArrayNeed::Pairs},
     {"pair_class", NpyType::U1, 0, ArrayNeed::Pairs},
     {"point_offsets", NpyType::U8, 0, ArrayNeed::Contacts},
     {"points_world", NpyType::F8, 3, ArrayNeed::Contacts},
     {"point_origins", NpyType::F8, 3, ArrayNeed::Exact},
     {"points", NpyType::F8, 3, ArrayNeed::Exact},
     {"near_count", NpyType::U8, 0, ArrayNeed::Clearance},
     {"pair_distance", NpyType::F8, 0, ArrayNeed::Distances},
     {"distance", NpyType::F8, 0, ArrayNeed::Nearest},
     {"witness", NpyType::U4, 2, ArrayNeed::Nearest},
     {"feature", NpyType::U1, 0, ArrayNeed::Nearest},
     {"witness_points", NpyType::F8, 3, ArrayNeed::Nearest, 2},
     {"witness_origin", NpyType::F8, 3, ArrayNeed::Offsets},
     {"witness_offsets", NpyType::F8, 3, ArrayNeed::Offsets, 2},
     {"step", NpyType::U8, 0, ArrayNeed::Steps},
     {"end", NpyType::U1, 0, ArrayNeed::Motion},
     {"depth", NpyType::U1, 0, ArrayNeed::Motion},
     {"t0", NpyType::U4, 0, ArrayNeed::Motion},
     {"t1", NpyType::U4, 0, ArrayNeed::Motion},
     {"run_offsets", NpyType::U8, 0, ArrayNeed::Motion},
     {"runs", NpyType::U4, 5, ArrayNeed::Motion}}};
constexpr std::size_t offsets = 8;
constexpr std::size_t pairs = 9;
constexpr std::size_t pair_class = 10;
constexpr std::size_t point_offsets = 11;
constexpr std::size_t points_world = 12;
constexpr std::size_t point_origins = 13;
constexpr std::size_t points = 14;
constexpr std::size_t near_count = 15;
constexpr std::size_t pair_distance = 16;
constexpr std::size_t nearest_distance = 17;
constexpr std::size_t witness = 18;
constexpr std::size_t witness_feature = 19;
constexpr std::size_t nearest_points = 20;
constexpr std::size_t witness_origin = 21;
constexpr std::size_t witness_offsets = 22;
constexpr std::size_t scene_step = 23;
constexpr std::size_t motion_end = 24;
constexpr std::size_t motion_depth = 25;
constexpr std::size_t motion_t0 = 26;
constexpr std::size_t motion_t1 = 27;
constexpr std::size_t run_offsets = 28;
constexpr std::size_t motion_runs = 29;

/// The place of an array that the file does not have.
constexpr std::size_t no_place = columns.size();

bool is_met(ArrayNeed need, const ExportContext& context) {
    const bool has_contacts = context.level == Level::Contacts;
    switch (need) {
    case ArrayNeed::Nothing:
        break;
    case ArrayNeed::Pairs:
        return context.level >= Level::Pairs && !context.has_hits();
    case ArrayNeed::Contacts:
        return has_contacts;
    case ArrayNeed::Exact:
        return has_contacts && context.exact_points;
    case ArrayNeed::Clearance:
        return context.clearance.has_value();
    case ArrayNeed::Distances:
        return has_contacts && context.clearance.has_value();
    case ArrayNeed::Nearest:
        return context.has_distance();
    case ArrayNeed::Offsets:
        return context.has_distance() && context.exact_points;
    case ArrayNeed::Steps:
        return context.steps != nullptr;
    case ArrayNeed::Motion:
        return context.has_motions();
    }
    return true;
}

class ArrayResults final : public ResultWriter {
  public:
    ArrayResults(const ExportContext& context, std::unique_ptr<ArrayFile> file)
        : file_(std::move(file)), steps_(context.steps) {
        places_.fill(no_place);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (is_met(columns[i].need, context)) {
                places_[i] = file_->add_array(
                    {columns[i].name, columns[i].type, columns[i].columns, columns[i].rows_each});
            }
        }
        for (const std::size_t array : {offsets, point_offsets, run_offsets}) {
            if (has(array)) {
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
        if (has(near_count)) {
            put(near_count, result.near_count);
        }
        if (has(offsets)) {
            add_pairs(result);
        }
        if (has(point_offsets)) {
            add_points(result);
        }
        if (has(pair_distance)) {
            append(pair_distance, pair_distances(result));
        }
        if (has(point_origins)) {
            append(point_origins, numbers_of(result.point_origins));
            append(points, numbers_of(result.points));
        }
        if (has(nearest_distance)) {
            add_nearest(result);
        }
        if (has(scene_step)) {
            put(scene_step, steps_->step_of(result.index));
        }
        if (has(motion_end)) {
            add_motion(result);
        }
        return status_;
    }

    Status finish() override { return status_ ? file_->finish() : status_; }

  private:
    /// True if the file has an array of `columns`.
    [[nodiscard]] bool has(std::size_t array) const { return places_[array] != no_place; }

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

    /// Adds the nearest points; NaN, and triangles 0, without a distance.
    void add_nearest(const ScenarioResult& result) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        const Vec3 none = Vec3::Constant(nan);
        const NearestWitness nearest =
            result.nearest.value_or(NearestWitness{nan, 0, 0, 0, none, none, none});
        const auto [a, b] = witness_points(nearest);
        put(nearest_distance, nearest.distance);
        append(witness, std::vector<std::uint32_t>{nearest.a, nearest.b});
        put(witness_feature, nearest.feature);
        append(nearest_points, numbers_of({a, b}));
        if (has(witness_origin)) {
            append(witness_origin, numbers_of({nearest.origin}));
            append(witness_offsets, numbers_of({nearest.point_a, nearest.point_b}));
        }
    }

    /// Adds what is proven of a motion; zeros and no runs if it failed. Scenario i has the runs
    /// [run_offsets[i], run_offsets[i + 1]): state, first, count, first and last with the event.
    void add_motion(const ScenarioResult& result) {
        const MotionOutcome motion = result.motion.value_or(MotionOutcome{});
        put(motion_end, static_cast<std::uint8_t>(motion.end));
        put(motion_depth, static_cast<std::uint8_t>(motion.depth));
        put(motion_t0, motion.t0);
        put(motion_t1, motion.t1);
        std::vector<std::uint32_t> rows;
        for (const CellRun& run : motion.runs) {
            rows.insert(rows.end(),
                        {static_cast<std::uint32_t>(run.state),
                         run.first,
                         run.count,
                         run.event_first,
                         run.event_last});
        }
        append(motion_runs, rows);
        runs_end_ += motion.runs.size();
        put(run_offsets, runs_end_);
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
        status_ = status_ ? file_->append(places_[array], std::span<const T>(values)) : status_;
    }
    template <class T>
    void put(std::size_t array, T value) {
        status_ = status_ ? file_->append(places_[array], std::span<const T>(&value, 1)) : status_;
    }

    std::unique_ptr<ArrayFile> file_;
    std::shared_ptr<const StepIndex> steps_;           ///< Null for a job of two bodies.
    std::array<std::size_t, columns.size()> places_{}; ///< In the file, of each of `columns`.
    std::uint64_t pairs_end_ = 0;
    std::uint64_t points_end_ = 0;
    std::uint64_t runs_end_ = 0;
    Status status_ = Done{};
};

} // namespace

std::unique_ptr<ResultWriter> make_array_writer(std::string_view format,
                                                const ExportContext& context,
                                                const std::filesystem::path& dir) {
    return std::make_unique<ArrayResults>(context,
                                          make_array_file(format, dir, "results", context.stop));
}

} // namespace cd
