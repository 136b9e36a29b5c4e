// Proves that questions to the library have the engine's answers at all levels, for any number of
// threads and windows, that calls can be stopped, and that wrong questions are refused.
#include "tests/library/bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Enough for many milliseconds, so that threads take part.
constexpr std::size_t many = 3000;

std::ptrdiff_t own_threads() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

Query engine_query(const cdcluster::Query& asked) {
    Query query;
    query.level =
        asked.level == cdcluster::Level::Distance ? Level::Any : static_cast<Level>(asked.level);
    query.question =
        asked.level == cdcluster::Level::Distance ? Question::Distance : Question::Contacts;
    query.clearance = asked.clearance;
    query.up_to = asked.up_to;
    query.limit_pairs = asked.limit_pairs;
    return query;
}

/// Expects that the arrays hold exactly these results.
void expect_equal(const cdcluster::Results& got, const std::vector<ScenarioResult>& wanted) {
    ASSERT_EQ(got.size(), wanted.size());
    EXPECT_EQ(got.digest, digest_of(wanted));
    std::size_t point = 0;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        SCOPED_TRACE(i);
        const ScenarioResult& result = wanted[i];
        ASSERT_EQ(static_cast<int>(got.kind[i]), static_cast<int>(result.kind));
        ASSERT_EQ(got.is_hit(i), is_contact(result.kind));
        ASSERT_EQ(got.count[i], result.pair_count);
        if (result.has_clearance) {
            ASSERT_EQ(got.near_count[i], result.near_count);
        }
        if (result.level >= Level::Pairs) {
            ASSERT_EQ(got.offsets[i], pair);
            for (const ContactPair& each : result.pairs) {
                ASSERT_EQ(got.pairs[pair].a, each.a);
                ASSERT_EQ(got.pairs[pair].b, each.b);
                ASSERT_EQ(static_cast<int>(got.pair_class[pair]), static_cast<int>(each.kind));
                ++pair;
            }
            ASSERT_EQ(got.offsets[i + 1], pair);
        }
        if (result.level == Level::Contacts) {
            for (std::size_t k = 0; k < result.pairs.size(); ++k) {
                const std::size_t first = pair - result.pairs.size() + k;
                ASSERT_EQ(got.point_offsets[first], point);
                for (std::size_t p = result.point_offsets[k]; p < result.point_offsets[k + 1];
                     ++p) {
                    const Vec3 at = result.point_origins[k] + result.points[p];
                    ASSERT_EQ(got.points[point++], (cdcluster::Point{at[0], at[1], at[2]}));
                }
            }
        }
        if (result.question == Question::Distance) {
            ASSERT_EQ(std::isnan(got.distance[i]), !result.nearest);
            if (result.nearest) {
                ASSERT_EQ(got.distance[i], result.nearest->distance);
                ASSERT_EQ(got.witness[i].a, result.nearest->a);
                ASSERT_EQ(got.witness[i].b, result.nearest->b);
            }
        }
    }
}

} // namespace

TEST(FindContacts, AnswersAsTheEngineAtAllLevels) {
    const LibraryBodies bodies(300);
    std::vector<cdcluster::Query> queries;
    for (int level = 0; level <= 4; ++level) {
        queries.emplace_back().level = static_cast<cdcluster::Level>(level);
        if (level < 4) {
            queries.emplace_back(queries.back()).clearance = 0.1;
        } else {
            queries.emplace_back(queries.back()).up_to = 0.5;
        }
    }
    queries.emplace_back().limit_pairs = 3;
    for (const cdcluster::Query& query : queries) {
        SCOPED_TRACE(static_cast<int>(query.level));
        const auto wanted = bodies.answers(engine_query(query));
        expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query), wanted);
        // The second call reuses trees and search.
        expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query), wanted);
    }
}

TEST(FindContacts, TakesEachFormOfPosesAsItIs) {
    const LibraryBodies bodies(50);
    std::vector<Scenario> scenarios = bodies.scenarios;
    std::vector<double> rows;
    std::vector<double> squares;
    for (Scenario& scenario : scenarios) {
        const Mat3 r = scenario.poses.b.rotation();
        const Vec3 t = scenario.poses.b.translation();
        scenario.poses.b = Pose::from_matrix(r, t);
        for (int k = 0; k < 3; ++k) {
            rows.insert(rows.end(), {r(k, 0), r(k, 1), r(k, 2), t[k]});
            squares.insert(squares.end(), {r(k, 0), r(k, 1), r(k, 2), t[k]});
        }
        squares.insert(squares.end(), {0, 0, 0, 1});
    }
    ThreadPool pool(1);
    const ObbTree tree_a = build_tree(bodies.mesh_a, {}, pool);
    const ObbTree tree_b = build_tree(bodies.mesh_b, {}, pool);
    std::vector<ScenarioResult> wanted;
    for (const Scenario& scenario : scenarios) {
        wanted.push_back(run_scenario(tree_a, tree_b, scenario, {}).result);
    }
    using cdcluster::PoseForm;
    expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, {rows, PoseForm::Matrix34}), wanted);
    expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, {squares, PoseForm::Matrix44}),
                 wanted);
    std::vector<double> xyzw;
    for (std::size_t i = 0; i < bodies.numbers.size(); i += 7) {
        const double* n = &bodies.numbers[i];
        xyzw.insert(xyzw.end(), {n[0], n[1], n[2], n[4], n[5], n[6], n[3]});
    }
    expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, {xyzw, PoseForm::Xyzw}),
                 bodies.answers({}));
}

TEST(FindContacts, DependsNeitherOnThreadsNorOnWindows) {
    const LibraryBodies bodies(many);
    const std::ptrdiff_t threads_before = own_threads();
    cdcluster::Query query;
    query.maps = true;
    query.threads = 1;
    const auto whole = cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query);
    expect_equal(whole, bodies.answers({}));
    for (const unsigned threads : {2u, 4u}) {
        query.threads = threads;
        const auto again = cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query);
        EXPECT_EQ(again.digest, whole.digest);
        EXPECT_EQ(again.map_a, whole.map_a);
    }
    cdcluster::Results joined;
    const auto rest = cdcluster::find_contacts(
        bodies.a, bodies.b, bodies.poses(), query, [&](cdcluster::Results&& window) {
            EXPECT_EQ(window.first, joined.kind.size());
            joined.kind.insert(joined.kind.end(), window.kind.begin(), window.kind.end());
            joined.count.insert(joined.count.end(), window.count.begin(), window.count.end());
        });
    EXPECT_EQ(rest.size(), 0u);
    EXPECT_EQ(rest.digest, whole.digest);
    EXPECT_EQ(rest.map_b, whole.map_b);
    EXPECT_EQ(joined.kind, whole.kind);
    EXPECT_EQ(joined.count, whole.count);
    EXPECT_EQ(own_threads(), threads_before);
}

TEST(FindContacts, CountsMapsByTriangle) {
    const LibraryBodies bodies(200);
    cdcluster::Query query;
    query.maps = true;
    const auto results = cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query);
    std::vector<std::uint64_t> of_a(bodies.a.triangle_count());
    for (std::size_t i = 0; i < results.size(); ++i) {
        std::vector<std::uint32_t> touched;
        for (std::uint64_t k = results.offsets[i]; k < results.offsets[i + 1]; ++k) {
            touched.push_back(results.pairs[k].a);
        }
        std::ranges::sort(touched);
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const std::uint32_t triangle : touched) {
            ++of_a[triangle];
        }
    }
    EXPECT_EQ(results.map_a, of_a);
    EXPECT_EQ(results.map_b.size(), bodies.b.triangle_count());
}

TEST(FindContacts, LeavesOutIgnoredParts) {
    const LibraryBodies bodies(100);
    const std::vector<cdcluster::Part> parts{
        {"front", 0, 100}, {"back", 100, static_cast<std::uint32_t>(bodies.a.triangle_count())}};
    const auto a = cdcluster::Mesh::from_arrays(bodies.a.xyz(), bodies.a.triangles(), parts);
    const auto b = cdcluster::Mesh::from_arrays(
        bodies.b.xyz(),
        bodies.b.triangles(),
        std::vector<cdcluster::Part>{
            {"ball", 0, static_cast<std::uint32_t>(bodies.b.triangle_count())}});
    cdcluster::Query query;
    query.ignore = {{"front", "*"}};
    const auto results = cdcluster::find_contacts(a, b, bodies.poses(), query);
    EXPECT_FALSE(results.pairs.empty());
    for (const cdcluster::Pair& pair : results.pairs) {
        EXPECT_GE(pair.a, 100u);
    }
    query.ignore = {{"fron", "*"}};
    EXPECT_THAT(error_of([&] { return cdcluster::find_contacts(a, b, bodies.poses(), query); }),
                testing::AllOf(HasSubstr("fron"), HasSubstr("did you mean \"front\"")));
}

TEST(FindContacts, EndsWhenProgressSaysSoAndCanBeAskedAgain) {
    const LibraryBodies bodies(40 * many);
    cdcluster::Query query;
    query.threads = 2;
    int told = 0;
    query.progress = [&](const cdcluster::Progress& progress) {
        EXPECT_LE(progress.done, progress.total);
        return ++told < 2;
    };
    try {
        static_cast<void>(cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses(), query));
        ADD_FAILURE() << "the call was not stopped";
    } catch (const cdcluster::Error& error) {
        EXPECT_EQ(error.code(), cdcluster::ErrorCode::Interrupted);
    }
    EXPECT_EQ(told, 2);
    const LibraryBodies few(20);
    expect_equal(cdcluster::find_contacts(bodies.a, bodies.b, few.poses()), few.answers({}));
}

TEST(FindContacts, IsStoppedWhileItBuildsTrees) {
    const LibraryBodies bodies(20);
    const auto large = cdcluster::Mesh::from_canonical_bytes(
        make_torus(2, 0.7, 1500, 400).canonical_bytes()); // Its tree takes longer than a period.
    cdcluster::Query query;
    query.threads = 2;
    query.progress = [](const cdcluster::Progress& progress) {
        EXPECT_EQ(progress.done, 0u);
        EXPECT_EQ(progress.total, 20u);
        return false;
    };
    const auto ask = [&] {
        return cdcluster::find_contacts(large, bodies.b, bodies.poses(), query);
    };
    try {
        static_cast<void>(ask());
        ADD_FAILURE() << "the call was not stopped";
    } catch (const cdcluster::Error& error) {
        EXPECT_EQ(error.code(), cdcluster::ErrorCode::Interrupted);
    }
    query.progress = [](const cdcluster::Progress&) -> bool { throw std::out_of_range("mine"); };
    EXPECT_THROW(static_cast<void>(ask()), std::out_of_range);
    query.progress = {};
    EXPECT_EQ(ask().size(), 20u);
}

TEST(FindContacts, AnswersManyThreadsAtOnce) {
    const LibraryBodies bodies(60);
    const std::string digest = digest_of(bodies.answers({}));
    std::atomic<int> equal = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&] {
            for (int round = 0; round < 5; ++round) {
                const auto results = cdcluster::find_contacts(bodies.a, bodies.b, bodies.poses());
                equal += results.digest == digest ? 1 : 0;
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(equal, 40);
}

TEST(FindContacts, RefusesWrongQuestions) {
    const LibraryBodies bodies(3);
    const auto refused = [&](const cdcluster::Poses& poses, const cdcluster::Query& query = {}) {
        return error_of([&] { return cdcluster::find_contacts(bodies.a, bodies.b, poses, query); });
    };
    std::vector<double> numbers = bodies.numbers;
    numbers[7 + 3] = 2;
    EXPECT_THAT(refused({numbers, cdcluster::PoseForm::Wxyz}), HasSubstr("row 1: the quaternion"));
    numbers[14] = std::nan("");
    numbers[7 + 3] = bodies.numbers[7 + 3];
    EXPECT_THAT(refused({numbers, cdcluster::PoseForm::Wxyz}), HasSubstr("row 2"));
    EXPECT_THAT(refused({std::span(numbers).first(8), cdcluster::PoseForm::Wxyz}),
                HasSubstr("8 numbers"));
    EXPECT_THAT(refused({}), HasSubstr("0 numbers"));
    cdcluster::Query query;
    query.up_to = 1;
    EXPECT_THAT(refused(bodies.poses(), query), HasSubstr("up_to"));
    query = {};
    query.clearance = -1;
    EXPECT_THAT(refused(bodies.poses(), query), HasSubstr("clearance"));
    query = {};
    query.level = cdcluster::Level::Any;
    query.maps = true;
    EXPECT_THAT(refused(bodies.poses(), query), HasSubstr("maps"));
}

} // namespace cd::tests
