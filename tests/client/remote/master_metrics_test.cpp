// Proves that the text format of Prometheus is read, and that other texts are errors.
#include "client/remote/master_metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {
namespace {

TEST(MasterMetrics, SamplesHaveNameLabelsAndValue) {
    const auto read = parse_metrics("# HELP a_b Help.\n# TYPE a_b gauge\na_b 1.5\n\n"
                                    "c{x=\"1\",y=\"a \\\"b\\\"\\n}\"} -2e3\n"
                                    "d_bucket{le=\"+Inf\"} +Inf\ne{} NaN\nf 7 1700000000000\n");
    ASSERT_TRUE(read) << read.error().detail;
    const MasterMetrics metrics{read.value()};
    ASSERT_EQ(metrics.samples.size(), 5u);
    EXPECT_EQ(metrics.value("a_b"), 1.5);
    EXPECT_EQ(metrics.samples[1].label("x"), "1");
    EXPECT_EQ(metrics.samples[1].label("y"), "a \"b\"\n}");
    EXPECT_EQ(metrics.samples[1].label("z"), "");
    EXPECT_EQ(metrics.value("c"), -2000);
    EXPECT_TRUE(std::isinf(*metrics.value("d_bucket")));
    EXPECT_TRUE(std::isnan(*metrics.value("e")));
    EXPECT_EQ(metrics.value("f"), 7);
    EXPECT_FALSE(metrics.value("g"));
    EXPECT_EQ(metrics.all("c").size(), 1u);
}

TEST(MasterMetrics, AnotherTextIsAnError) {
    for (const char* text : {"<html>\n",
                             "a\n",
                             "a one\n",
                             "a{x=\"1\" 2\n",
                             "a{x=\"1\n",
                             "a{x=1} 2\n",
                             "a{x=\"1\"}2\n",
                             " 1\n",
                             "a{x=\"1\\"}) {
        const auto read = parse_metrics(text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, ErrorCode::BadFrame);
    }
    EXPECT_TRUE(parse_metrics("").value().empty());
}

} // namespace
} // namespace cd::tests
