// Exact contacts between triangle meshes in many rigid poses: the C++ interface of cdcluster.
//
// Every answer is exact for the numbers given, equal on every machine and for any number of
// threads, and has the digest that `cdctl run` prints for the same question. Errors are exceptions
// of type Error. Objects may be used by several threads at once unless their comment says
// otherwise. Threads live only inside a call, so that a process may fork before and after it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#define CDCLUSTER_API __attribute__((visibility("default")))

namespace cdcluster {

/// Returns the version of the library, such as "0.1.0".
[[nodiscard]] CDCLUSTER_API std::string_view version();

enum class ErrorCode : std::uint8_t {
    BadInput,    ///< An argument, file or field is invalid; `what` names it.
    NotFound,    ///< A file or folder does not exist.
    Io,          ///< The operating system failed a read or a write.
    TooLarge,    ///< A limit or the memory does not suffice.
    Interrupted, ///< `progress` returned false.
};

/// Why a call failed; `what` is one sentence with the cause, the place and the remedy.
class CDCLUSTER_API Error : public std::runtime_error {
  public:
    Error(ErrorCode code, const std::string& detail);
    ~Error() override;
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

  private:
    ErrorCode code_;
};

/// A named range of a mesh's triangles: [begin, end).
struct Part {
    std::string name;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// An immutable triangle mesh, cheap to copy. A mesh keeps its tree, which the first question
/// builds, and the memory of searches against the meshes that it met last.
class CDCLUSTER_API Mesh {
  public:
    /// Makes a mesh from 3 V coordinates x, y, z of V vertices and 3 T vertex numbers of T
    /// triangles. Triangles keep their order; degenerate ones are kept. Parts are ascending and do
    /// not overlap. Errors: BadInput naming the first bad vertex, triangle or part; TooLarge.
    [[nodiscard]] static Mesh from_arrays(std::span<const double> xyz,
                                          std::span<const std::uint32_t> triangles,
                                          std::span<const Part> parts = {});
    /// Reads STL, OBJ, PLY, OFF, glTF, NPZ and what assimp knows; coordinates are multiplied by
    /// `factor`. Errors: BadInput naming the file, and the line or byte; TooLarge.
    [[nodiscard]] static Mesh load(const std::filesystem::path& file, double factor = 1);
    /// Reads the bytes that `canonical_bytes` made. Errors: BadInput, TooLarge.
    [[nodiscard]] static Mesh from_canonical_bytes(std::span<const std::byte> bytes);

    Mesh(const Mesh&);
    Mesh(Mesh&&) noexcept;
    Mesh& operator=(const Mesh&);
    Mesh& operator=(Mesh&&) noexcept;
    ~Mesh();

    [[nodiscard]] std::size_t vertex_count() const;
    [[nodiscard]] std::size_t triangle_count() const;
    /// Returns the coordinates x, y, z of the vertices, one vertex behind the other.
    [[nodiscard]] std::span<const double> xyz() const;
    /// Returns three vertex numbers of each triangle.
    [[nodiscard]] std::span<const std::uint32_t> triangles() const;
    [[nodiscard]] std::vector<Part> parts() const;
    /// Returns the mesh's identity: the SHA-256 of `canonical_bytes`, in hexadecimal.
    [[nodiscard]] std::string sha256() const;
    /// Whether the surface is closed, so that a body can be inside of it.
    [[nodiscard]] bool is_closed() const;
    [[nodiscard]] std::vector<std::byte> canonical_bytes() const;

    struct State;
    /// For the library itself.
    [[nodiscard]] const std::shared_ptr<State>& state() const { return state_; }

  private:
    explicit Mesh(std::shared_ptr<State> state);

    std::shared_ptr<State> state_; ///< Null after a move.
};

/// The layout of the numbers of a pose. A pose maps B's coordinates into A's: x' = R x + t.
enum class PoseForm : std::uint8_t {
    Matrix44, ///< 16 numbers, row by row; the last row is 0 0 0 1.
    Matrix34, ///< 12 numbers, row by row: R and t.
    Xyzw,     ///< 7 numbers: t, then the quaternion qx qy qz qw.
    Wxyz,     ///< 7 numbers: t, then the quaternion qw qx qy qz.
};

/// Poses of B in A's frame, one behind the other; borrowed for the time of a call. Matrices must be
/// rigid within 1e-5 and quaternions of length 1 within 1e-3; all are used exactly as given.
struct Poses {
    std::span<const double> numbers;
    PoseForm form = PoseForm::Matrix44;
};

/// What is asked of each pose.
enum class Level : std::uint8_t {
    Any = 0,      ///< Whether the bodies are in contact.
    Count = 1,    ///< The class, and the number of pairs in contact.
    Pairs = 2,    ///< Each pair of triangles in contact, with its class.
    Contacts = 3, ///< Each pair, with the points that it shares.
    Distance = 4, ///< The distance of the bodies, and where they are nearest.
};

struct Progress {
    std::uint64_t done = 0; ///< Poses answered so far.
    std::uint64_t total = 0;
    double seconds = 0; ///< Since the search began.
};

/// Pairs of parts that are not tested: those of A whose names match `a` with parts of B whose names
/// match `b`. The patterns have a shell's wildcards * ? [].
struct IgnoreRule {
    std::string a;
    std::string b;
};

/// A question about many poses of two meshes, and how the call runs.
struct Query {
    Level level = Level::Pairs;
    std::uint64_t limit_pairs = 0; ///< Lists at most this many pairs of each pose; 0: all.
    bool maps = false; ///< Counts for each triangle the poses in which it is in contact or near.
    /// Pairs that share no point and are at most this far apart are near (`PairClass::Near`).
    std::optional<double> clearance = {};
    std::optional<double> up_to = {}; ///< Level::Distance: bodies farther apart get no distance.
    std::vector<IgnoreRule> ignore = {};
    unsigned threads = 0; ///< 0: one for each core that the process may use.
    /// Called some times a second by the calling thread; false ends the call with Interrupted.
    std::function<bool(const Progress&)> progress = {};
};

enum class ScenarioClass : std::uint8_t {
    Separate = 0,
    Touch = 1,   ///< The surfaces meet, and no triangle passes through another.
    Cross = 2,   ///< Triangles pass through each other.
    Inside = 3,  ///< One closed body lies inside the other; the surfaces do not meet.
    Contact = 4, ///< Level::Any and Level::Distance: touch or cross.
    Undecided = 5,
    Failed = 6, ///< `Results::failures` says why.
    Near = 7,   ///< No contact, but some pair is within the clearance.
};

enum class PairClass : std::uint8_t { Touch = 1, Coplanar = 2, Proper = 3, Near = 4 };

/// A triangle of A and one of B.
struct Pair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

using Point = std::array<double, 3>;

struct Failure {
    std::uint64_t scenario = 0;
    std::string reason;
};

/// What is known of a run of motions; times are in units of 2^-depth of the way between two keys.
struct Motions {
    std::vector<std::uint8_t> end; ///< 0 free, 1 contact, 2 contact at the start, 3 limit.
    std::vector<std::uint8_t> depth;
    std::vector<std::uint32_t> t0;          ///< The bodies are free until here, but for open runs.
    std::vector<std::uint32_t> t1;          ///< The contact is proven here.
    std::vector<std::uint64_t> run_offsets; ///< Motion i has the runs [offset i, offset i + 1).
    /// State (0 free, 1 open), first unit, units, first and last unit with the event.
    std::vector<std::array<std::uint32_t, 5>> runs;
};

/// The pairs of triangles of consecutive scenarios; empty below Level::Pairs.
struct PairArrays {
    std::vector<std::uint64_t> offsets; ///< Scenario i has the pairs [offsets[i], offsets[i + 1]).
    std::vector<Pair> pairs;            ///< Of each scenario, sorted.
    std::vector<PairClass> pair_class;
    /// Level::Contacts: pair j has the points [point_offsets[j], point_offsets[j + 1]), in the
    /// world (A's frame); of a near pair the nearest point of A and that of B.
    std::vector<std::uint64_t> point_offsets;
    std::vector<Point> points;
    std::vector<double> pair_distance; ///< Level::Contacts with a clearance; 0 in contact.
    /// Shot lines, which are triangles of B: depth, flags and rank of the hit of each pair.
    std::vector<double> hit_depth;
    std::vector<std::uint8_t> hit_flags;
    std::vector<std::uint8_t> hit_rank;
};

/// Level::Distance: where the bodies of consecutive scenarios are nearest.
struct NearestArrays {
    std::vector<double> distance; ///< Rounded once; NaN in contact and beyond `up_to`.
    std::vector<Pair> witness;    ///< The first pair that has this distance.
    std::vector<std::array<Point, 2>> witness_points; ///< Of A and of B; NaN without a distance.
};

/// The steps and bodies of a scene.
struct SceneArrays {
    std::vector<std::uint64_t> step;
    std::vector<std::uint64_t> bundle; ///< With shot lines: the number of the bundle in its step.
    std::vector<std::uint32_t> body_a; ///< An index of `body_names`.
    std::vector<std::uint32_t> body_b;
    std::vector<std::string> body_names; ///< Of all jobs: the names of the bodies.
};

/// The answers for consecutive scenarios, in arrays. A scenario is a pose; in a scene, a pair of
/// bodies at a step. Element i of an array is that of scenario `first` + i; arrays that the
/// question does not fill are empty.
struct Results : PairArrays, NearestArrays, SceneArrays {
    std::uint64_t first = 0;
    /// The scenario of each element, if some scenarios have no result; else empty.
    std::vector<std::uint64_t> index;
    std::vector<ScenarioClass> kind;
    std::vector<std::uint64_t> count;        ///< All pairs in contact, also those that a limit cut.
    std::vector<std::uint64_t> near_count;   ///< With a clearance.
    std::vector<std::uint8_t> surfaces_only; ///< 1: a body is open, so `Inside` is not decided.
    std::vector<Failure> failures;
    Motions motion;
    /// With maps, for each triangle of A and of B the scenarios in which it is in contact or near.
    /// Of all windows together.
    std::vector<std::uint64_t> map_a;
    std::vector<std::uint64_t> map_b;
    std::string digest; ///< SHA-256 over all results, as `cdctl run` prints it.

    [[nodiscard]] std::size_t size() const { return kind.size(); }
    /// Whether scenario i is in contact.
    [[nodiscard]] bool is_hit(std::size_t i) const {
        return kind[i] >= ScenarioClass::Touch && kind[i] <= ScenarioClass::Contact;
    }
};

/// Answers the query for each pose. Work of less than a millisecond starts no thread. Errors:
/// BadInput naming the row of a bad pose, or a pattern that matches no part; TooLarge; Interrupted.
[[nodiscard]] CDCLUSTER_API Results find_contacts(const Mesh& a,
                                                  const Mesh& b,
                                                  const Poses& poses,
                                                  const Query& query = {});

/// Does the same for any number of poses in bounded memory: passes the results of some thousands of
/// poses at a time to `each_window`, in order, on the calling thread. Returns what belongs to all
/// of them: the digest and the maps, in a Results without scenarios. Errors: as above.
CDCLUSTER_API Results find_contacts(const Mesh& a,
                                    const Mesh& b,
                                    const Poses& poses,
                                    const Query& query,
                                    const std::function<void(Results&&)>& each_window);

/// How a job runs and what it leaves.
struct RunOptions {
    unsigned threads = 0;                               ///< As in Query.
    std::function<bool(const Progress&)> progress = {}; ///< As in Query.
    /// Where results are kept as `cdctl run --out` keeps them; empty: the job's own folder, or
    /// none.
    std::filesystem::path out = {};
    std::filesystem::path tree_cache = {}; ///< A folder of trees to reuse; empty: none.
};

/// A job as `cdctl run` takes it: two bodies, scenes, motions or shot lines.
class CDCLUSTER_API Job {
  public:
    /// Reads the text of a job file; paths in it are relative to `folder`. Errors: BadInput naming
    /// the line and the key.
    [[nodiscard]] static Job from_toml(std::string_view text,
                                       const std::filesystem::path& folder = ".");
    /// Reads a job file. Errors: NotFound, Io; as from_toml.
    [[nodiscard]] static Job from_file(const std::filesystem::path& file);
    /// Takes the job of a results folder, with the inputs that the folder keeps. Errors: NotFound,
    /// Io; BadInput for a folder without a finished run.
    [[nodiscard]] static Job from_folder(const std::filesystem::path& folder);

    Job(const Job&);
    Job(Job&&) noexcept;
    Job& operator=(const Job&);
    Job& operator=(Job&&) noexcept;
    ~Job();

    [[nodiscard]] std::string name() const;

    struct State;
    /// For the library itself.
    [[nodiscard]] const std::shared_ptr<const State>& state() const { return state_; }

  private:
    explicit Job(std::shared_ptr<const State> state);

    std::shared_ptr<const State> state_; ///< Null after a move.
};

/// Runs a job in this process. Errors: as find_contacts; NotFound and Io for the job's files;
/// BadInput if `out` holds another run.
[[nodiscard]] CDCLUSTER_API Results run(const Job& job, const RunOptions& options = {});
/// Does the same in bounded memory, as the second form of find_contacts.
CDCLUSTER_API Results run(const Job& job,
                          const RunOptions& options,
                          const std::function<void(Results&&)>& each_window);

/// Reads the results of a finished run from its folder. Errors: NotFound, Io, BadInput.
[[nodiscard]] CDCLUSTER_API Results open(const std::filesystem::path& folder);

} // namespace cdcluster
