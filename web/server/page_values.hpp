// What the page shows, as values that each source provides.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Where the page's data come from.
struct PageOrigin {
    enum class Kind : std::uint8_t { Master, Folder, Remote };

    Kind kind = Kind::Folder;
    std::string program; ///< "cdctl 0.1.0"
    std::string name;    ///< Name of the host or path of the folder.
    bool is_tls = false;
    std::string job; ///< The only job that the page shows; empty: the cluster.
};

/// A cluster's status now, and a moment before, for rates.
struct ClusterView {
    ClusterStatus before;
    ClusterStatus now;
};

/// A sample of a cluster's activity. Rates are per second, of scenarios or bytes.
struct HistorySample {
    double unix_seconds = 0;
    double scenarios = 0;
    double sent = 0;
    double received = 0;
    double from_peers = 0;
};

/// A job in a list. `id` and `state` replace those of the status unless they are empty.
struct JobRow {
    std::string id;
    std::string state;
    JobStatus status;
};

struct BodyView {
    JobBody body;
    std::uint64_t triangles = 0;
    std::uint64_t parts = 0;
    std::optional<bool> is_closed = std::nullopt; ///< Nothing if unknown.
    std::uint64_t bytes = 0;                      ///< Size of the canonical form.
    Precision precision = Precision::Double;
    Vec3 size = Vec3::Zero(); ///< Size of the box around the mesh, in its own axes.
    Vec3 low = Vec3::Zero();  ///< The corner of that box with the least coordinates.
};

struct PosesView {
    PosesKind kind = PosesKind::File;
    std::uint64_t count = 0;
    std::string file;
    /// Of a grid x, y, z, roll, pitch, yaw; of a grid of lines azimuth and elevation. Angles are in
    /// degrees. Empty for other poses.
    std::vector<GridAxis> axes;
    std::optional<RandomPoses> random;
    bool has_ids = false;
    bool has_times = false;
    bool of_both_bodies = false;
};

/// Whether a job has a contact map.
struct MapView {
    bool exists = false;
    std::uint64_t first_pairs = 0; ///< The map counts only so many pairs a scenario; 0: all.
};

/// The run that gave the results. What is unknown is empty.
struct RunView {
    std::string where; ///< "2 threads", "12 workers"
    std::string simd;
    std::string command;
    std::string program;
    std::string commit;
    std::string started;
    std::string ended;
    std::vector<std::string> formats;
    std::string folder;
};

/// Scenarios in which two parts are in contact or near.
struct GroupView {
    std::string part_a;
    std::string part_b;
    std::uint64_t scenarios = 0;
    double share = 0; ///< Of the tested scenarios.
    std::uint64_t pairs = 0;
    std::uint64_t worst = 0;       ///< The worst scenario of the two parts.
    std::uint64_t worst_pairs = 0; ///< Pairs in contact in it.
    /// Cross, Touch, Contact if it is unknown which, or Near.
    ScenarioClass worst_class = ScenarioClass::Touch;
    std::uint64_t near = 0;       ///< Near pairs in all scenarios.
    std::uint64_t worst_near = 0; ///< Near pairs in the worst scenario.
};

struct GroupsView {
    std::vector<GroupView> rows; ///< Most scenarios first; perhaps not all.
    std::uint64_t total = 0;
};

struct JobView {
    JobRow row;
    std::string unit;
    Query query;
    std::vector<BodyView> bodies;
    PosesView poses;
    MapView map;
    RunView run;
    std::optional<GroupsView> groups;                  ///< Nothing if unknown.
    std::optional<std::uint64_t> steps = std::nullopt; ///< Number of the steps of a scene.
};

/// Where a scenario of a scene belongs: its step, and the numbers of its two bodies.
struct ScenePlace {
    std::uint64_t step = 0;
    std::uint32_t body_a = 0;
    std::uint32_t body_b = 1;

    friend bool operator==(const ScenePlace&, const ScenePlace&) = default;
};

/// A step of a scene.
struct StepRow {
    std::uint64_t first = 0; ///< Its first scenario; without one, that of the next step.
    double time = 0;

    friend bool operator==(const StepRow&, const StepRow&) = default;
};

/// Poses for drawing, rounded: for each scenario the rows of [R t], 12 numbers. One pose a
/// scenario, B's in A's frame; or two, A's and B's in the world.
struct PoseRows {
    std::size_t poses_each = 1;
    std::vector<double> numbers;

    void add(const PosePair& poses);
};

/// The poses at a motion's begin and end.
struct MotionKeys {
    PosePair from;
    PosePair to;
};

/// One scenario: its record, and what running it again gave.
struct ScenarioView {
    /// The stored result without its lists; nothing if there is none yet.
    std::optional<ScenarioResult> result;
    std::uint64_t listed = 0;       ///< Pairs that the stored result lists.
    PosePair poses;                 ///< Of a motion at its event, or at its begin.
    std::optional<MotionKeys> keys; ///< Of a motion.
    std::string id;                 ///< The pose file's id; empty without one.
    std::optional<double> time;
    std::optional<ScenePlace> scene; ///< Of a scene.
    std::optional<bool> verified; ///< Whether a second run gave equal bytes; nothing: not compared.
    std::string verify_note;      ///< Why it was not compared, or what differs.
    /// Pairs and points of an exact run at level contacts, perhaps not all; of a motion those at
    /// its event. Null if it failed.
    std::shared_ptr<const ScenarioResult> drawn;
    std::string draw_note; ///< Why nothing is drawn; empty if `drawn` is set.
};

/// What a search for the next scenario in contact gave.
struct NextFound {
    std::optional<std::uint64_t> scenario;
    /// The last scenario looked at, from which the search can go on; nothing if it found one or
    /// reached the end of the job.
    std::optional<std::uint64_t> searched_to;
};

/// Returns the twelve numbers of a pose: the rows of [R t], rounded.
[[nodiscard]] std::array<double, 12> pose_rows(const Pose& pose);

/// Returns the numbers of a motion's key, exactly: quaternion w, x, y, z, and position. The pose is
/// of kind Quaternion.
[[nodiscard]] std::array<double, 7> key_numbers(const Pose& pose);

} // namespace cd
