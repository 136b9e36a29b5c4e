// Writes results into files, with one writer per format.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/motion_times.hpp"
#include "client/formats/output_file.hpp"
#include "client/report/report.hpp"
#include "client/spec/job_file.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A body in exports.
struct ExportBody {
    std::string name; ///< Name in the job, or else "a" or "b".
    std::string file; ///< Name of the mesh file, for display.
    std::shared_ptr<const Mesh> mesh;
    bool is_rounded = false;                     ///< Coordinates were rounded to floats on request.
    bool is_fixed = false;                       ///< In a scene: its pose is the same at all steps.
    std::shared_ptr<const ShotViews> views = {}; ///< Of the body of lines; null for other bodies.
    /// Of the body of lines in a scene: where it and the others stand in each scenario; null where
    /// that is not at hand.
    std::shared_ptr<PoseSource> poses = {};
};

/// Which pairs of triangles are told.
struct ListedPairs {
    std::uint64_t limit_pairs = 0; ///< A result lists at most this many pairs; 0: all.
    bool maps = false;             ///< The job has a contact map also at `level count`.
    bool first_hits = false;       ///< Of lines: only the first crossing of each.
};

/// What exports say about the job besides its results.
struct ExportContext {
    std::string job;
    std::string unit;
    Level level = Level::Pairs;
    std::vector<ExportBody> bodies; ///< A result names a body by its index here.
    ListedPairs listed;             ///< Which pairs results and maps have.
    bool exact_points = false;      ///< Arrays: also points at full precision, relative to origins.
    /// With a clearance, files also have what is known of near pairs.
    std::optional<double> clearance = std::nullopt;
    /// With the question of the distance, files also have the nearest points; with that of shots,
    /// the hits; with that of motions, what is proven of each.
    Question question = Question::Contacts;
    std::optional<double> up_to = std::nullopt; ///< Bodies farther apart have no distance.
    MotionTimes times;                          ///< Of motions.
    /// Of a scene, the steps of its scenarios; null for a job of two bodies.
    std::shared_ptr<const StepIndex> steps = nullptr;
    StopCheck stop; ///< Once it returns true, writing fails with Interrupted.

    /// Sets from the query what the context has of it.
    void describe(const Query& query);
    /// Returns the number of a result's bundle of lines in its step; nothing unless the job is a
    /// scene with lines.
    [[nodiscard]] std::optional<std::uint64_t> bundle_of(const ScenarioResult& result) const;
    [[nodiscard]] MapUse map_use() const { return {level, listed.maps, steps != nullptr}; }
    [[nodiscard]] bool has_distance() const { return question == Question::Distance; }
    [[nodiscard]] bool has_motions() const { return question == Question::Motion; }
    /// The contact map counts only so many first pairs of each scenario; 0: all pairs.
    [[nodiscard]] std::uint64_t map_pairs() const { return listed.maps ? 0 : listed.limit_pairs; }
    /// True if the results tell which of the scenarios of a contact map are contacts, and which are
    /// near only: their lists have all pairs that the map counts.
    [[nodiscard]] bool tells_contacts() const {
        return clearance && level >= Level::Pairs && (listed.limit_pairs == 0 || map_pairs() != 0);
    }
    /// True if results list the hits of lines.
    [[nodiscard]] bool has_hits() const {
        return question == Question::Shots && level >= Level::Pairs;
    }
};

/// The interface of the writers, one for each format. A writer buffers a bounded number of results.
class ResultWriter {
  public:
    ResultWriter() = default;
    ResultWriter(const ResultWriter&) = delete;
    ResultWriter& operator=(const ResultWriter&) = delete;
    /// Removes files that `finish` has not completed.
    virtual ~ResultWriter() = default;

    /// Adds the next result, in submitted order. Errors: Io naming the file.
    [[nodiscard]] virtual Status add(const ScenarioResult& result) = 0;
    /// Completes the files, which only then appear under their names.
    [[nodiscard]] virtual Status finish() = 0;
};

/// Writes results.txt for people: a line for each scenario, and after it one for each of its pairs.
[[nodiscard]] std::unique_ptr<ResultWriter> make_text_writer(const ExportContext& context,
                                                             OutputFile file);
/// Writes results.jsonl: a line with a JSON object for each scenario.
[[nodiscard]] std::unique_ptr<ResultWriter> make_json_writer(const ExportContext& context,
                                                             OutputFile file);
/// Writes scenarios.csv. Of a scene, the step, its time and the bodies are the first columns.
/// distance_bound is empty unless the class is undecided. With a clearance it has the column
/// near_count; with the question of shots the column hits, and of a scene then the column bundle;
/// with that of the distance columns of the nearest points, empty without a distance.
[[nodiscard]] std::unique_ptr<ResultWriter> make_scenarios_csv_writer(const ExportContext& context,
                                                                      OutputFile file);
/// Writes pairs.csv from `level pairs` on, and points.csv at `level contacts`; else no file.
[[nodiscard]] Result<std::unique_ptr<ResultWriter>>
make_pairs_csv_writer(const ExportContext& context, const std::filesystem::path& dir);
/// Writes results.npz or results.h5; docs/formats.md describes the arrays. `format` is one of
/// `array_formats`.
[[nodiscard]] std::unique_ptr<ResultWriter> make_array_writer(std::string_view format,
                                                              const ExportContext& context,
                                                              const std::filesystem::path& dir);

/// Writes contacts.vtp at `level contacts`, with a point for each shared point and a line for each
/// near pair; else no file.
/// docs/exports.md describes its arrays. Errors: Io naming the file.
[[nodiscard]] Result<std::unique_ptr<ResultWriter>>
make_vtp_writer(const ExportContext& context, const std::filesystem::path& dir);

/// A job's contact map, and what exports add to it.
struct ExportMap {
    const ContactMap& map;
    /// The scenarios in contact alone, without near ones; nothing without a clearance, or if they
    /// are unknown.
    std::optional<ContactMap> contacts = std::nullopt;
};

/// Writes NAME.vtp for each body: its mesh with the contact map, and the cell array `in_contact`
/// where contacts are known. `tested` is the number of scenarios of which the map's numbers are
/// shares. Errors: Io naming the file; Interrupted.
[[nodiscard]] Status write_vtp_bodies(const ExportMap& map,
                                      std::uint64_t tested,
                                      const std::filesystem::path& dir,
                                      const ExportContext& context);
/// Writes NAME.glb for each body: its mesh, coloured by the contact map. Parameters and errors as
/// `write_vtp_bodies`; BadInput for a mesh that a GLB file cannot hold.
[[nodiscard]] Status write_glb_bodies(const ContactMap& map,
                                      std::uint64_t tested,
                                      const std::filesystem::path& dir,
                                      const ExportContext& context);

/// Returns the name of a body's files, without an ending: the body's name, with `_` for what is
/// special in paths or XML, distinct for each body and from "contacts".
[[nodiscard]] std::string body_file_name(const std::vector<ExportBody>& bodies, std::size_t body);

/// Returns the name of the contact map's numbers in files: "scenarios", or
/// "scenarios_of_first_N_pairs" if the map counts only the first N pairs of each scenario.
[[nodiscard]] std::string map_column_name(const ExportContext& context);

/// Writes a job's contact map. Format csv gives map.csv with a row per triangle: the body's name,
/// triangle, scenarios, part. Format npz gives map.npz, and h5 map.h5, with an array (K,2) named
/// after each body: triangle, scenarios. Where contacts are known, a column in_contact follows
/// scenarios. If `formats` has neither, map.csv is written. Triangles ascend; a triangle that is
/// never in contact nor near has no row. If the map counts only the first N pairs of each scenario,
/// both files say so: the CSV's column is named scenarios_of_first_N_pairs, and the NPZ has an
/// array first_pairs that holds N. Errors: Io naming the file.
[[nodiscard]] Status write_map_files(const ExportMap& map,
                                     const std::filesystem::path& dir,
                                     const std::vector<std::string>& formats,
                                     const ExportContext& context);

/// Writes the report and the bodies to summary.json. Errors: Io naming the file.
[[nodiscard]] Status write_summary(const std::filesystem::path& dir,
                                   const ExportContext& context,
                                   const RunReport& report);

/// Returns the name of a pair's class in exports: touch, coplanar, proper or near.
[[nodiscard]] std::string_view pair_class_name(PairClass kind);

/// Calls `function(point)` for each shared point of a result's pair, in world coordinates.
template <class Function>
void for_each_point(const ScenarioResult& result, std::size_t pair, const Function& function) {
    if (result.point_offsets.size() <= pair + 1) {
        return;
    }
    for (std::uint32_t i = result.point_offsets[pair]; i < result.point_offsets[pair + 1]; ++i) {
        function(Vec3(result.point_origins[pair] + result.points[i]));
    }
}

/// Returns for each pair of a result at `level contacts` the distance of its triangles: 0 for pairs
/// in contact.
[[nodiscard]] std::vector<double> pair_distances(const ScenarioResult& result);

} // namespace cd
