// Proves that the page of a results folder shows what its records say: classes, counts, maps, poses
// and the next contact, each against a slow count; and that a scenario is run again, so that its
// record is verified and its contacts can be drawn.
#include "client/view/viewed_run.hpp"

#include "client/folder/folder_exports.hpp"
#include "common/job/result/severity.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/client/view/viewed_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace cd::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ViewedRecords : public Viewed {
  protected:
    [[nodiscard]] std::vector<ScenarioResult> records() const {
        std::vector<ScenarioResult> results;
        const auto run = OpenedRun::open(folder_ / "out");
        EXPECT_TRUE(run.value().records().for_each([&](const RecordView& record) {
            results.push_back(record.result);
            return Status(Done{});
        }));
        return results;
    }

    /// Replaces the record of a scenario by what `how` makes of it.
    void change(std::uint64_t scenario, const std::function<void(ScenarioResult&)>& how) const {
        auto results = records();
        auto writer = RecordWriter::create(folder_ / "changed");
        for (ScenarioResult& result : results) {
            if (result.index == scenario) {
                how(result);
            }
            writer.value().add(result.index, encode_result(result));
        }
        EXPECT_TRUE(writer.value().finish());
        fs::rename(folder_ / "changed", folder_ / "out/records");
    }
};

bool touches(const ScenarioResult& result) {
    return result.kind == ScenarioClass::Touch || result.kind == ScenarioClass::Cross ||
           result.kind == ScenarioClass::Inside;
}

} // namespace

TEST_F(ViewedRecords, ClassesCountsAndMapAreThoseOfTheRecords) {
    const auto viewed = view("level = \"pairs\"\n");
    const auto results = records();
    ASSERT_EQ(results.size(), scenarios);
    const auto classes = viewed->classes({0, scenarios}).value();
    const auto counts = viewed->counts({0, scenarios}).value();
    std::set<ScenarioClass> seen;
    std::map<std::uint32_t, std::uint64_t> in_contact;
    for (const ScenarioResult& result : results) {
        seen.insert(result.kind);
        EXPECT_EQ(classes[result.index], static_cast<std::uint8_t>(result.kind));
        EXPECT_EQ(counts[result.index], result.pair_count);
        std::set<std::uint32_t> triangles;
        for (const ContactPair& pair : result.pairs) {
            triangles.insert(pair.a);
        }
        for (const std::uint32_t triangle : triangles) {
            ++in_contact[triangle];
        }
    }
    EXPECT_GE(seen.size(), 2u);
    const auto map = viewed->map(0).value();
    ASSERT_EQ(map.size(), in_contact.size());
    for (const TriangleContacts& each : map) {
        EXPECT_EQ(each.scenarios, in_contact[each.triangle]);
    }
    EXPECT_EQ(viewed->map(2).error().code, ErrorCode::NotFound);
    const auto sample = viewed->classes({0, 0, 7}).value();
    for (std::uint64_t i = 0; i < sample.size(); ++i) {
        EXPECT_EQ(sample[i], classes[i * scenarios / 7]);
    }
    EXPECT_FALSE(viewed->classes({1, scenarios}));
    EXPECT_FALSE(viewed->poses({1, scenarios}));
}

TEST_F(ViewedRecords, TheWorstScenariosAreTheWorstByClassThenByPairs) {
    for (const std::string level : {"any", "pairs"}) {
        const auto viewed = view("level = \"" + level + "\"\n");
        auto results = records();
        std::erase_if(results, [](const ScenarioResult& result) {
            return !touches(result) && result.kind != ScenarioClass::Contact;
        });
        std::ranges::stable_sort(results, std::greater(), badness_of);
        ASSERT_GT(results.size(), 20u);
        for (const std::size_t count : {std::size_t{0}, std::size_t{20}, results.size() + 1}) {
            std::vector<std::uint64_t> expected;
            for (std::size_t i = 0; i < std::min(count, results.size()); ++i) {
                expected.push_back(results[i].index);
            }
            EXPECT_EQ(viewed->worst(count), expected) << level;
        }
    }
}

TEST_F(ViewedRecords, TheDescriptionIsThatOfTheRun) {
    const auto viewed = view("level = \"pairs\"\nlimit_pairs = 3\n");
    const JobView job = viewed->view("folder");
    const RunReport report = read_summary(folder_ / "out/summary.json").value();
    EXPECT_EQ(job.row.id, "folder");
    EXPECT_EQ(job.row.state, "done");
    EXPECT_EQ(job.row.status.digest, report.digest);
    EXPECT_EQ(job.row.status.summary.cross, report.summary.cross);
    EXPECT_EQ(job.row.status.summary.pairs, report.summary.pairs);
    EXPECT_EQ(job.row.status.summary.cut, report.summary.cut);
    EXPECT_GT(job.row.status.summary.cut, 0u);
    EXPECT_GT(job.row.status.began, 0u);
    EXPECT_TRUE(job.map.exists);
    EXPECT_EQ(job.map.first_pairs, 3u);
    ASSERT_EQ(job.bodies.size(), 2u);
    EXPECT_EQ(job.bodies[0].parts, 2u);
    EXPECT_EQ(job.bodies[0].is_closed, true);
    EXPECT_EQ(job.bodies[0].bytes, viewed->mesh(job.bodies[0].body.mesh)->canonical_bytes().size());
    ASSERT_EQ(job.poses.axes.size(), 6u);
    EXPECT_EQ(job.poses.axes[5].last, 40);
    EXPECT_EQ(fs::file_size(viewed->mesh_path(job.bodies[1].body.mesh)), job.bodies[1].bytes);
}

TEST_F(ViewedRecords, PosesAreThoseOfTheScenarios) {
    const auto viewed = view("level = \"count\"\n");
    const PoseRows rows = viewed->poses({10, 5}).value();
    ASSERT_EQ(rows.numbers.size(), 60u);
    const auto one = viewed->scenario(12, never()).value();
    const auto pose = pose_rows(one->poses.b);
    EXPECT_TRUE(std::equal(pose.begin(), pose.end(), rows.numbers.begin() + 24));
    const PoseRows sample = viewed->poses({0, 0, 4}).value();
    const PoseRows whole = viewed->poses({0, scenarios}).value();
    EXPECT_TRUE(std::equal(sample.numbers.begin() + 36,
                           sample.numbers.end(),
                           whole.numbers.begin() + 12 * (3 * scenarios / 4)));
    EXPECT_EQ(viewed->map(0).error().code, ErrorCode::NotFound);
}

TEST_F(ViewedRecords, TheNextContactIsTheNearestOneAlsoOfAPart) {
    const auto viewed = view("level = \"pairs\"\n");
    const auto results = records();
    const auto meshes = viewed->mesh(viewed->manifest().bodies[0].mesh);
    const Part right = meshes->parts()[1];
    const auto is_right = [&](const ScenarioResult& result) {
        return std::ranges::any_of(result.pairs, [&](const ContactPair& pair) {
            return right.triangles_begin <= pair.a && pair.a < right.triangles_end;
        });
    };
    for (std::uint64_t from = 0; from < scenarios; from += 9) {
        for (const std::string part : {"", "right"}) {
            std::optional<std::uint64_t> after;
            std::optional<std::uint64_t> before;
            for (const ScenarioResult& result : results) {
                const bool fits = touches(result) && (part.empty() || is_right(result));
                if (fits && result.index > from && !after) {
                    after = result.index;
                }
                if (fits && result.index < from) {
                    before = result.index;
                }
            }
            EXPECT_EQ(viewed->next({from, false, part, ""}).value().scenario, after);
            EXPECT_EQ(viewed->next({from, true, part, ""}).value().scenario, before);
        }
    }
    EXPECT_THAT(viewed->next({0, false, "no", ""}).error().detail, HasSubstr("has no part 'no'"));
    EXPECT_FALSE(viewed->next({UINT64_MAX, false, "", ""}).value().scenario);
    const auto groups = viewed->view("folder").groups;
    ASSERT_TRUE(groups);
    EXPECT_EQ(groups->total, 2u);
    for (const GroupView& group : groups->rows) {
        const auto in_contact = [&](const ScenarioResult& result) {
            return (group.part_a == "right") == is_right(result) && !result.pairs.empty();
        };
        EXPECT_EQ(group.scenarios,
                  static_cast<std::uint64_t>(std::ranges::count_if(results, in_contact)));
        EXPECT_NEAR(group.share, static_cast<double>(group.scenarios) / scenarios, 1e-12);
    }
    const auto counted = view("level = \"count\"\nmaps = true\n")->view("folder").groups;
    ASSERT_TRUE(counted);
    ASSERT_EQ(counted->rows.size(), 2u);
    for (const GroupView& group : counted->rows) {
        const auto listed = std::ranges::find(groups->rows, group.part_a, &GroupView::part_a);
        ASSERT_NE(listed, groups->rows.end());
        EXPECT_EQ(group.scenarios, listed->scenarios);
        EXPECT_EQ(group.pairs, listed->pairs);
        EXPECT_EQ(group.worst, listed->worst);
        EXPECT_EQ(group.worst_class, ScenarioClass::Cross);
    }
    EXPECT_FALSE(view("level = \"count\"\n")->view("folder").groups);
}

TEST_F(ViewedRecords, PartsAreThoseOfTheGroupsAndLeadToTheNextContact) {
    for (const std::string level : {"pairs", "count"}) {
        const auto viewed = view("level = \"" + level + "\"\nmaps = true\n");
        const auto groups = viewed->view("folder").groups;
        ASSERT_TRUE(groups);
        const auto a = viewed->parts(0).value();
        const auto b = viewed->parts(1).value();
        EXPECT_EQ(a->names.size(), 2u);
        EXPECT_EQ(b->names.size(), 1u);
        EXPECT_EQ(viewed->parts(2).error().code, ErrorCode::NotFound);
        for (const GroupView& group : groups->rows) {
            EXPECT_THAT(a->names, testing::Contains(group.part_a));
            EXPECT_THAT(b->names, testing::Contains(group.part_b));
        }
    }
}

TEST_F(ViewedRecords, TheNextContactOfAPieceIsFound) {
    const auto viewed = view("level = \"pairs\"\n", true);
    const auto pieces = viewed->parts(0).value();
    EXPECT_THAT(pieces->names, testing::ElementsAre("piece 1", "piece 2"));
    const auto group = viewed->view("folder").groups->rows.front();
    const std::uint64_t worst = group.worst;
    EXPECT_THAT(pieces->names, testing::Contains(group.part_a));
    const auto found =
        viewed->next({worst - 1, false, group.part_a, group.part_b}).value().scenario;
    EXPECT_EQ(found, worst);
    EXPECT_THAT(viewed->next({0, false, "whole", ""}).error().detail, HasSubstr("no part 'whole'"));
}

TEST_F(ViewedRecords, EachScenarioIsVerifiedAndDrawnAtAnyLevel) {
    for (const std::string query : {"level = \"any\"\n",
                                    "level = \"count\"\n",
                                    "level = \"pairs\"\nlimit_pairs = 2\n",
                                    "level = \"contacts\"\n"}) {
        const auto viewed = view(query);
        for (std::uint64_t number = 0; number < scenarios; number += 13) {
            const auto shown = viewed->scenario(number, never());
            ASSERT_TRUE(shown) << shown.error().detail;
            EXPECT_EQ(shown.value()->verified, true) << shown.value()->verify_note;
            ASSERT_NE(shown.value()->drawn, nullptr);
            EXPECT_EQ(shown.value()->draw_note, "");
            const ScenarioResult& drawn = *shown.value()->drawn;
            EXPECT_EQ(drawn.level, Level::Contacts);
            EXPECT_EQ(drawn.pairs.size(), drawn.pair_count);
            if (query.find("any") == std::string::npos) {
                EXPECT_EQ(drawn.pair_count, shown.value()->result->pair_count);
                EXPECT_EQ(drawn.kind, shown.value()->result->kind);
            }
        }
    }
}

TEST_F(ViewedRecords, AWrongRecordIsTold) {
    view("level = \"count\"\n");
    std::uint64_t wrong = 0;
    for (const ScenarioResult& result : records()) {
        wrong = result.pair_count > 1 ? result.index : wrong;
    }
    change(wrong, [](ScenarioResult& result) { ++result.pair_count; });
    const auto shown = open()->scenario(wrong, never()).value();
    EXPECT_EQ(shown->verified, false);
    EXPECT_THAT(shown->verify_note, HasSubstr("a second run here"));
    EXPECT_NE(shown->drawn, nullptr);
}

TEST_F(ViewedRecords, NearScenariosAreFoundAndCounted) {
    view("level = \"pairs\"\n");
    const auto before = records();
    std::vector<std::uint64_t> free;
    for (const ScenarioResult& result : before) {
        if (result.kind == ScenarioClass::Separate) {
            free.push_back(result.index);
        }
    }
    ASSERT_GT(free.size(), 3u);
    const auto make_near = [](std::uint64_t pairs) {
        return [pairs](ScenarioResult& result) {
            result.has_clearance = true;
            result.kind = ScenarioClass::Near;
            result.near_count = pairs;
            result.pairs = {{0, 0, PairClass::Near}};
        };
    };
    change(free[1], make_near(4));
    change(free[3], make_near(6));
    const auto viewed = open();
    using Kind = NextContact::Kind;
    EXPECT_EQ(viewed->next({0, false, "", "", Kind::Near}).value().scenario, free[1]);
    EXPECT_EQ(viewed->next({free[1], false, "left", "", Kind::Near}).value().scenario, free[3]);
    EXPECT_FALSE(viewed->next({0, false, "right", "", Kind::Near}).value().scenario);
    EXPECT_NE(viewed->next({0, false, "", "", Kind::Contact}).value().scenario, free[1]);
    const JobView job = viewed->view("folder");
    EXPECT_EQ(job.row.status.summary.near, 2u);
    EXPECT_EQ(job.row.status.summary.near_pairs, 10u);
    EXPECT_EQ(viewed->counts({free[3], 1}).value(), std::vector<std::uint32_t>{6});
    ASSERT_TRUE(job.groups);
    std::uint64_t near = 0;
    for (const GroupView& group : job.groups->rows) {
        near += group.near;
    }
    EXPECT_EQ(near, 2u) << "the lists have one near pair each";
    const auto worst = viewed->worst(scenarios);
    ASSERT_GT(worst.size(), 2u);
    EXPECT_EQ(worst[worst.size() - 2], free[3]) << "after all contacts, by near pairs";
    EXPECT_EQ(worst.back(), free[1]);
}

TEST_F(ViewedRecords, DistancesAreThoseOfTheRecords) {
    view("level = \"any\"\n");
    std::vector<std::uint64_t> apart;
    for (const ScenarioResult& result : records()) {
        if (result.kind == ScenarioClass::Separate) {
            apart.push_back(result.index);
        }
    }
    ASSERT_GT(apart.size(), 3u);
    EXPECT_TRUE(std::isnan(open()->distances({apart[0], 1}).value()[0])) << "no record has one";
    const auto make_apart = [](double distance) {
        return [distance](ScenarioResult& result) {
            result.question = Question::Distance;
            result.nearest = NearestWitness{distance, 0, 0};
        };
    };
    change(apart[0], make_apart(0.5));
    change(apart[1], make_apart(0.25));
    change(apart[2], make_apart(0.5));
    const auto viewed = open();
    const auto distances = viewed->distances({0, scenarios}).value();
    EXPECT_EQ(distances[apart[0]], 0.5);
    EXPECT_EQ(distances[apart[1]], 0.25);
    EXPECT_TRUE(std::isnan(distances[apart[3]]));
    EXPECT_FALSE(viewed->distances({1, scenarios}));
    const auto worst = viewed->worst(scenarios);
    ASSERT_GT(worst.size(), 3u);
    EXPECT_EQ((std::vector<std::uint64_t>(worst.end() - 3, worst.end())),
              (std::vector<std::uint64_t>{apart[1], apart[0], apart[2]}))
        << "after all contacts, the nearest first";
    EXPECT_EQ(viewed->worst(worst.size() - 2).back(), apart[1]);
}

TEST_F(ViewedRecords, WhatAnEarlierVersionLeftUndecidedIsDrawnAndNotCompared) {
    view("level = \"count\"\n");
    change(50, [](ScenarioResult& result) {
        result.kind = ScenarioClass::Undecided;
        result.pair_count = 0;
        result.distance_bound = 0.25;
    });
    const auto shown = open()->scenario(50, never()).value();
    EXPECT_EQ(shown->result->kind, ScenarioClass::Undecided);
    EXPECT_FALSE(shown->verified);
    EXPECT_THAT(shown->verify_note, HasSubstr("left it undecided"));
    EXPECT_NE(shown->drawn, nullptr);
}

TEST_F(ViewedRecords, AStoppedRunShowsNoContacts) {
    const auto viewed = view("level = \"count\"\n");
    const auto shown = viewed->scenario(50, [] { return true; }).value();
    EXPECT_FALSE(shown->verified);
    EXPECT_EQ(shown->drawn, nullptr);
    EXPECT_THAT(shown->verify_note, HasSubstr("takes too long"));
    EXPECT_THAT(shown->draw_note, HasSubstr("takes too long"));
    EXPECT_EQ(viewed->scenario(scenarios, never()).error().code, ErrorCode::NotFound);
}

} // namespace cd::tests
