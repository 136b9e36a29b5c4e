// Proves what is said of moving meshes against the truth: exact contacts at all 2^K instants, and
// the rational time of impact where the bodies do not turn. Each hard case is a mesh.

#include "common/motion/cells.hpp"
#include "common/motion/tree_questions.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/cut_trees.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cd::tests {

namespace {

/// Two trees, and their motion between two keys.
struct MovingBodies {
    ObbTree a;
    ObbTree b;
    Motion motion;

    MovingBodies(const Mesh& mesh_a,
                 const Mesh& mesh_b,
                 const PosePair& from,
                 const PosePair& to,
                 double resolution)
        : a(make_tree(mesh_a)),
          b(make_tree(mesh_b)),
          motion(make_motion(from,
                             to,
                             {body_radius(mesh_a.vertices()), body_radius(mesh_b.vertices())},
                             resolution)) {}
};

/// Searches a motion of the whole bodies, or of `cut`.
MotionAnswer answer_of(const SubtreePair& whole,
                       const Motion& motion,
                       Until until,
                       std::optional<double> clearance = {},
                       const CutBodies* cut = nullptr) {
    const auto search =
        make_search(whole.a, whole.b, PosePair{}, {}, {.clearance = clearance.value_or(0)});
    const MovingTrees trees = cut != nullptr ? MovingTrees(cut) : MovingTrees(whole);
    TreeQuestions questions(*search, trees, clearance);
    return search_cells(motion, until, clearance.value_or(0), questions.for_cells());
}

MotionAnswer answer_of(const MovingBodies& bodies,
                       Until until,
                       std::optional<double> clearance = {},
                       const CutBodies* cut = nullptr) {
    return answer_of({bodies.a.view(), bodies.b.view()}, bodies.motion, until, clearance, cut);
}

/// Decides the event at all 2^K + 1 instants.
std::vector<bool> events_of(const MovingBodies& bodies, std::optional<double> clearance) {
    const TreeView a = bodies.a.view();
    const TreeView b = bodies.b.view();
    const auto search = make_search(a, b, PosePair{}, {}, {.clearance = clearance});
    const unsigned depth = bodies.motion.depth();
    EXPECT_LE(depth, 12u);
    std::vector<bool> events;
    for (std::uint32_t instant = 0; instant <= 1u << depth; ++instant) {
        search->restart(bodies.motion.at(instant, depth));
        events.push_back(clearance ? search->any_near(a, b) != Nearness::Far : search->any(a, b));
    }
    return events;
}

/// Whether the bodies are nearer than an open leaf allows, at every instant of the run.
bool stays_near(const MovingBodies& bodies, const CellRun& run, double distance) {
    const TreeView a = bodies.a.view();
    const TreeView b = bodies.b.view();
    const auto search = make_search(a, b, PosePair{}, {}, {.clearance = distance});
    for (std::uint32_t instant = run.first; instant <= run.end(); ++instant) {
        search->restart(bodies.motion.at(instant, bodies.motion.depth()));
        if (search->any_near(a, b) == Nearness::Far) {
            return false;
        }
    }
    return true;
}

void expect_true_runs(const MovingBodies& bodies,
                      const MotionAnswer& whole,
                      const std::vector<bool>& events,
                      double clearance) {
    std::uint32_t next = 0;
    for (const CellRun& run : whole.runs) {
        EXPECT_EQ(run.first, next);
        next = run.end();
        const auto begin = events.begin() + run.first;
        const bool any = std::find(begin, begin + run.count + 1, true) != begin + run.count + 1;
        if (run.state == CellState::Free) {
            EXPECT_FALSE(any) << "a free run from " << run.first << " has the event";
            EXPECT_FALSE(run.has_event());
            continue;
        }
        if (run.has_event()) {
            EXPECT_TRUE(events[run.event_first]);
            EXPECT_TRUE(events[run.event_last]);
        }
        EXPECT_GE(whole.open_within, clearance);
        EXPECT_TRUE(stays_near(bodies, run, clearance + 2 * bodies.motion.resolution()));
    }
    EXPECT_EQ(next + 1, events.size());
}

/// Compares the answers to all three questions with each other.
void expect_agreement(const MovingBodies& bodies,
                      const MotionAnswer& whole,
                      std::optional<double> clearance) {
    const MotionAnswer first = answer_of(bodies, Until::Contact, clearance);
    EXPECT_EQ(first.end, whole.end);
    EXPECT_EQ(first.t0, whole.t0);
    EXPECT_EQ(first.t1, whole.t1);
    const MotionAnswer free = answer_of(bodies, Until::Free, clearance);
    const auto way_out = std::ranges::find(whole.runs, CellState::Free, &CellRun::state);
    EXPECT_EQ(free.end == MotionEnd::Free, way_out != whole.runs.end());
    if (way_out != whole.runs.end()) {
        EXPECT_EQ(free.t1, way_out->first);
    }
}

/// Compares the answer of cut trees with that of whole ones.
void expect_cut_agreement(const MovingBodies& bodies,
                          const MotionAnswer& whole,
                          std::optional<double> clearance) {
    for (const std::uint32_t depth : {1u, 3u}) {
        const CutTrees trees(bodies.a, bodies.b, depth);
        const CutBodies cut = trees.bodies();
        const MotionAnswer answer = answer_of(bodies, Until::End, clearance, &cut);
        EXPECT_EQ(answer.runs, whole.runs) << "cut at depth " << depth;
        EXPECT_EQ(answer.cells, whole.cells);
        EXPECT_EQ(answer.open_within, whole.open_within);
    }
}

/// Checks everything that is said of the motion, and returns the whole answer.
MotionAnswer checked_answer(const MovingBodies& bodies, std::optional<double> clearance = {}) {
    const std::vector<bool> events = events_of(bodies, clearance);
    const MotionAnswer whole = answer_of(bodies, Until::End, clearance);
    expect_true_runs(bodies, whole, events, clearance.value_or(0));
    expect_agreement(bodies, whole, clearance);
    expect_cut_agreement(bodies, whole, clearance);
    const auto first = std::ranges::find(events, true) - events.begin();
    if (whole.end == MotionEnd::Free) {
        return whole;
    }
    EXPECT_TRUE(events[whole.t1]);
    EXPECT_EQ(whole.end == MotionEnd::Start, events[0]);
    EXPECT_LE(whole.t0, first);
    EXPECT_LE(first, whole.t1);
    return whole;
}

const Pose at_origin = moved_pose({0, 0, 0});

PosePair b_at(const Pose& b) {
    return {at_origin, b};
}

PosePair b_at(const Vec3& place) {
    return b_at(moved_pose(place));
}

const Mesh& unit_box() {
    static const Mesh box = make_gridded_box(Vec3(1, 1, 1), 3);
    return box;
}

TEST(MotionSearch, TheTimeOfImpactOfATranslationIsInTheBracket) {
    std::uint64_t contacts = 0;
    for (SeededRandom random : seeds(20)) {
        const double from = uniform(random, 1.1, 4);
        const double to = uniform(random, -3, 1.5);
        const MovingBodies bodies(
            unit_box(), unit_box(), b_at({from, 0.3, 0.2}), b_at({to, 0.3, 0.2}), 2e-3);
        const MotionAnswer answer = checked_answer(bodies);
        // The faces meet where B's centre is at 1.
        const unsigned depth = bodies.motion.depth();
        const mpq_class start(bodies.motion.at(0, 0).b.translation().x());
        const mpq_class end(bodies.motion.at(1, 0).b.translation().x());
        ASSERT_EQ(answer.end == MotionEnd::Contact, end <= 1);
        if (end <= 1) {
            ++contacts;
            const mpq_class impact = (start - 1) / (start - end) * (mpz_class(1) << depth);
            EXPECT_LE(mpq_class(answer.t0), impact);
            EXPECT_LE(impact, mpq_class(answer.t1));
            EXPECT_LE(answer.t1 - answer.t0, 2u);
        }
    }
    EXPECT_GT(contacts, 10u);
    EXPECT_LT(contacts, 20u);
}

TEST(MotionSearch, ADoorMeetsWhatIsInItsWay) {
    const Mesh door = make_box_between({0, -0.02, 0}, {1, 0.02, 2});
    const Mesh stop = make_box_between({0.6, 0.5, 0}, {0.8, 0.7, 0.1});
    const MovingBodies bodies(
        stop, door, b_at(at_origin), b_at(turned_pose(90, Vec3(0, 0, 1))), 1e-3);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_LE(answer.t1 - answer.t0, 3u);
    // The edge of the door's front meets the corner (0.8, 0.5) at this angle.
    const double angle = std::atan2(0.5, 0.8) - std::asin(0.02 / std::hypot(0.5, 0.8)); // Radians.
    const auto angle_at = [&](std::uint32_t instant) {
        const Quaternion q = bodies.motion.at(instant, answer.depth).b.quaternion();
        return 2 * std::atan2(q.z, q.w);
    };
    EXPECT_LE(angle_at(answer.t0), angle + 1e-12);
    EXPECT_GE(angle_at(answer.t1), angle - 1e-12);
}

TEST(MotionSearch, BodiesThatRideTogetherAreFreeInFewCells) {
    const double degrees = 20;
    const Vec3 axis(0, 0, 1);
    const Vec3 arm(1.05, 0, 0);
    const Vec3 move(30, 2, 0);
    const Vec3 carried = turned_pose(degrees, axis).apply(arm);
    const MovingBodies bodies(
        unit_box(),
        unit_box(),
        {at_origin, moved_pose(arm)},
        {turned_pose(degrees, axis, move), turned_pose(degrees, axis, move + carried)},
        5e-3);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Free);
    EXPECT_EQ(answer.runs.size(), 1u);
    // A bound in the world alone would need cells in which no body moves by more than the gap of
    // 0.05: 30 / 0.05 = 600.
    EXPECT_LT(answer.cells, 60u);
}

// The closest approach is 0.25 exactly: B passes A sideways.
TEST(MotionSearch, AGrazingGapThatEqualsTheClearanceIsAnEvent) {
    const MovingBodies bodies(
        unit_box(), unit_box(), b_at({1.25, -3, 0}), b_at({1.25, 3, 0}), 0x1p-7);
    EXPECT_EQ(checked_answer(bodies, 0.25).end, MotionEnd::Contact);
    const MotionAnswer below = checked_answer(bodies, std::nextafter(0.25, 0.0));
    EXPECT_EQ(below.end, MotionEnd::Free);
    ASSERT_EQ(below.runs.size(), 3u);
    EXPECT_EQ(below.runs[1].state, CellState::Open);
    EXPECT_FALSE(below.runs[1].has_event());
    EXPECT_EQ(checked_answer(bodies).runs.size(), 1u);
}

// M of a leaf is at most the resolution, so a gap above it is free and contact is open.
TEST(MotionSearch, AGapAsLargeAsTheResolutionIsDecidedExactly) {
    const double step = 0x1p-6;
    const auto runs_with_gap = [&](double gap) {
        const MovingBodies bodies(unit_box(),
                                  unit_box(),
                                  b_at({1 + gap, -2, 0}),
                                  b_at({1 + gap, 2, 0}),
                                  step * (1 + 0x1p-30));
        // M of a leaf is the step, and slightly more.
        EXPECT_EQ(bodies.motion.depth(), 7u);
        return checked_answer(bodies).runs.size();
    };
    EXPECT_EQ(runs_with_gap(step), 3u);
    EXPECT_EQ(runs_with_gap(step * (1 + 0x1p-20)), 1u);
    EXPECT_EQ(runs_with_gap(0), 3u);
}

TEST(MotionSearch, AContactAtTheStartHasAWayOut) {
    const MovingBodies bodies(
        unit_box(), unit_box(), b_at({0.8, 0.1, 0.1}), b_at({2.8, 0.1, 0.1}), 1e-3);
    const MotionAnswer whole = checked_answer(bodies);
    EXPECT_EQ(whole.end, MotionEnd::Start);
    const MotionAnswer out = answer_of(bodies, Until::Free);
    EXPECT_EQ(out.end, MotionEnd::Free);
    // The faces part at x = 1, after 0.2 of 2.
    const double part = std::ldexp(0.1, static_cast<int>(out.depth));
    EXPECT_LE(out.t0, part);
    EXPECT_GE(out.t1, part);
    EXPECT_LE(out.t1 - out.t0, 3u);
}

TEST(MotionSearch, NothingTunnelsThroughAThinWall) {
    const Mesh wall = make_box(Vec3(1e-6, 2, 2));
    const Mesh bullet = make_box(Vec3(0.02, 0.02, 0.02));
    const MovingBodies bodies(wall, bullet, b_at({-5, 0.1, 0.3}), b_at({5.1, 0.1, 0.3}), 4e-3);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_LE(answer.t1 - answer.t0, 3u);
}

// Two plates cross between two instants: no instant has a contact, and none is claimed, but the
// crossing is never said to be free.
TEST(MotionSearch, AThinPlateLeavesAnOpenRun) {
    const Mesh wall = make_box(Vec3(1e-6, 2, 2));
    const Mesh plate = make_soup({{0, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}});
    const MovingBodies bodies(wall, plate, b_at({-5, 0, 0}), b_at({5.1, 0, 0}), 4e-3);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Free);
    ASSERT_EQ(answer.runs.size(), 3u);
    const CellRun& open = answer.runs[1];
    EXPECT_FALSE(open.has_event());
    const double crossing = std::ldexp(5 / 10.1, static_cast<int>(answer.depth));
    EXPECT_LE(open.first, crossing);
    EXPECT_GE(open.end(), crossing);
    EXPECT_LE(open.count, 3u);
}

// At both keys the vehicles are past each other, as between two steps of a traffic simulation.
TEST(MotionSearch, HeadOnVehiclesThatJumpPastEachOtherCollide) {
    const Mesh car = make_gridded_box(Vec3(4.5, 1.8, 1.5), 2);
    const Pose back = turned_pose(180, Vec3(0, 0, 1), {10, 0.4, 0});
    const MovingBodies bodies(
        car,
        car,
        {moved_pose({-10, 0, 0}), back},
        {moved_pose({10, 0, 0}), Pose::from_quaternion(back.quaternion(), {-10, 0.4, 0})},
        0.01);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    // Each drives until the centres are 4.5 apart.
    const double impact = std::ldexp((20 - 4.5) / 40, static_cast<int>(answer.depth));
    EXPECT_LE(answer.t0, impact + 1e-6);
    EXPECT_GE(answer.t1, impact - 1e-6);
}

// Both boxes move, each towards the other, and signed bounds of their motions would cancel out:
// FCL's conservative advancement misses such contacts (its issue 555).
TEST(MotionSearch, BoxesThatMoveTowardsEachOtherMeet) {
    const Mesh upper = make_box_between({-1, -1, 3}, {1, 1, 5});
    const Mesh lower = make_box_between({-1, -1, -5}, {1, 1, -3});
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 1, 0)}) {
        const Pose turned = turned_pose(90, axis);
        const Vec3 up = turned.apply(Vec3(0, 0, 1));
        const auto at_height = [&](double height) {
            return Pose::from_quaternion(turned.quaternion(), height * up);
        };
        const MovingBodies bodies(
            upper, lower, {at_height(0), at_height(0)}, {at_height(-4), at_height(4)}, 1e-3);
        const MotionAnswer answer = checked_answer(bodies);
        EXPECT_EQ(answer.end, MotionEnd::Contact);
        // Faces that are 6 apart meet after 3 of 4.
        const double impact = std::ldexp(0.75, static_cast<int>(answer.depth));
        EXPECT_LE(answer.t0, impact + 1e-6);
        EXPECT_GE(answer.t1, impact - 1e-6);
        EXPECT_LE(answer.t1 - answer.t0, 3u);
    }
}

TEST(MotionSearch, ALongSlideIsFree) {
    const MovingBodies bodies(
        make_box(Vec3(6, 1, 1)), unit_box(), b_at({-1, 0, 1.001}), b_at({1, 0, 1.001}), 5e-4);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Free);
    EXPECT_EQ(answer.runs.size(), 1u);
    // A cell is free if B moves by less than 2 mm in it.
    EXPECT_GT(answer.cells, 1000u);
}

TEST(MotionSearch, ASlideInContactIsOpenThroughout) {
    const MovingBodies bodies(
        make_box(Vec3(6, 1, 1)), unit_box(), b_at({-1, 0, 1}), b_at({1, 0, 1}), 4e-3);
    const MotionAnswer answer = checked_answer(bodies);
    EXPECT_EQ(answer.end, MotionEnd::Start);
    ASSERT_EQ(answer.runs.size(), 1u);
    EXPECT_EQ(answer.runs[0].event_first, 0u);
    EXPECT_EQ(answer.runs[0].event_last, answer.runs[0].end());
}

TEST(MotionSearch, AlmostAHalfTurnSweepsTheSideItTurnsTo) {
    const Mesh bar = make_box_between({0.2, -0.01, -0.01}, {2, 0.01, 0.01});
    const Mesh post = make_box(Vec3(0.1, 0.1, 0.1));
    const auto turned_to = [&](double degrees, double y) {
        const MovingBodies bodies(post,
                                  bar,
                                  {moved_pose({0, y, 0}), at_origin},
                                  {moved_pose({0, y, 0}), turned_pose(degrees, Vec3(0, 0, 1))},
                                  4e-3);
        return checked_answer(bodies).end;
    };
    EXPECT_EQ(turned_to(179, 1.5), MotionEnd::Contact);
    EXPECT_EQ(turned_to(-179, -1.5), MotionEnd::Contact);
    EXPECT_EQ(turned_to(179, -1.5), MotionEnd::Free);
    EXPECT_EQ(turned_to(-179, 1.5), MotionEnd::Free);
}

TEST(MotionSearch, EqualKeysAreOnePose) {
    const Pose turned = turned_pose(33, Vec3(0, 0, 1), {1.3, 0, 0});
    const MovingBodies apart(unit_box(), unit_box(), b_at(turned), b_at(turned), 1e-3);
    const MotionAnswer free = checked_answer(apart);
    EXPECT_EQ(free.end, MotionEnd::Free);
    EXPECT_EQ(free.cells, 1u);
    EXPECT_EQ(free.depth, 0u);
    const MovingBodies touching(unit_box(), unit_box(), b_at({1, 0, 0}), b_at({1, 0, 0}), 1e-3);
    EXPECT_EQ(checked_answer(touching).end, MotionEnd::Start);
}

TEST(MotionSearch, BothTreeFormsGiveOneAnswer) {
    const MovingBodies bodies(make_sphere(3),
                              make_sphere(2),
                              b_at({3, 0.5, 0}),
                              b_at(turned_pose(50, Vec3(0, 0, 1), {-3, 0.2, 0})),
                              1e-2);
    std::vector<MotionAnswer> answers;
    for (std::size_t form = 0; form < 2; ++form) {
        const SubtreePair trees{forms_of(bodies.a)[form], forms_of(bodies.b)[form]};
        answers.push_back(answer_of(trees, bodies.motion, Until::End, 0.1));
    }
    EXPECT_EQ(answers[0].runs, answers[1].runs);
    EXPECT_EQ(answers[0].cells, answers[1].cells);
    EXPECT_EQ(answers[0].end, MotionEnd::Contact);
}

TEST(MotionSearch, AgreesWithAllInstantsOnRandomMotions) {
    std::uint64_t contacts = 0;
    constexpr std::uint64_t rounds = 30;
    for (SeededRandom random : seeds(rounds)) {
        const Mesh a = make_triangle_soup(random, 20, 0.4);
        const Mesh b = make_triangle_soup(random, 20, 0.4);
        const PosePair from{make_pose(random, 2), make_pose(random, 2)};
        const auto moved = [&](const Pose& pose) {
            return key_after(
                pose, uniform(random, 0, 90), random_axis(random), random_point(random, 2));
        };
        const Pose to_a = moved(from.a);
        const PosePair to{to_a, moved(from.b)};
        const MovingBodies bodies(a, b, from, to, 0.02);
        const std::optional<double> clearance =
            random() % 2 == 0 ? std::nullopt : std::optional(uniform(random, 0, 0.05));
        contacts += checked_answer(bodies, clearance).end == MotionEnd::Free ? 0u : 1u;
    }
    EXPECT_GT(contacts, rounds / 5);
    EXPECT_LT(contacts, rounds * 19 / 20);
}

} // namespace

} // namespace cd::tests
