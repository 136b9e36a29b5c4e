// Proves when a job warns that its clearance is large beside the triangles.
#include "client/job/clearance_warning.hpp"

#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Returns a mesh of right triangles in a row, whose longest edges are the given lengths.
std::shared_ptr<const Mesh> triangles_of(const std::vector<double>& edges) {
    MeshArrays arrays;
    for (const double edge : edges) {
        const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
        arrays.vertices.emplace_back(0, 0, 0);
        arrays.vertices.emplace_back(0.6 * edge, 0, 0);
        arrays.vertices.emplace_back(0, 0.8 * edge, 0);
        arrays.triangles.push_back({first, first + 1, first + 2});
    }
    return share(Mesh::create(std::move(arrays)).value());
}

PreparedJob job_with(double clearance) {
    PreparedJob job;
    job.names = {"car.obj", "post.stl"};
    job.spec.unit = "mm";
    job.meshes = {triangles_of({8}), triangles_of({1, 5, 100})};
    job.query.clearance = clearance;
    return job;
}

TEST(ClearanceWarning, TheMedianEdgeIsThatOfTheMiddleTriangle) {
    EXPECT_NEAR(median_edge(*triangles_of({100, 1, 5})), 5, 1e-12);
    EXPECT_NEAR(median_edge(*triangles_of({4, 3})), 4, 1e-12);
    EXPECT_EQ(median_edge(*triangles_of({0})), 0);
}

TEST(ClearanceWarning, NamesTheBodyWhoseTrianglesAreSmaller) {
    EXPECT_FALSE(clearance_warning(job_with(4.9)));
    const auto warning = clearance_warning(job_with(5.5));
    ASSERT_TRUE(warning);
    EXPECT_THAT(*warning,
                AllOf(HasSubstr("the clearance of 5.5 mm exceeds most triangles of post.stl"),
                      HasSubstr("(median edge 5 mm)")));
}

TEST(ClearanceWarning, IsOnlyForJobsThatListNearPairs) {
    PreparedJob job = job_with(50);
    job.query.level = Level::Contacts;
    EXPECT_TRUE(clearance_warning(job));
    job.query.level = Level::Count;
    EXPECT_FALSE(clearance_warning(job));
    job.query.level = Level::Pairs;
    job.query.clearance.reset();
    EXPECT_FALSE(clearance_warning(job));
}

} // namespace
} // namespace cd::tests
