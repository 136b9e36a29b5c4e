#include "client/folder/extracted_case.hpp"

#include "client/formats/csv_rows.hpp"
#include "client/formats/npz.hpp"
#include "client/job/job_text.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "web/status/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> body_names{"a", "b"};
constexpr const char* ids_name = "ids.csv";

/// A body of the case. `ids[i]` is the number that triangle i of `mesh` has in the run; `ids` is
/// empty if the case has the run's whole mesh.
struct CaseBody {
    std::shared_ptr<const Mesh> mesh;
    std::vector<std::uint32_t> ids;
};

Status write_mesh(const fs::path& path, const Mesh& mesh, const StopCheck& stop) {
    NpzWriter file(path, stop);
    const std::size_t vertices = file.add_array({"vertices", NpyType::F8, 3});
    const std::size_t faces = file.add_array({"faces", NpyType::U4, 3});
    for (const Vec3& vertex : mesh.vertices()) {
        CD_TRY(file.append(vertices, std::span<const double>(vertex.data(), 3)));
    }
    for (const Triangle& triangle : mesh.triangles()) {
        CD_TRY(file.append(faces, std::span<const std::uint32_t>(triangle)));
    }
    if (mesh.parts().empty()) {
        return file.finish();
    }
    const std::size_t parts = file.add_array({"parts", NpyType::U4, 3});
    const std::size_t names = file.add_array({"part_names", NpyType::U1});
    for (const Part& part : mesh.parts()) {
        const std::array<std::uint32_t, 3> row{
            part.triangles_begin, part.triangles_end, static_cast<std::uint32_t>(part.name.size())};
        CD_TRY(file.append(parts, std::span<const std::uint32_t>(row)));
        CD_TRY(file.append(names, std::span<const char>(part.name)));
    }
    return file.finish();
}

// ---- Poses --------------------------------------------------------------------------------------

/// The layout of poses.csv: poses of one body or both, all as quaternions or all as matrices.
struct PoseColumns {
    bool of_both_bodies = false;
    Pose::Kind kind = Pose::Kind::Matrix;
};

Result<PoseColumns> columns_for(const std::vector<Scenario>& scenarios) {
    PoseColumns columns;
    columns.kind = scenarios.front().poses.b.kind();
    columns.of_both_bodies = std::ranges::any_of(
        scenarios, [](const Scenario& scenario) { return scenario.poses.a != Pose(); });
    for (const Scenario& scenario : scenarios) {
        const bool fits = scenario.poses.b.kind() == columns.kind &&
                          (!columns.of_both_bodies || scenario.poses.a.kind() == columns.kind);
        if (!fits) {
            return bad_input(
                "the poses of these scenarios are quaternions and matrices mixed, which "
                "one pose file cannot hold; extract them one by one");
        }
    }
    return columns;
}

std::string pose_text(const Pose& pose) {
    const Vec3& t = pose.translation();
    std::vector<double> numbers;
    if (pose.kind() == Pose::Kind::Quaternion) {
        const Quaternion& q = pose.quaternion();
        numbers = {t.x(), t.y(), t.z(), q.x, q.y, q.z, q.w};
    } else {
        const Mat3& m = pose.matrix();
        for (int row = 0; row < 3; ++row) {
            numbers.insert(numbers.end(), {m(row, 0), m(row, 1), m(row, 2), t[row]});
        }
    }
    return fmt::format("{:.17g}", fmt::join(numbers, ","));
}

std::string poses_text(const std::vector<Scenario>& scenarios, const PoseColumns& columns) {
    std::string text = columns.of_both_bodies ? "scenario,body," : "";
    text += columns.kind == Pose::Kind::Quaternion
                ? "x,y,z,qx,qy,qz,qw\n"
                : "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n";
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const std::string number = std::to_string(i);
        if (columns.of_both_bodies) {
            text += number + ",a," + pose_text(scenarios[i].poses.a) + "\n" + number + ",b,";
        }
        text += pose_text(scenarios[i].poses.b) + "\n";
    }
    return text;
}

// ---- The smallest meshes ------------------------------------------------------------------------

/// Returns a box in world coordinates that surely contains all points at most `reach` from the
/// given points after `pose`.
Aabb posed_box(std::span<const Vec3> points, const Pose& pose, double reach = 0) {
    Aabb box;
    for (const Vec3& point : points) {
        box.add(pose.apply(point));
    }
    // The margin is far above the rounding error of `apply`. A box that is too large is harmless:
    // the case then keeps triangles that it does not need.
    const double rounding = 1e-9 * (box.min.cwiseAbs().maxCoeff() + box.max.cwiseAbs().maxCoeff());
    const double margin = rounding + (1 + 1e-9) * reach;
    box.min.array() -= margin;
    box.max.array() += margin;
    return box;
}

/// Returns the parts of the mesh that remains if only the triangles `kept` (ascending) are kept.
/// Parts without a kept triangle are left out.
std::vector<Part> remaining_parts(const Mesh& mesh, const std::vector<std::uint32_t>& kept) {
    const auto place = [&](std::uint32_t id) {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(kept, id) - kept.begin());
    };
    std::vector<Part> parts;
    for (const Part& part : mesh.parts()) {
        const Part remaining{part.name, place(part.triangles_begin), place(part.triangles_end)};
        if (remaining.triangles_begin < remaining.triangles_end) {
            parts.push_back(remaining);
        }
    }
    return parts;
}

/// Makes a mesh of the triangles of `mesh` whose boxes are at most `reach` from the box of `other`
/// at one or more of the poses. `name` is "a" or "b", for errors.
Result<CaseBody> part_that_meets(const Mesh& mesh,
                                 const Mesh& other,
                                 const std::vector<PosePair>& poses, // `a` is the pose of `mesh`.
                                 double reach,
                                 const char* name,
                                 const StopCheck& stop) {
    CaseBody body;
    std::vector<Aabb> boxes;
    for (const PosePair& pose : poses) {
        boxes.push_back(posed_box(other.vertices(), pose.b, reach));
    }
    MeshArrays arrays;
    std::vector<std::uint32_t> vertex_ids(mesh.vertices().size(), UINT32_MAX);
    for (std::uint32_t id = 0; id < mesh.triangles().size(); ++id) {
        if (stop && stop()) {
            return interrupted();
        }
        const Corners corners = mesh.corners(id);
        const bool meets = std::ranges::any_of(poses, [&](const PosePair& pose) {
            const auto scenario = static_cast<std::size_t>(&pose - poses.data());
            return !are_apart(posed_box(corners, pose.a), boxes[scenario]);
        });
        if (!meets) {
            continue;
        }
        body.ids.push_back(id);
        Triangle triangle = mesh.triangles()[id];
        for (std::uint32_t& vertex : triangle) {
            if (vertex_ids[vertex] == UINT32_MAX) {
                vertex_ids[vertex] = static_cast<std::uint32_t>(arrays.vertices.size());
                arrays.vertices.push_back(mesh.vertices()[vertex]);
            }
            vertex = vertex_ids[vertex];
        }
        arrays.triangles.push_back(triangle);
    }
    if (body.ids.empty()) {
        return bad_input(std::string("no triangle of ") + name +
                         " comes near the other body there: without --minimal the case has all");
    }
    arrays.precision = mesh.precision();
    arrays.parts = remaining_parts(mesh, body.ids);
    body.mesh = std::make_shared<const Mesh>(CD_TRY(Mesh::create(std::move(arrays))));
    return body;
}

/// Returns how far apart the triangles may be that the scenarios' results depend on.
double reach_of(const Query& query, std::span<const ScenarioResult> results) {
    double reach = query.clearance.value_or(0);
    if (query.question == Question::Distance) {
        for (const ScenarioResult& result : results) {
            const double known = result.nearest ? result.nearest->distance : 0;
            reach = std::max({reach, known, query.up_to.value_or(0)});
        }
    }
    return reach;
}

Result<std::array<CaseBody, 2>>
smallest_bodies(const PreparedJob& job, const CaseScenarios& given, const StopCheck& stop) {
    std::vector<PosePair> poses;
    std::vector<PosePair> swapped;
    for (const Scenario& scenario : given.scenarios) {
        poses.push_back(scenario.poses);
        swapped.push_back({scenario.poses.b, scenario.poses.a});
    }
    const double reach = reach_of(job.query, given.results);
    auto a = CD_TRY(part_that_meets(*job.meshes[0], *job.meshes[1], poses, reach, "a", stop));
    auto b = CD_TRY(part_that_meets(*job.meshes[1], *job.meshes[0], swapped, reach, "b", stop));
    return std::array<CaseBody, 2>{std::move(a), std::move(b)};
}

/// Gives a result of the smallest meshes the run's numbers of triangles.
void number_as_in_run(const std::array<CaseBody, 2>& bodies, ScenarioResult& result) {
    for (ContactPair& pair : result.pairs) {
        pair.a = bodies[0].ids[pair.a];
        pair.b = bodies[1].ids[pair.b];
    }
    if (result.nearest) {
        result.nearest->a = bodies[0].ids[result.nearest->a];
        result.nearest->b = bodies[1].ids[result.nearest->b];
    }
}

/// Checks that the smallest meshes give the run's result. `smallest` has the run's numbers of
/// triangles. Errors: BadInput if a result differs.
Status check_smallest(const ScenarioResult& smallest, const ScenarioResult& of_run) {
    const std::string name = "scenario " + std::to_string(of_run.index);
    if (smallest.pair_count != of_run.pair_count || smallest.near_count != of_run.near_count ||
        smallest.pairs != of_run.pairs || smallest.nearest != of_run.nearest) {
        return bad_input("the smallest meshes of " + name +
                         " do not have the run's pairs; `cdctl verify` tells whether the run is "
                         "right");
    }
    const bool insides_matter =
        of_run.kind == ScenarioClass::Separate || of_run.kind == ScenarioClass::Touch;
    const bool says_more = of_run.surfaces_only && !smallest.surfaces_only && insides_matter;
    if (smallest.kind != of_run.kind || says_more) {
        const auto class_text = [](const ScenarioResult& result) {
            return std::string(to_text(result.kind)) +
                   (result.surfaces_only ? " (surfaces only)" : "");
        };
        return bad_input(name + " is " + class_text(of_run) + ", and its smallest meshes are " +
                         class_text(smallest) +
                         ": the class depends on more triangles; without --minimal the case has "
                         "all");
    }
    return Done{};
}

/// Runs the scenarios with the smallest meshes. Errors: BadInput if a result differs from the
/// run's; Interrupted.
Result<std::vector<ScenarioResult>> run_smallest(const PreparedJob& job,
                                                 const CaseScenarios& given,
                                                 const std::array<CaseBody, 2>& bodies,
                                                 const std::vector<IgnoredRange>& ignored,
                                                 const StopCheck& stop,
                                                 ThreadPool& pool) {
    const ObbTree a = build_tree(bodies[0].mesh, {}, pool);
    const ObbTree b = build_tree(bodies[1].mesh, {}, pool);
    Query query = job.query;
    query.ignored = ignored;
    const ScenarioRunner runner(a, b, query, PairStage::Float, stop);
    std::vector<ScenarioResult> results;
    for (std::size_t i = 0; i < given.scenarios.size(); ++i) {
        ScenarioRun run = runner.run(given.scenarios[i]);
        if (run.is_stopped) {
            return interrupted();
        }
        ScenarioResult as_in_run = run.result;
        number_as_in_run(bodies, as_in_run);
        CD_TRY(check_smallest(as_in_run, given.results[i]));
        results.push_back(std::move(run.result));
    }
    return results;
}

Status write_ids(const fs::path& path, const std::array<CaseBody, 2>& bodies) {
    auto file = CD_TRY(RowFile::create(path, "body,triangle,triangle_in_run\n"));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t id = 0; id < bodies[i].ids.size(); ++id) {
            CD_TRY(
                file.add(std::string_view(body_names[i]), ",", id, ",", bodies[i].ids[id], "\n"));
        }
    }
    return file.commit();
}

// ---- The job and its expected results -----------------------------------------------------------

/// The ignore rules for a case's meshes, and the triangle ranges that they exclude.
struct CaseRules {
    std::vector<IgnoreRule> rules;
    std::vector<IgnoredRange> ignored;
};

/// Keeps the job's ignore rules that match a part of each of the case's meshes.
CaseRules rules_for(const PreparedJob& job, const std::array<CaseBody, 2>& bodies) {
    CaseRules found;
    JobSpec spec = job.spec;
    for (const IgnoreRule& rule : job.spec.ignore) {
        spec.ignore = {rule};
        const auto ignored = resolve_ignored(spec, *bodies[0].mesh, *bodies[1].mesh);
        if (ignored) {
            found.rules.push_back(rule);
            found.ignored.insert(
                found.ignored.end(), ignored.value().begin(), ignored.value().end());
        }
    }
    return found;
}

std::string case_job_text(const PreparedJob& job,
                          const CaseScenarios& given,
                          const PoseColumns& columns,
                          const std::vector<IgnoreRule>& rules) {
    JobSpec spec;
    spec.name = job.spec.name + " scenario " + std::to_string(given.results.front().index);
    if (given.results.size() > 1) {
        spec.name += " to " + std::to_string(given.results.back().index);
    }
    spec.unit = job.spec.unit;
    const auto files = body_file_names(job);
    for (std::size_t i = 0; i < files.size(); ++i) {
        spec.bodies[i].path = files[i] + ".npz";
        spec.bodies[i].name = job.spec.bodies[i].name;
    }
    constexpr double rigid_tolerance = 1e300; // No pose exceeds it: the run accepted these poses.
    spec.poses = PoseFileSpec{"poses.csv", "", columns.of_both_bodies, rigid_tolerance};
    spec.query = job.query;
    spec.query.ignored.clear();
    spec.ignore = rules;
    return job_text(spec);
}

std::string expected_text(std::vector<ScenarioResult> results) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    ResultMerger merger(results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::uint64_t index_in_run = results[i].index;
        results[i].index = i;
        static_cast<void>(merger.add(results[i]));
        list.push_back({{"scenario", i},
                        {"scenario_in_run", index_in_run},
                        {"class", to_text(results[i].kind)},
                        {"count", results[i].pair_count},
                        {"record_sha256", to_hex(sha256(encode_result(results[i])))}});
        if (results[i].has_clearance) {
            list.back()["near_count"] = results[i].near_count;
        }
        if (results[i].nearest) {
            list.back()["distance"] = results[i].nearest->distance;
        }
    }
    const nlohmann::ordered_json json{{"digest", to_hex(*merger.digest())},
                                      {"scenarios", std::move(list)}};
    return json_text(json, 1);
}

Status check_expressible(const PreparedJob& job, const CaseScenarios& given) {
    if (job.query.question == Question::Shots) {
        return bad_input("a case has poses of two bodies, and this run has lines: write a job with "
                         "one direction of [shots], or draw the scenarios with --as vtp or glb");
    }
    CD_CHECK(!job.query.motion); // See `rest_at_answers`.
    for (const ScenarioResult& result : given.results) {
        if (result.kind == ScenarioClass::Failed) {
            // A failure's text contains the number of its scenario, which a case would
            // change.
            return bad_input(result.failure +
                             ": a scenario that failed has no answer for a case to "
                             "give again");
        }
    }
    const auto ignored = resolve_ignored(job.spec, *job.meshes[0], *job.meshes[1]);
    if (!ignored || ignored.value() != job.query.ignored) {
        return bad_input(
            "the run has no ignore rules that name the parts it passed over: run the job "
            "again into another folder, and extract from there");
    }
    return Done{};
}

/// Refuses a folder whose job.toml was not written by `write_case`.
Status check_target(const fs::path& dir) {
    std::error_code error;
    if (fs::exists(dir / "job.toml", error) && !fs::exists(dir / "expected.json", error)) {
        return bad_input((dir / "job.toml").string() +
                         " is of no case, and would be overwritten; give another folder with "
                         "--out");
    }
    return Done{};
}

Status write_files(const PreparedJob& job,
                   const CaseScenarios& given,
                   const std::array<CaseBody, 2>& bodies,
                   const std::vector<ScenarioResult>& expected,
                   const std::vector<IgnoreRule>& rules,
                   const StopCheck& stop,
                   const fs::path& dir) {
    const auto columns = CD_TRY(columns_for(given.scenarios));
    CD_TRY(make_directories(dir));
    std::error_code error;
    // Removes the files of an earlier case, so that none is left if writing fails. `check_target`
    // takes a job.toml beside expected.json for a case's, so job.toml is removed first and written
    // last.
    for (const char* name : {"job.toml", "expected.json", ids_name}) {
        fs::remove(dir / name, error);
    }
    const auto files = body_file_names(job);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        CD_TRY(write_mesh(dir / (files[i] + ".npz"), *bodies[i].mesh, stop));
    }
    for (const auto& [name, text] :
         {std::pair("poses.csv", poses_text(given.scenarios, columns)),
          std::pair("expected.json", expected_text(expected)),
          std::pair("job.toml", case_job_text(job, given, columns, rules))}) {
        CD_TRY(write_file(dir / name, text));
    }
    return Done{};
}

} // namespace

Status write_case(const PreparedJob& job,
                  const CaseScenarios& scenarios,
                  const CaseOptions& options,
                  const fs::path& dir,
                  ThreadPool& pool) {
    CD_TRY(check_expressible(job, scenarios));
    CD_TRY(check_target(dir));
    std::array<CaseBody, 2> bodies{CaseBody{job.meshes[0], {}}, CaseBody{job.meshes[1], {}}};
    std::vector<ScenarioResult> expected = scenarios.results;
    CaseRules rules{job.spec.ignore, job.query.ignored};
    if (options.minimal) {
        bodies = CD_TRY(smallest_bodies(job, scenarios, options.stop));
        rules = rules_for(job, bodies);
        expected = CD_TRY(run_smallest(job, scenarios, bodies, rules.ignored, options.stop, pool));
    }
    CD_TRY(write_files(job, scenarios, bodies, expected, rules.rules, options.stop, dir));
    return options.minimal ? write_ids(dir / ids_name, bodies) : Status(Done{});
}

} // namespace cd
