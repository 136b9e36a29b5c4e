// Proves that lines are read from files as they are written there, and that files without lines are
// refused with the row's number.
#include "client/bundle/line_file.hpp"

#include "common/core/files/npy_header.hpp"
#include "tests/support/process.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

Aabb unit_box() {
    Aabb box;
    box.add(Vec3(0, 0, 0));
    box.add(Vec3(1, 1, 1));
    return box;
}

/// Reads `numbers` back from an NPY file of `columns` numbers a row.
Result<std::vector<LineEnds>>
read_rows(const std::vector<double>& numbers, std::uint64_t columns, LineForm form) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "rays.npy";
    std::ofstream out(path, std::ios::binary);
    const Bytes header =
        make_npy_header(NpyType::F8, std::array{numbers.size() / columns, columns});
    out.write(reinterpret_cast<const char*>(header.data()),
              static_cast<std::streamsize>(header.size()));
    out.write(reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    out.close();
    return read_lines(path, form, unit_box());
}

std::string refusal_of_rows(const std::vector<double>& numbers, LineForm form) {
    const auto lines = read_rows(numbers, 6, form);
    return lines ? "taken" : lines.error().detail;
}

} // namespace

TEST(LineFile, EndsAreTakenLiterally) {
    const auto lines =
        read_rows({0.1, 0.2, 0.3, 1, 2, 3, 7, 8, 9, 7, 8, 10}, 6, LineForm::Ends).value();
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].p, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(lines[0].q, Vec3(1, 2, 3));
    EXPECT_EQ(lines[1].q, Vec3(7, 8, 10));
}

TEST(LineFile, RaysEndBehindTheBox) {
    for (SeededRandom random : seeds(100)) {
        const Vec3 start = random_point(random, 10);
        Vec3 direction = random_point(random, 1);
        direction *= std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const LineEnds line =
            read_rows(
                {start.x(), start.y(), start.z(), direction.x(), direction.y(), direction.z()},
                6,
                LineForm::Rays)
                .value()
                .front();
        EXPECT_EQ(line.p, start);
        const Vec3 along = line.q - line.p;
        const double length = along.norm();
        EXPECT_LT((along / length - direction.normalized()).norm(), 1e-14);
        for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 1, 1)}) {
            EXPECT_GT(length, (corner - start).norm());
        }
    }
}

TEST(LineFile, ManyRowsAreAllRead) {
    std::vector<double> numbers;
    for (int i = 0; i < 10'000; ++i) {
        numbers.insert(numbers.end(), {1.0 * i, 0, 0, 0, 1.0 * i, 1});
    }
    const auto lines = read_rows(numbers, 6, LineForm::Ends).value();
    ASSERT_EQ(lines.size(), 10'000u);
    EXPECT_EQ(lines.back().q, Vec3(0, 9999, 1));
    EXPECT_EQ(line_mesh(lines).value().triangles().size(), 10'000u);
}

TEST(LineFile, RefusesWhatIsNoLineAndNamesTheRow) {
    const double nan = std::nan("");
    EXPECT_THAT(refusal_of_rows({1, 2, 3, 4, 5, 6, 1, 2, nan, 4, 5, 6}, LineForm::Ends),
                HasSubstr("row 1: a number that is not finite"));
    EXPECT_THAT(refusal_of_rows({1, 2, 3, 0, 0, 0}, LineForm::Rays),
                HasSubstr("row 0: a direction of length 0"));
    EXPECT_THAT(refusal_of_rows({1e10, 2, 3, 5e-324, 0, 0}, LineForm::Rays),
                HasSubstr("too short"));
    EXPECT_THAT(refusal_of_rows({1.5e308, 0, 0, 1e308, 0, 0}, LineForm::Rays),
                HasSubstr("too far away"));
    EXPECT_EQ(refusal_of_rows({1, 2, 3, 0, 0, 0}, LineForm::Ends), "taken") << "an end";
    EXPECT_THAT(refusal_of_rows({0, 0, 0, 1, 0, 0, 1, 2, 3, 1, 2, 3}, LineForm::Ends),
                HasSubstr("row 1: a line without a direction"));
    EXPECT_THAT(refusal_of_rows({}, LineForm::Ends), HasSubstr("0 lines"));
    const auto odd = read_rows({1, 2, 3, 4, 5, 6, 7}, 7, LineForm::Ends);
    EXPECT_THAT(odd.error().detail, HasSubstr("(1, 7)"));
    EXPECT_EQ(read_lines("/none.npy", LineForm::Ends, unit_box()).error().code,
              ErrorCode::NotFound);
    EXPECT_EQ(read_lines("/lines.csv", LineForm::Ends, unit_box()).error().detail,
              "/lines.csv: lines come from an .npy file of shape (N, 6)");
}

} // namespace cd::tests
