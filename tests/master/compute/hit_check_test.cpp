// Proves that the master accepts only hits of lines that a worker could rightly send, and only maps
// that can be of these.
#include "master/compute/hit_check.hpp"

#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "common/shots/line_hit.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// Returns lines of length 8 that run against the x axis, at these heights.
std::shared_ptr<const Mesh> lines_at(const std::vector<double>& heights) {
    MeshArrays arrays;
    for (const double z : heights) {
        const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
        arrays.vertices.emplace_back(4, 0.25, z);
        arrays.vertices.emplace_back(-4, 0.25, z);
        arrays.triangles.push_back({first, first + 1, first + 1});
    }
    return share(Mesh::create(std::move(arrays)).value());
}

class HitCheck : public testing::Test {
  protected:
    HitCheck() {
        ThreadPool pool(1);
        const auto box = std::make_shared<const ObbTree>(
            build_tree(share(make_gridded_box(Vec3(2, 2, 2), 2)), BuildOptions{}, pool));
        const auto lines = std::make_shared<const ObbTree>(
            build_tree(lines_at({0.375, -0.375, 5, 6}), BuildOptions{}, pool));
        Query query;
        query.question = Question::Shots;
        query.level = Level::Pairs;
        material_ = std::make_shared<const JobMaterial>(
            JobMaterial{{box, lines},
                        query,
                        std::make_shared<const Settler>(TreesByBody(*box, *lines), query.ignored)});
        task_.job = JobId{1};
        task_.material = material_;
        task_.analyses.push_back(std::make_shared<const Analysis>());
    }

    /// Changes the query of the task's job.
    void ask(const std::function<void(Query&)>& change) {
        JobMaterial material = *material_;
        change(material.query);
        material_ = std::make_shared<const JobMaterial>(std::move(material));
        task_.material = material_;
    }

    [[nodiscard]] ScenarioRun run() const {
        const SubtreePair whole{material_->trees[0]->view(), material_->trees[1]->view()};
        return run_on_subtrees({&whole, 1}, task_.analyses[0]->scenario, material_->query);
    }

    [[nodiscard]] static Results message_of(const ScenarioResult& result) {
        ByteWriter bytes;
        put_record(bytes, result);
        Results results;
        results.count = 1;
        results.records = pack_records(bytes.take());
        return results;
    }

    [[nodiscard]] std::string refusal(const Results& results) const {
        const auto taken = take_results(task_, results);
        EXPECT_TRUE(taken || taken.error().code == ErrorCode::BadFrame);
        return taken ? "taken" : taken.error().detail;
    }
    [[nodiscard]] std::string refusal(const ScenarioResult& result) const {
        return refusal(message_of(result));
    }
    /// Returns the refusal of the result after a change.
    [[nodiscard]] std::string refusal(const std::function<void(ScenarioResult&)>& change) const {
        ScenarioResult result = run().result;
        change(result);
        return refusal(result);
    }

    std::shared_ptr<const JobMaterial> material_;
    TaskContent task_;
};

} // namespace

TEST_F(HitCheck, TakesWhatAWorkerFinds) {
    const ScenarioResult result = run().result;
    EXPECT_EQ(result.kind, ScenarioClass::Contact);
    EXPECT_GE(result.hits.size(), 4u);
    EXPECT_EQ(refusal(result), "taken");
    const Error lost{ErrorCode::Io, "lost"};
    EXPECT_EQ(refusal(failed_result(task_.analyses[0]->scenario, material_->query, lost)), "taken");
}

TEST_F(HitCheck, AHitIsOfALineAndOfATriangleWithinTheLine) {
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.pairs.back().b = 4; }),
                HasSubstr("triangles that the bodies do not have"));
    const auto triangles =
        static_cast<std::uint32_t>(material_->trees[0]->mesh().triangles().size());
    EXPECT_THAT(refusal([&](ScenarioResult& r) { r.pairs.back().a = triangles; }),
                HasSubstr("triangles that the bodies do not have"));
    EXPECT_EQ(refusal([](ScenarioResult& r) { r.hits[0].depth = 8; }), "taken");
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.hits[0].depth = 8.0000001; }),
                HasSubstr("beyond the end of its line"));
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.hits[0].depth = -1; }),
                HasSubstr("a hit that no line has"));
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.hits[0].flags = 32; }),
                HasSubstr("a hit that no line has"));
    EXPECT_THAT(refusal([](ScenarioResult& r) { std::swap(r.pairs[0], r.pairs[1]); }),
                HasSubstr("ascending"));
    EXPECT_THAT(refusal([](ScenarioResult& r) {
                    r.question = Question::Contacts;
                    r.hits.clear();
                }),
                testing::Not("taken"));
}

TEST_F(HitCheck, RanksOfALineSkipNoNumber) {
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.hits[0].rank = 1; }),
                HasSubstr("ranks that skip a number"));
    ask([](Query& query) { query.limit_pairs = 1; });
    EXPECT_EQ(refusal([](ScenarioResult& r) { r.hits[0].rank = 1; }), "taken") << "the list is cut";
}

TEST_F(HitCheck, OfFirstHitsALineHasOneThatCrosses) {
    const ScenarioResult all = run().result;
    ask([](Query& query) { query.first_hits = true; });
    const ScenarioResult first = run().result;
    EXPECT_LT(first.pair_count, all.pair_count);
    EXPECT_EQ(refusal(first), "taken");
    EXPECT_THAT(refusal(all), HasSubstr("more than first hits"));
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.hits[0].flags ^= hit_flag::crosses; }),
                HasSubstr("more than first hits"));
    EXPECT_THAT(refusal([](ScenarioResult& r) { r.pair_count = 5; }),
                HasSubstr("more than first hits"));
}

TEST_F(HitCheck, TheLinesOfASceneAreTheScenariosBodyB) {
    ThreadPool pool(1);
    const auto small = std::make_shared<const ObbTree>(
        build_tree(share(make_gridded_box(Vec3(0.25, 0.25, 0.25), 1)), BuildOptions{}, pool));
    JobMaterial material = *material_;
    material.trees = {material.trees[0], small, material.trees[1]};
    material_ = std::make_shared<const JobMaterial>(std::move(material));
    task_.material = material_;
    Analysis analysis;
    analysis.scenario.body_b = 2;
    analysis.scenario.step = 7;
    task_.analyses = {std::make_shared<const Analysis>(std::move(analysis))};
    const SubtreePair whole{material_->trees[0]->view(), material_->trees[2]->view()};
    ScenarioResult result =
        run_on_subtrees({&whole, 1}, task_.analyses[0]->scenario, material_->query).result;
    ASSERT_GE(result.hits.size(), 4u);
    EXPECT_EQ(refusal(result), "taken");
    result.hits[0].depth = 8.0000001;
    EXPECT_THAT(refusal(result), HasSubstr("beyond the end of its line"));
}

TEST_F(HitCheck, AMapCountsEachCrossing) {
    for (const Level level : {Level::Count, Level::Pairs}) {
        SCOPED_TRACE(to_text(level));
        ask([&](Query& query) {
            query.level = level;
            query.maps = true;
        });
        const ScenarioRun ran = run();
        ContactMapSum sum;
        sum.add(ran.result, ran.found);
        const ContactMap map = sum.take();
        Results results = message_of(ran.result);
        results.map = pack_map(map);
        EXPECT_EQ(refusal(results), "taken");
        ContactMap more = map;
        more.bodies[0][0].scenarios += ran.result.pair_count;
        results.map = pack_map(more);
        EXPECT_NE(refusal(results), "taken");
        if (level == Level::Pairs) {
            ContactMap fewer = map;
            fewer.bodies[1].pop_back();
            results.map = pack_map(fewer);
            EXPECT_THAT(refusal(results), HasSubstr("crossings that the results do not have"));
        }
    }
}

} // namespace cd::tests
