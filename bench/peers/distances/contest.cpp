#include "bench/peers/distances/contest.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/turns.hpp"
#include "tests/support/distance_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace cd::bench {

namespace {

enum Turn : std::uint32_t { Load, Check, Each };

/// Drives one engine in a process of its own.
class Lane {
  public:
    Lane(const Scene& scene, const DistanceEngine& engine, const DistanceContestOptions& options)
        : options_(options),
          seconds_(scene.poses.size()),
          found_(scene.poses.size()),
          child_(options.cpu, [this, &scene, meshes = meshes_of(engine)](std::uint32_t turn) {
              take(scene, *meshes, static_cast<Turn>(turn));
          }) {}

    void take_turn(Turn turn) {
        outcome_.ending = child_.take_turn(turn, options_.limit);
        if (turn == Each && outcome_.ending == Ending::Done) {
            const auto seconds = seconds_.values();
            rounds_.emplace_back(seconds.begin(), seconds.end());
        }
    }

    [[nodiscard]] DistanceOutcome outcome() {
        if (outcome_.ending != Ending::Done) {
            return outcome_;
        }
        for (std::size_t p = 0; p < seconds_.values().size(); ++p) {
            std::vector<double> seconds;
            for (const std::vector<double>& round : rounds_) {
                seconds.push_back(round[p]);
            }
            outcome_.pose_seconds.push_back(median(seconds));
        }
        const auto found = found_.values();
        outcome_.found.assign(found.begin(), found.end());
        return outcome_;
    }

  private:
    static std::shared_ptr<DistanceMeshes> meshes_of(const DistanceEngine& engine) {
        return engine.make_meshes();
    }

    void take(const Scene& scene, DistanceMeshes& meshes, Turn turn) {
        if (turn == Load) {
            meshes.load(scene.a, scene.b);
            return;
        }
        for (std::size_t p = 0; p < scene.poses.size(); ++p) {
            seconds_[p] = seconds_of([&] { found_[p] = meshes.distance(scene.poses[p]); });
        }
    }

    const DistanceContestOptions& options_;
    SharedArray<double> seconds_;
    SharedArray<MeshDistance> found_;
    std::vector<std::vector<double>> rounds_;
    DistanceOutcome outcome_;
    TurnTaker child_;
};

double distance_of(const Scene& scene, std::size_t pose, const MeshDistance& pair) {
    return tests::DistanceOracle(
               scene.a->corners(pair.a), scene.b->corners(pair.b), scene.poses[pose])
        .rounded();
}

/// Whether the triangles that an engine names are nearer to each other than ours says of the
/// bodies, or, of ours, not as far apart as it says.
bool contradicts_ours(
    const Scene& scene, std::size_t pose, const MeshDistance& named, double ours, bool is_ours) {
    const bool names_a_pair = named.distance > 0 && named.a < scene.a->triangles().size() &&
                              named.b < scene.b->triangles().size();
    if (!names_a_pair) {
        return false;
    }
    const double distance = distance_of(scene, pose, named);
    return is_ours ? distance != ours : distance < ours;
}

double largest_coordinate(const Mesh& mesh, const Pose& pose) {
    double largest = 0;
    for (const Vec3& vertex : mesh.vertices()) {
        largest = std::max(largest, pose.apply(vertex).cwiseAbs().maxCoeff());
    }
    return largest;
}

void judge(const Scene& scene,
           const DistanceOutcome& ours,
           bool is_ours,
           DistanceOutcome& outcome) {
    for (std::size_t p = 0; p < outcome.found.size(); ++p) {
        const double coordinate = std::max(largest_coordinate(*scene.a, scene.poses[p].a),
                                           largest_coordinate(*scene.b, scene.poses[p].b));
        const double truth = ours.found[p].distance;
        (truth == 0 ? outcome.in_contact : outcome.apart)
            .add(std::max(outcome.found[p].distance, 0.0), truth, coordinate);
        outcome.ours_wrong +=
            contradicts_ours(scene, p, outcome.found[p], truth, is_ours) ? 1u : 0u;
    }
}

} // namespace

void DistanceErrors::add(double theirs, double truth, double coordinate) {
    const double error = std::abs(theirs - truth);
    unequal += theirs != truth ? 1u : 0u;
    off += !(error <= 1e-12 * coordinate) ? 1u : 0u;
    wrong += !(error <= 0.01 * truth) ? 1u : 0u;
    worst = std::max(worst, error);
}

std::vector<DistanceOutcome> run_distance_contest(const Scene& scene,
                                                  std::span<const DistanceEngine> engines,
                                                  const DistanceContestOptions& options) {
    std::vector<std::unique_ptr<Lane>> lanes;
    for (const DistanceEngine& engine : engines) {
        lanes.push_back(std::make_unique<Lane>(scene, engine, options));
        lanes.back()->take_turn(Load);
        lanes.back()->take_turn(Check);
    }
    for (std::size_t round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            lanes[(round + i) % lanes.size()]->take_turn(Each);
        }
    }
    std::vector<DistanceOutcome> outcomes;
    for (const auto& lane : lanes) {
        outcomes.push_back(lane->outcome());
    }
    const DistanceOutcome ours = outcomes.front();
    for (std::size_t i = 0; i < outcomes.size() && ours.ending == Ending::Done; ++i) {
        judge(scene, ours, engines[i].is_ours, outcomes[i]);
    }
    return outcomes;
}

} // namespace cd::bench
