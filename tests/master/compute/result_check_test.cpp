// Proves that the master accepts only results a worker could rightly send: of the task's scenarios,
// at the requested question, level, clearance and bodies, with pairs and distances that the query
// can have; that it settles them and counts their cost.
#include "master/compute/result_check.hpp"

#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class ResultIntake : public testing::Test {
  protected:
    ResultIntake() {
        const auto box = std::make_shared<const ObbTree>(
            build_tree(share(make_gridded_box(Vec3(2, 2, 2), 2)), BuildOptions{}, pool_));
        Query query;
        query.level = Level::Pairs;
        material_ = std::make_shared<const JobMaterial>(JobMaterial{
            {box, box}, query, std::make_shared<const Settler>(*box, *box, query.ignored)});
        task_.job = JobId{1};
        task_.material = material_;
        for (const double height : {2.0, 1.0}) { // One on the other, and one in the other.
            Analysis analysis;
            analysis.scenario.index = task_.analyses.size();
            analysis.scenario.poses.b = translation_pose(0, 0, height);
            analysis.position = 10 + task_.analyses.size();
            analysis.cost.search.box_tests = 100;
            task_.analyses.push_back(std::make_shared<const Analysis>(std::move(analysis)));
        }
    }

    /// Returns the result as a worker computes it.
    [[nodiscard]] ScenarioResult result_of(std::size_t scenario) const {
        const SubtreePair whole{material_->trees[0]->view(), material_->trees[1]->view()};
        return run_on_subtrees({&whole, 1}, task_.analyses[scenario]->scenario, material_->query)
            .result;
    }

    [[nodiscard]] static Results message_of(const std::vector<ScenarioResult>& list) {
        Bytes bytes;
        for (const ScenarioResult& result : list) {
            const Bytes record = encode_result(result);
            const auto size = static_cast<std::uint32_t>(record.size());
            const auto size_bytes = std::as_bytes(std::span(&size, 1));
            bytes.insert(bytes.end(), size_bytes.begin(), size_bytes.end());
            bytes.insert(bytes.end(), record.begin(), record.end());
        }
        Results results;
        results.count = static_cast<std::uint32_t>(list.size());
        results.records = pack_records(bytes);
        return results;
    }

    [[nodiscard]] std::string refusal(const Results& results) const {
        const auto taken = take_results(task_, results);
        EXPECT_TRUE(taken || taken.error().code == ErrorCode::BadFrame);
        return taken ? "taken" : taken.error().detail;
    }
    [[nodiscard]] std::string refusal(const ScenarioResult& result) const {
        return refusal(message_of({result}));
    }

    /// Changes the query of the task's job.
    void ask(const std::function<void(Query&)>& change) {
        JobMaterial material = *material_;
        change(material.query);
        material_ = std::make_shared<const JobMaterial>(std::move(material));
        task_.material = material_;
    }

    /// Returns a result at level contacts of scenario 0 with one near pair.
    [[nodiscard]] static ScenarioResult near_result(double distance) {
        ScenarioResult result;
        result.level = Level::Contacts;
        result.has_clearance = true;
        result.kind = ScenarioClass::Near;
        result.near_count = 1;
        result.pairs = {{0, 0, PairClass::Near}};
        result.point_origins = {Vec3(0, 0, 0)};
        result.point_offsets = {0, 2};
        result.points = {Vec3(0, 0, 0), Vec3(0, 0, 1)};
        result.near_distances = {distance};
        return result;
    }

    /// Asks how far apart the bodies are, and moves B away in scenario 0.
    void ask_for_distance(std::optional<double> up_to) {
        ask([&](Query& query) {
            query.level = Level::Any;
            query.question = Question::Distance;
            query.up_to = up_to;
        });
        Analysis apart = *task_.analyses[0];
        apart.scenario.poses.b = translation_pose(0, 0, 2.5);
        task_.analyses[0] = std::make_shared<const Analysis>(std::move(apart));
    }

    ThreadPool pool_{1};
    std::shared_ptr<const JobMaterial> material_;
    TaskContent task_;
};

} // namespace

TEST_F(ResultIntake, SettlesAndCountsWhatAWorkerFound) {
    const auto taken = take_results(task_, message_of({result_of(0), result_of(1)}));
    ASSERT_TRUE(taken) << taken.error().detail;
    EXPECT_EQ(taken.value().positions, (PositionRange{10, 2}));
    EXPECT_EQ(taken.value().positions_of_rows, (std::vector<std::uint64_t>{10, 11}));
    const ResultBatch& results = taken.value().results;
    ASSERT_EQ(results.size(), 2u);
    EXPECT_TRUE(taken.value().map.empty());
    JobStatistics cost;
    ResultBatch expected;
    for (std::size_t i = 0; i < 2; ++i) {
        const ScenarioRun whole = run_scenario(*material_->trees[0],
                                               *material_->trees[1],
                                               task_.analyses[i]->scenario,
                                               material_->query);
        EXPECT_EQ(results.rows()[i].facts, facts_of(whole.result));
        EXPECT_EQ(results.digests()[i], digest_of(whole.result));
        expected.add(whole.result);
        cost.inside += whole.inside;
    }
    EXPECT_EQ(results.stored(), expected.stored());
    EXPECT_EQ(taken.value().cost.search.box_tests, 200u); // Cost of the two analyses.
    EXPECT_EQ(taken.value().cost.inside.scenarios, cost.inside.scenarios);
    EXPECT_EQ(taken.value().cost.inside.work, cost.inside.work);
    EXPECT_EQ(results.rows()[0].facts.kind, ScenarioClass::Touch);
    EXPECT_EQ(results.rows()[1].facts.kind, ScenarioClass::Cross);
}

// That the bodies of scenario 1 penetrate takes the poses to tell.
TEST_F(ResultIntake, ARangeIsTakenAsTheSameScenariosAnalysed) {
    const Results message = message_of({result_of(0), result_of(1)});
    const TakenResults expected = take_results(task_, message).value();
    ASSERT_EQ(result_of(1).kind, ScenarioClass::Touch);
    ASSERT_EQ(expected.results.rows()[1].facts.kind, ScenarioClass::Cross);

    Grid heights;
    heights.position = {GridAxis{0, 0, 1}, GridAxis{0, 0, 1}, GridAxis{2, 1, 2}};
    std::vector<PackedScenarios> runs;
    const std::vector<Scenario> list{task_.analyses[0]->scenario, task_.analyses[1]->scenario};
    runs.push_back(PackedScenarios::open(pack_scenarios(list), 2).value());
    const RangeContent on_grid{{0, 2}, nullptr, std::make_shared<OrderedPoses>(heights)};
    const RangeContent in_window{
        {0, 2},
        std::make_shared<const PoseWindow>(PoseWindow::open(0, std::move(runs)).value()),
        nullptr};
    for (const RangeContent& range : {on_grid, in_window}) {
        const TaskContent task{task_.job, material_, {}, range};
        const auto taken = take_results(task, message);
        ASSERT_TRUE(taken) << taken.error().detail;
        EXPECT_EQ(taken.value().positions, (PositionRange{0, 2}));
        EXPECT_EQ(taken.value().results.stored(), expected.results.stored());
        EXPECT_TRUE(std::ranges::equal(taken.value().results.rows(), expected.results.rows()));
    }
    ScenarioResult foreign = result_of(0);
    foreign.index = 2;
    const auto refused = take_results({task_.job, material_, {}, on_grid}, message_of({foreign}));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().detail, HasSubstr("not in the task"));
}

TEST_F(ResultIntake, TakesRecordsThatAreNotPacked) {
    const Results packed = message_of({result_of(0), result_of(1)});
    Results plain = packed;
    plain.records = unpack_records(packed.records, limits::results_bytes_max).value();
    plain.are_packed = false;
    const auto taken = take_results(task_, plain);
    ASSERT_TRUE(taken) << taken.error().detail;
    EXPECT_EQ(taken.value().results.stored(), take_results(task_, packed).value().results.stored());
    plain.records.pop_back();
    EXPECT_NE(refusal(plain), "taken");
    plain.records.clear();
    EXPECT_NE(refusal(plain), "taken");
}

TEST_F(ResultIntake, RefusesTrianglesThatTheBodiesDoNotHave) {
    const auto triangles =
        static_cast<std::uint32_t>(material_->trees[0]->mesh().triangles().size());
    ScenarioResult result = result_of(0);
    ASSERT_FALSE(result.pairs.empty());
    ScenarioResult beyond_a = result;
    beyond_a.pairs.back().a = triangles;
    EXPECT_THAT(refusal(beyond_a), HasSubstr("triangles that the bodies do not have"));
    // The last pair by A, so that the pairs stay sorted.
    ScenarioResult beyond_b = result;
    beyond_b.pairs.back().b = triangles;
    EXPECT_THAT(refusal(beyond_b), HasSubstr("triangles that the bodies do not have"));
    ScenarioResult last = result;
    last.pairs.back().a = triangles - 1;
    last.pairs.back().b = triangles - 1;
    EXPECT_EQ(refusal(last), "taken");
}

TEST_F(ResultIntake, RefusesWhatWasNotAskedFor) {
    const ScenarioResult result = result_of(0);
    ScenarioResult foreign = result;
    foreign.index = 2;
    EXPECT_THAT(refusal(foreign), HasSubstr("not in the task"));
    ScenarioResult other_body = result;
    other_body.body_b = 7;
    EXPECT_THAT(refusal(other_body), HasSubstr("not of the level or bodies"));
    ScenarioResult other_level = result;
    other_level.level = Level::Count;
    other_level.pairs.clear();
    EXPECT_THAT(refusal(other_level), HasSubstr("not of the level or bodies"));
    ScenarioResult undecided = result;
    undecided.kind = ScenarioClass::Undecided;
    EXPECT_THAT(refusal(undecided), HasSubstr("is undecided, which its query does not allow"));
}

TEST_F(ResultIntake, ChecksAResultByItsOwnBodies) {
    const auto small = std::make_shared<const ObbTree>(
        build_tree(share(make_box(Vec3(1, 1, 1))), BuildOptions{}, pool_));
    JobMaterial material = *material_;
    material.trees.insert(material.trees.begin(), small); // Bodies 1 and 2 are the boxes now.
    const auto all = static_cast<std::uint32_t>(material.triangles_of(1));
    material.query.ignored = {{0, 12, 0, all, 0, 2}};
    material.settler =
        std::make_shared<const Settler>(TreesByBody(material.trees), material.query.ignored);
    material_ = std::make_shared<const JobMaterial>(material);
    task_.material = material_;
    const auto of_bodies = [&](std::uint32_t a, std::uint32_t b) {
        Analysis analysis = *task_.analyses[0];
        analysis.scenario.body_a = a;
        analysis.scenario.body_b = b;
        task_.analyses[0] = std::make_shared<const Analysis>(std::move(analysis));
        const SubtreePair whole{material.trees[a]->view(), material.trees[b]->view()};
        return run_on_subtrees({&whole, 1}, task_.analyses[0]->scenario, material.query).result;
    };
    const ScenarioResult of_boxes = of_bodies(1, 2);
    ASSERT_GT(of_boxes.pair_count, 0u);
    EXPECT_EQ(refusal(of_boxes), "taken");
    ScenarioResult of_others = of_boxes;
    of_others.body_a = 0;
    EXPECT_THAT(refusal(of_others), HasSubstr("not of the level or bodies"));
    of_bodies(0, 2);
    of_others.pairs.resize(1);
    of_others.pair_count = 1;
    of_others.pairs[0].a = 12; // The small box has 12 triangles.
    EXPECT_THAT(refusal(of_others), HasSubstr("triangles that the bodies do not have"));
    of_others.pairs[0].a = 5;
    EXPECT_THAT(refusal(of_others), HasSubstr("ignored triangles"));
    of_bodies(0, 1);
    of_others.body_b = 1;
    EXPECT_EQ(refusal(of_others), "taken");
}

TEST_F(ResultIntake, RefusesMorePairsThanTheBodiesHave) {
    const std::uint64_t triangles = material_->trees[0]->mesh().triangles().size();
    ScenarioResult result = result_of(0);
    result.pair_count = triangles * triangles;
    EXPECT_EQ(refusal(result), "taken");
    ++result.pair_count;
    EXPECT_THAT(refusal(result), HasSubstr("more pairs than the bodies"));
    result.pair_count = std::uint64_t{1} << 60;
    EXPECT_THAT(refusal(result), HasSubstr("more pairs than the bodies"));
}

TEST_F(ResultIntake, RefusesPairsThatAreIgnored) {
    const ScenarioResult result = result_of(0);
    const ContactPair ignored = result.pairs.back();
    ask([&](Query& query) {
        query.ignored = {{ignored.a, ignored.a + 1, ignored.b, ignored.b + 1}};
    });
    EXPECT_THAT(refusal(result), HasSubstr("pairs of ignored triangles"));
    ScenarioResult others = result;
    others.pairs.pop_back();
    --others.pair_count;
    EXPECT_EQ(refusal(others), "taken");
}

TEST_F(ResultIntake, AResultHasAClearanceIfTheQueryHas) {
    ScenarioResult without = result_of(0);
    ScenarioResult with = without;
    with.has_clearance = true;
    EXPECT_EQ(refusal(without), "taken");
    EXPECT_THAT(refusal(with), HasSubstr("a clearance that was not asked for"));
    ScenarioResult failed = without;
    failed.kind = ScenarioClass::Failed;
    failed.pairs.clear();
    failed.pair_count = 0;
    EXPECT_EQ(refusal(failed), "taken");

    ask([](Query& query) { query.clearance = 0.25; });
    EXPECT_EQ(refusal(with), "taken");
    EXPECT_THAT(refusal(without), HasSubstr("lacks the clearance"));
    EXPECT_THAT(refusal(failed), HasSubstr("lacks the clearance"));
    failed.has_clearance = true;
    EXPECT_EQ(refusal(failed), "taken");
}

TEST_F(ResultIntake, NearPairsAreOfTheBodiesAndWithinTheClearance) {
    ask([](Query& query) {
        query.level = Level::Contacts;
        query.clearance = 0.25;
    });
    const ScenarioResult near = near_result(0.25);
    EXPECT_EQ(refusal(near), "taken");
    EXPECT_THAT(refusal(near_result(0.250001)), HasSubstr("farther apart than the clearance"));
    const std::uint64_t triangles = material_->trees[0]->mesh().triangles().size();
    ScenarioResult wrong = near;
    wrong.pairs[0].b = static_cast<std::uint32_t>(triangles);
    EXPECT_THAT(refusal(wrong), HasSubstr("triangles that the bodies do not have"));
    wrong = near;
    wrong.near_count = triangles * triangles + 1;
    EXPECT_THAT(refusal(wrong), HasSubstr("more pairs than the bodies"));
    wrong.near_count = ~std::uint64_t{0};
    EXPECT_THAT(refusal(wrong), HasSubstr("more pairs than the bodies"));
    ask([](Query& query) { query.ignored = {{0, 1, 0, 1}}; });
    EXPECT_THAT(refusal(near), HasSubstr("pairs of ignored triangles"));
}

TEST_F(ResultIntake, AResultAnswersTheQuestionOfTheQuery) {
    const ScenarioResult contacts = result_of(0);
    ask_for_distance(std::nullopt);
    const ScenarioResult distance = result_of(0);
    ASSERT_TRUE(distance.nearest);
    EXPECT_EQ(refusal(distance), "taken");
    ScenarioResult other = contacts;
    other.level = Level::Any;
    other.kind = ScenarioClass::Contact;
    other.pair_count = 0;
    EXPECT_THAT(refusal(other), HasSubstr("answers another question"));
    const Scenario& scenario = task_.analyses[0]->scenario;
    const Error lost{ErrorCode::Io, "lost"};
    EXPECT_EQ(refusal(failed_result(scenario, material_->query, lost)), "taken");
    ask([](Query& query) { query.question = Question::Contacts; });
    EXPECT_THAT(refusal(distance), HasSubstr("answers another question"));
    EXPECT_EQ(refusal(other), "taken");
    EXPECT_EQ(refusal(failed_result(scenario, material_->query, lost)), "taken");
}

TEST_F(ResultIntake, ADistanceIsOfTheBodiesAndNotAboveUpTo) {
    ask_for_distance(0.5);
    const ScenarioResult result = result_of(0);
    ASSERT_TRUE(result.nearest);
    EXPECT_EQ(result.nearest->distance, 0.5);
    EXPECT_EQ(refusal(result), "taken");
    const auto triangles =
        static_cast<std::uint32_t>(material_->trees[0]->mesh().triangles().size());
    ScenarioResult wrong = result;
    wrong.nearest->a = triangles;
    EXPECT_THAT(refusal(wrong), HasSubstr("triangles that the bodies do not have"));
    wrong = result;
    wrong.nearest->b = triangles;
    EXPECT_THAT(refusal(wrong), HasSubstr("triangles that the bodies do not have"));
    wrong = result;
    wrong.nearest->distance = 0.500001;
    EXPECT_THAT(refusal(wrong), HasSubstr("above up_to"));
    ask([&](Query& query) {
        const NearestWitness& of = *result.nearest;
        query.ignored = {{of.a, of.a + 1, of.b, of.b + 1}};
    });
    EXPECT_THAT(refusal(result), HasSubstr("a distance of ignored triangles"));
}

TEST_F(ResultIntake, BodiesApartHaveADistanceUnlessTheyMayBeBeyondUpTo) {
    ask_for_distance(std::nullopt);
    ScenarioResult without = result_of(0);
    without.nearest.reset();
    EXPECT_THAT(refusal(without), HasSubstr("lacks the distance"));
    ScenarioResult touching = without;
    touching.kind = ScenarioClass::Contact;
    EXPECT_EQ(refusal(touching), "taken");
    ask([](Query& query) { query.up_to = 0.25; });
    EXPECT_EQ(refusal(without), "taken");
    const auto triangles =
        static_cast<std::uint32_t>(material_->trees[0]->mesh().triangles().size());
    ask([&](Query& query) {
        query.up_to.reset();
        query.ignored = {{0, triangles, 0, triangles}};
    });
    EXPECT_EQ(refusal(without), "taken") << "all pairs are ignored";
}

TEST_F(ResultIntake, AMapHasToMarkScenariosThatAreOnlyNear) {
    ask([](Query& query) {
        query.level = Level::Count;
        query.maps = true;
        query.clearance = 0.25;
    });
    ScenarioResult near = near_result(0);
    near.level = Level::Count;
    near.pairs.clear();
    ContactMap map;
    map.bodies[0] = map.bodies[1] = {{0, 1}};
    Results results = message_of({near});
    results.map = pack_map(map);
    EXPECT_EQ(refusal(results), "taken");
    results.map = pack_map({});
    EXPECT_THAT(refusal(results), HasSubstr("lacks scenarios"));
}

TEST_F(ResultIntake, RefusesMoreOrLessThanAnnounced) {
    Results results = message_of({result_of(0)});
    results.count = 2;
    EXPECT_THAT(refusal(results), HasSubstr("not as many as announced"));
    results.count = 0;
    EXPECT_THAT(refusal(results), HasSubstr("not as many as announced"));
    Results cut = message_of({result_of(0)});
    cut.records.resize(cut.records.size() / 2);
    EXPECT_NE(refusal(cut), "taken");
}

TEST_F(ResultIntake, ANumberThatPromisesGigabytesTakesNone) {
    Results results = message_of({result_of(0)});
    results.count = ~std::uint32_t{0};
    EXPECT_THAT(refusal(results), HasSubstr("not as many as announced"));
}

TEST_F(ResultIntake, AMapHasToBeThatOfItsScenarios) {
    const std::vector<ContactPair> pairs = result_of(0).pairs;
    const auto with_map = [&](const ContactMap& map) {
        Results results = message_of({result_of(0), result_of(1)});
        results.map = pack_map(map);
        return results;
    };
    ContactMapSum sum;
    sum.add(result_of(0).pairs);
    sum.add(result_of(1).pairs);
    const ContactMap right = sum.take();
    EXPECT_THAT(refusal(with_map(right)), HasSubstr("a map that was not asked for"));

    Query query = material_->query;
    query.level = Level::Count;
    query.maps = true;
    material_ = std::make_shared<const JobMaterial>(
        JobMaterial{material_->trees, query, material_->settler});
    task_.material = material_;
    const auto taken = take_results(task_, with_map(right));
    ASSERT_TRUE(taken) << taken.error().detail;
    EXPECT_EQ(taken.value().map, right);

    EXPECT_THAT(refusal(message_of({result_of(0), result_of(1)})), HasSubstr("a map"));
    ContactMap wrong = right;
    wrong.bodies[1].back().triangle =
        static_cast<std::uint32_t>(material_->trees[1]->mesh().triangles().size());
    EXPECT_THAT(refusal(with_map(wrong)), HasSubstr("contradicts"));
    wrong = right;
    wrong.bodies[0].front().scenarios = 3;
    EXPECT_THAT(refusal(with_map(wrong)), HasSubstr("contradicts"));
    wrong = right;
    wrong.bodies[0] = {{0, 1}};
    EXPECT_THAT(refusal(with_map(wrong)), HasSubstr("lacks scenarios"));
}

TEST_F(ResultIntake, SumsByPartHaveToBeThoseOfTheScenarios) {
    Query query = material_->query;
    query.level = Level::Count;
    query.maps = true;
    const PartRuns halves = PartRuns::create({{0, 1}, {20, 0}}).value();
    material_ = std::make_shared<const JobMaterial>(
        JobMaterial{material_->trees,
                    query,
                    material_->settler,
                    std::make_shared<const BodyPartRuns>(BodyPartRuns{halves, halves})});
    task_.material = material_;
    ContactMapSum sum(material_->parts);
    std::vector<ScenarioResult> results;
    for (const auto& analysis : task_.analyses) {
        const SubtreePair whole{material_->trees[0]->view(), material_->trees[1]->view()};
        const ScenarioRun run = run_on_subtrees({&whole, 1}, analysis->scenario, query);
        sum.add(run.result, run.found);
        results.push_back(run.result);
    }
    const ContactMap right = sum.take();
    ASSERT_GT(right.parts.pairs.size(), 1u);
    const auto answer = [&](const ContactMap& map) {
        Results message = message_of(results);
        message.map = pack_map(map);
        return refusal(message);
    };
    EXPECT_EQ(answer(right), "taken");
    const auto expect_refused = [&](const std::function<void(PartContacts&)>& change) {
        ContactMap wrong = right;
        change(wrong.parts);
        EXPECT_THAT(answer(wrong),
                    testing::AnyOf(HasSubstr("sums by part"), HasSubstr("contradicts itself")));
    };
    expect_refused([](PartContacts& parts) { parts.parts[1].back().part = 2; });
    expect_refused([](PartContacts& parts) { parts.parts[0].clear(); });
    expect_refused([](PartContacts& parts) { parts.pairs.back().a = 2; });
    expect_refused([](PartContacts& parts) { parts.pairs.back().b = 2; });
    expect_refused([](PartContacts& parts) { parts.pairs.back().last = 2; });
    expect_refused([](PartContacts& parts) {
        parts.pairs.back().worst = parts.pairs.back().first = parts.pairs.back().last = 7;
        parts.pairs.back().scenarios = parts.pairs.back().pairs = 1;
        parts.pairs.back().worst_pairs = 1;
    });
}

TEST_F(ResultIntake, WrongSumsOfListedPairsAreMadeAnew) {
    const PartRuns halves = PartRuns::create({{0, 1}, {20, 0}}).value();
    material_ = std::make_shared<const JobMaterial>(
        JobMaterial{material_->trees,
                    material_->query,
                    material_->settler,
                    std::make_shared<const BodyPartRuns>(BodyPartRuns{halves, halves})});
    task_.material = material_;
    ContactMapSum sum(material_->parts);
    sum.add(result_of(0), {});
    sum.add(result_of(1), {});
    const ContactMap right = sum.take();
    ASSERT_GT(right.parts.pairs.size(), 1u);
    ContactMap wrong = right;
    wrong.parts.parts[0].clear();
    for (const Bytes& map : {pack_map(right), pack_map(wrong), Bytes(), Bytes(3)}) {
        Results message = message_of({result_of(0), result_of(1)});
        message.map = map;
        const auto taken = take_results(task_, message);
        ASSERT_TRUE(taken) << taken.error().detail;
        EXPECT_EQ(taken.value().map, right);
    }
}

} // namespace cd::tests
