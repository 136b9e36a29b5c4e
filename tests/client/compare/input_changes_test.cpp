// Proves that results are reused only for equal bodies and questions, and that what differs is
// named.
#include "client/compare/input_changes.hpp"

#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

/// A job of two boxes that asks `query`.
PreparedJob job_of(const Query& query) {
    PreparedJob job;
    job.meshes = {share(make_box({1, 1, 1})), share(make_box({2, 1, 1}))};
    job.names = {"a", "b"};
    job.query = query;
    return job;
}

/// The run of such a job.
RunManifest run_of(const Query& query) {
    RunManifest run;
    for (const auto& mesh : job_of(query).meshes) {
        ManifestBody body;
        body.mesh = mesh->hash();
        run.bodies.push_back(body);
    }
    run.query = query;
    return run;
}

Query of_motions(double resolution, Until until) {
    Query query;
    query.level = Level::Any;
    query.question = Question::Motion;
    query.motion = MotionQuery{resolution, until};
    return query;
}

/// Returns why the results of a run of `was` are none of `is`; empty if they are.
std::string refusal(const Query& was, const Query& is) {
    const Status status = check_reusable(run_of(was), job_of(is));
    return status ? "" : status.error().detail;
}

} // namespace

TEST(InputChanges, MotionsOfAnotherResolutionOrEndAreNotReused) {
    const Query query = of_motions(0.01, Until::Contact);
    EXPECT_EQ(refusal(query, query), "");
    EXPECT_EQ(refusal(query, of_motions(0.001, Until::Contact)),
              "nothing can be reused: query changed (motion until contact with resolution 0.001, "
              "was until contact with resolution 0.01)");
    EXPECT_EQ(refusal(query, of_motions(0.01, Until::Free)),
              "nothing can be reused: query changed (motion until free with resolution 0.01, was "
              "until contact with resolution 0.01)");
    Query at_rest;
    at_rest.level = Level::Any;
    EXPECT_EQ(refusal(query, at_rest),
              "nothing can be reused: query changed (motion none, was until contact with "
              "resolution 0.01)");
}

TEST(InputChanges, TheFirstLineOfADiffNamesAnotherQuestionOfMotions) {
    const RunManifest was = run_of(of_motions(0.01, Until::End));
    EXPECT_EQ(changes_text(changes_between(was, was)), "bodies equal, poses changed, query equal");
    EXPECT_EQ(changes_text(changes_between(was, run_of(of_motions(0.02, Until::End)))),
              "bodies equal, poses changed, query changed (motion until end with resolution 0.02, "
              "was until end with resolution 0.01)");
}

} // namespace cd::tests
