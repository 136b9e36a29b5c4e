// Proves that a job tells its lines where it asks for their hits, and nowhere else.
#include "master/submission/submission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

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
