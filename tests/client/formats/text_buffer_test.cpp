// Proves that pieces are appended in order, and that numbers read back unchanged.
#include "client/formats/csv_rows.hpp"
#include "common/core/words.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace cd::tests {

TEST(TextBuffer, PiecesStandOneAfterAnother) {
    TextBuffer text;
    text.add("a", 1u, ",", -2, ",", 0.5, "\n");
    text.add(std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(text.text(), "a1,-2,0.5\n18446744073709551615");
    text.clear();
    EXPECT_EQ(text.text(), "");
}

TEST(TextBuffer, DoublesAreTheShortestThatReadBackTheSame) {
    for (const double value :
         {0.1, -1.0 / 3, 1e300, 5e-324, 1e21, -0.0, std::numeric_limits<double>::infinity()}) {
        TextBuffer text;
        text.add(value);
        EXPECT_EQ(text.text(), exact_text(value));
    }
}

} // namespace cd::tests
