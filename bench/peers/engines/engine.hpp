// A common interface of the compared engines: pairs of triangles, and pairs of whole meshes.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/job/query.hpp"
#include "common/pair/triangle_pair.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

/// Candidates by their positions in the leaves of wide trees.
struct BlockCandidates {
    TriangleBlocks a;
    TriangleBlocks b;
    std::span<const Candidate> candidates;
};

/// Candidates under one pair of poses. A view: its maker keeps the triangles.
struct PairGroup {
    PosePair poses;
    TriangleSpan a;
    TriangleSpan b;
    std::span<const Candidate> candidates;
    /// These candidates, in order, in our wide trees; empty without wide trees.
    BlockCandidates in_blocks{};
};

/// Points of a pair's intersection: `origin` plus each of `points`, in the world.
struct SharedPoints {
    Vec3 origin = Vec3::Zero();
    std::vector<Vec3> points;
};

/// Decides pairs of triangles, in two steps so that only the second is timed.
class PairEngine {
  public:
    PairEngine() = default;
    PairEngine(const PairEngine&) = delete;
    PairEngine& operator=(const PairEngine&) = delete;
    virtual ~PairEngine() = default;

    /// Does the setup that is not timed. The groups must outlive the decision.
    virtual void prepare(std::span<const PairGroup> groups) = 0;

    /// Writes an answer for each candidate of the prepared groups, in order: a PairClass if
    /// `tells_class`, else 0 for apart and 1 for contact.
    virtual void decide(std::span<std::uint8_t> answers) = 0;

    [[nodiscard]] virtual bool tells_class() const { return false; }
    [[nodiscard]] virtual bool gives_points() const { return false; }
    /// Returns one candidate's shared points; empty if the engine sees no contact.
    [[nodiscard]] virtual SharedPoints shared_points(const PairGroup&, const Candidate&) {
        return {};
    }
};

using IdPair = std::pair<std::uint32_t, std::uint32_t>;

struct MeshAnswer {
    bool touches = false;
    std::uint64_t pair_count = 0;
    std::vector<IdPair> pairs; ///< At level pairs and above; unordered, may repeat.
};

/// Decides whole meshes.
class MeshEngine {
  public:
    MeshEngine() = default;
    MeshEngine(const MeshEngine&) = delete;
    MeshEngine& operator=(const MeshEngine&) = delete;
    virtual ~MeshEngine() = default;

    /// Builds everything that is built once for two bodies.
    virtual void load(const std::shared_ptr<const Mesh>& a,
                      const std::shared_ptr<const Mesh>& b) = 0;
    [[nodiscard]] virtual MeshAnswer ask(const PosePair& poses, Level level) = 0;

    /// Returns the loaded bytes that a query may read; 0 if unknown.
    [[nodiscard]] virtual std::uint64_t resident_bytes() const { return 0; }
    /// Returns an engine for another thread on this one's data; null if unsupported.
    [[nodiscard]] virtual std::unique_ptr<MeshEngine> for_another_thread() const { return nullptr; }
};

/// An engine with one setting. Unsupported functions are empty.
struct Engine {
    std::string name;
    bool is_ours = false;
    std::function<std::unique_ptr<PairEngine>()> make_pairs;
    std::function<std::unique_ptr<MeshEngine>()> make_meshes;
    std::vector<Level> levels; ///< Levels that `make_meshes` supports.
};

/// A triangle of a body transformed to the world in doubles: the input of every other engine.
struct WorldFrame {
    Mat3 rotation;
    Vec3 translation;

    explicit WorldFrame(const Pose& pose)
        : rotation(pose.rotation()), translation(pose.translation()) {}

    [[nodiscard]] Corners operator()(const Corners& t) const {
        return {Vec3(rotation * t[0] + translation),
                Vec3(rotation * t[1] + translation),
                Vec3(rotation * t[2] + translation)};
    }
};

/// Wraps a test of two world triangles as an engine. `Test` provides `bool touches(a, b)`, and
/// optionally `std::vector<Vec3> points(a, b)`.
template <class Test>
class WorldPairEngine final : public PairEngine {
  public:
    template <class... Arguments>
    explicit WorldPairEngine(Arguments... arguments) : test_(arguments...) {}

    void prepare(std::span<const PairGroup> groups) override {
        groups_ = groups;
        frames_.clear();
        for (const PairGroup& group : groups) {
            frames_.emplace_back(WorldFrame(group.poses.a), WorldFrame(group.poses.b));
        }
    }

    void decide(std::span<std::uint8_t> answers) override {
        std::size_t next = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const PairGroup& group = groups_[g];
            const auto& [to_world_a, to_world_b] = frames_[g];
            for (const Candidate& c : group.candidates) {
                answers[next++] = test_.touches(to_world_a(group.a.corners_at(c.a)),
                                                to_world_b(group.b.corners_at(c.b)))
                                      ? 1
                                      : 0;
            }
        }
    }

    [[nodiscard]] bool gives_points() const override {
        return requires(Test test, Corners t) {
            test.points(t, t);
        };
    }

    [[nodiscard]] SharedPoints shared_points(const PairGroup& group, const Candidate& c) override {
        if constexpr (requires(Test test, Corners t) { test.points(t, t); }) {
            return {Vec3::Zero(),
                    test_.points(WorldFrame(group.poses.a)(group.a.corners_at(c.a)),
                                 WorldFrame(group.poses.b)(group.b.corners_at(c.b)))};
        } else {
            return {};
        }
    }

  private:
    Test test_;
    std::span<const PairGroup> groups_;
    std::vector<std::pair<WorldFrame, WorldFrame>> frames_;
};

} // namespace cd::bench
