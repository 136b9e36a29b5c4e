#include "bench/peers/ours.hpp"
#include "bench/peers/shots/shot_engine.hpp"
#include "common/core/check.hpp"
#include "common/job/run_scenario.hpp"

#include <memory>
#include <optional>

namespace cd::bench {

namespace {

Query shots_query() {
    Query query;
    query.level = Level::Pairs;
    query.question = Question::Shots;
    return query;
}

/// What a job runs. The body is body 0, and each bundle one of the others.
class OurShots final : public ShotBody {
  public:
    void load(const ShotScene& scene) override {
        scene_ = &scene;
        trees_ = {build_ours(scene.mesh, 1)};
        for (const ShotBundle& bundle : scene.bundles) {
            trees_.push_back(build_ours(bundle.lines, 1));
        }
        runner_.emplace(TreesByBody(trees_), query_);
        session_.emplace(*runner_);
    }

    void shoot(std::vector<ShotHit>& hits) override {
        std::uint32_t first_line = 0;
        Scenario scenario;
        for (const ShotBundle& bundle : scene_->bundles) {
            for (const Pose& pose : bundle.poses) {
                scenario.poses.b = pose;
                append(session_->run(scenario).result, first_line, hits);
                first_line += static_cast<std::uint32_t>(bundle.lines->triangles().size());
            }
            ++scenario.body_b;
        }
    }

  private:
    static void
    append(const ScenarioResult& result, std::uint32_t first_line, std::vector<ShotHit>& hits) {
        CD_CHECK(result.kind != ScenarioClass::Failed);
        CD_CHECK(result.hits.size() == result.pairs.size());
        for (std::size_t i = 0; i < result.pairs.size(); ++i) {
            const ContactPair& pair = result.pairs[i];
            const PairHit& hit = result.hits[i];
            hits.push_back({first_line + pair.b, pair.a, hit.depth, hit.flags, hit.rank});
        }
    }

    const ShotScene* scene_ = nullptr;
    BodyTrees trees_;
    Query query_ = shots_query();
    std::optional<ScenarioRunner> runner_;
    std::optional<ScenarioSession> session_;
};

} // namespace

ShotEngine our_shots() {
    return {"cdcluster", true, [] { return std::make_unique<OurShots>(); }};
}

} // namespace cd::bench
