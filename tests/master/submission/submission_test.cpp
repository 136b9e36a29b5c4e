// Proves which bodies a submission may have: how many, of how many meshes, and what only two bodies
// may have; that ignored parts are of its bodies; and that a job tells its lines where it asks for
// their hits, and nowhere else.
#include "master/submission/submission.hpp"

#include "common/core/limits/engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

Sha256 mesh_of(std::uint64_t number) {
    Sha256 hash;
    for (std::size_t i = 0; i < sizeof(number); ++i) {
        hash.bytes[i] = static_cast<std::byte>(number >> (8 * i));
    }
    return hash;
}

/// A job with so many bodies, of so many meshes in turn, each of 100 triangles and more.
struct Bodies {
    explicit Bodies(std::size_t bodies, std::size_t meshes = 1) {
        for (std::uint64_t mesh = 0; mesh < meshes; ++mesh) {
            MeshStatus status;
            status.mesh = mesh_of(mesh);
            status.triangles = 100 + mesh;
            stored.push_back(status);
        }
        for (std::size_t body = 0; body < bodies; ++body) {
            submit.bodies.push_back({mesh_of(body % meshes), "b" + std::to_string(body)});
        }
    }
    /// Returns why the master refuses the job; empty if it takes it.
    [[nodiscard]] std::string refusal(const std::function<void(Submit&)>& change = [](Submit&) {
    }) const {
        Submit changed = submit;
        change(changed);
        const Status checked = check_submission(changed, stored);
        return checked ? "" : checked.error().detail;
    }

    Submit submit;
    std::vector<MeshStatus> stored;
};

Submit some_lines() {
    Submit submit;
    submit.bodies.resize(2);
    submit.query.question = Question::Shots;
    submit.poses.kind = PosesKind::Shots;
    submit.poses.shots = ShotsOrigin{0.5, 64, {0.5, 0.5}};
    submit.poses.axes.resize(2);
    return submit;
}

/// Returns the refusal of a submission after a change.
std::string refusal_of(const std::function<void(Submit&)>& change) {
    Submit submit = some_lines();
    change(submit);
    const std::vector<MeshStatus> stored(1);
    const Status checked = check_submission(submit, stored);
    return checked ? "taken" : checked.error().detail;
}

} // namespace

TEST(Submission, HasAtLeastTwoBodiesAndNotTooMany) {
    EXPECT_THAT(Bodies(1).refusal(), HasSubstr("at least two bodies, not 1"));
    EXPECT_EQ(Bodies(2).refusal(), "");
    EXPECT_EQ(Bodies(5, 3).refusal(), "");
    EXPECT_EQ(Bodies(limits::bodies_max, limits::body_meshes_max).refusal(), "");
    EXPECT_THAT(Bodies(limits::bodies_max + 1).refusal(), HasSubstr("16385 bodies"));
    EXPECT_THAT(Bodies(limits::bodies_max, limits::body_meshes_max + 1).refusal(),
                HasSubstr("4097 meshes"));
}

TEST(Submission, OfManyBodiesHasStoredMeshesAndDepthsOfItsBodies) {
    const Bodies five(5, 3);
    EXPECT_THAT(five.refusal([](Submit& job) { job.bodies[4].mesh = mesh_of(9); }),
                HasSubstr("not stored"));
    EXPECT_EQ(five.refusal([](Submit& job) { job.cluster.set_depth(4, 12); }), "");
    EXPECT_THAT(five.refusal([](Submit& job) { job.cluster.set_depth(4, 21); }),
                HasSubstr("depth of body b4 is 21"));
    EXPECT_THAT(five.refusal([](Submit& job) { job.cluster.set_depth(5, 12); }),
                HasSubstr("more distribution depths than bodies"));
}

TEST(Submission, HasAPriorityInItsRange) {
    const Bodies two(2);
    for (const std::int32_t priority : {-10, 0, 10}) {
        EXPECT_EQ(two.refusal([&](Submit& job) { job.priority = priority; }), "");
    }
    for (const std::int32_t priority : {-11, 11}) {
        EXPECT_EQ(two.refusal([&](Submit& job) { job.priority = priority; }),
                  "the priority is " + std::to_string(priority) + " and may be -10 to 10");
    }
}

TEST(Submission, TheOriginOfAMeshIsFinite) {
    const auto with_origin = [](double x) {
        return [x](Submit& job) { job.bodies[1].origin = {0.5, x, -2}; };
    };
    EXPECT_EQ(Bodies(2).refusal(with_origin(1e9)), "");
    for (const double x : {std::nan(""), -std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(Bodies(2).refusal(with_origin(x)), HasSubstr("mesh is not finite"));
    }
}

TEST(Submission, OfManyBodiesHasNoGridAndNoMaps) {
    const auto with_grid = [](Submit& job) {
        job.grid = Bytes(3);
        job.poses.kind = PosesKind::Grid;
    };
    const auto with_maps = [](Submit& job) { job.query.maps = true; };
    EXPECT_EQ(Bodies(2).refusal(with_grid), "");
    EXPECT_EQ(Bodies(2).refusal(with_maps), "");
    EXPECT_THAT(Bodies(3).refusal(with_grid), HasSubstr("a grid of poses is of two bodies"));
    EXPECT_THAT(Bodies(3).refusal(with_maps), HasSubstr("maps are of two bodies"));
}

TEST(Submission, IgnoresPartsOfItsBodies) {
    const Bodies five(5, 3); // Bodies 2 and 3 have 102 and 100 triangles.
    const auto ignoring = [](const IgnoredRange& range) {
        return [range](Submit& job) { job.query.ignored = {range}; };
    };
    EXPECT_EQ(five.refusal(ignoring({0, 102, 0, 100, 2, 3})), "");
    EXPECT_THAT(five.refusal(ignoring({0, 102, 0, 101, 2, 3})), HasSubstr("outside the meshes"));
    EXPECT_THAT(five.refusal(ignoring({0, 1, 0, 1, 3, 2})), HasSubstr("bodies 3 and 2"));
    EXPECT_THAT(five.refusal(ignoring({0, 1, 0, 1, 2, 2})), HasSubstr("bodies 2 and 2"));
    EXPECT_THAT(five.refusal(ignoring({0, 1, 0, 1, 4, 5})), HasSubstr("the job has 0 to 4"));
}

TEST(Submission, OfLinesTellsThemAndTheirTwoAxes) {
    EXPECT_EQ(refusal_of([](Submit&) {}), "taken");
    EXPECT_EQ(refusal_of([](Submit& s) { s.poses.axes.clear(); }), "taken") << "lines of a file";
    EXPECT_THAT(refusal_of([](Submit& s) { s.poses.axes.resize(6); }),
                HasSubstr("lines have two axes, not 6"));
    EXPECT_THAT(refusal_of([](Submit& s) { s.poses.shots.reset(); }),
                HasSubstr("a job tells its lines"));
    EXPECT_THAT(refusal_of([](Submit& s) { s.poses.kind = PosesKind::File; }),
                HasSubstr("a job tells its lines"));
    EXPECT_THAT(refusal_of([](Submit& s) { s.query.question = Question::Contacts; }),
                HasSubstr("asks for their hits"));
    EXPECT_THAT(refusal_of([](Submit& s) {
                    s.poses.kind = PosesKind::File;
                    s.poses.shots.reset();
                }),
                HasSubstr("a grid has six axes, not 2"));
}

} // namespace cd::tests
