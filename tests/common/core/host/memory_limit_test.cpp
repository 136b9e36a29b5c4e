// Proves that the least of all limits applies: the host's, and each enclosing control group's.
#include "common/core/host/memory_limit.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

struct MemoryLimit : testing::Test {
    MemoryLimit() { write("proc/meminfo", "MemFree: 1 kB\nMemTotal:       1000 kB\n"); }

    void write(const std::string& path, const std::string& text) {
        std::filesystem::create_directories((root / path).parent_path());
        write_text(root / path, text);
    }

    TemporaryFolder root;
};

TEST_F(MemoryLimit, IsThatOfTheHostWithoutGroups) {
    EXPECT_EQ(memory_limit(root.path()), 1'024'000u);
}

TEST_F(MemoryLimit, IsThatOfTheGroup) {
    write("proc/self/cgroup", "0::/jobs/ours\n");
    write("sys/fs/cgroup/jobs/ours/memory.max", "5000\n");
    write("sys/fs/cgroup/jobs/memory.max", "max\n");
    EXPECT_EQ(memory_limit(root.path()), 5000u);
}

TEST_F(MemoryLimit, IsThatOfAGroupAroundTheGroup) {
    write("proc/self/cgroup", "0::/jobs/ours\n");
    write("sys/fs/cgroup/jobs/ours/memory.max", "5000\n");
    write("sys/fs/cgroup/jobs/memory.max", "4000\n");
    EXPECT_EQ(memory_limit(root.path()), 4000u);
}

TEST_F(MemoryLimit, IsThatOfAContainerThatSeesItsGroupAsTheRoot) {
    write("proc/self/cgroup", "0::/\n");
    write("sys/fs/cgroup/memory.max", "6000\n");
    EXPECT_EQ(memory_limit(root.path()), 6000u);
}

TEST_F(MemoryLimit, IsThatOfAGroupOfTheFirstVersion) {
    write("proc/self/cgroup", "9:cpu,cpuacct:/x\n4:memory:/jobs\n");
    write("sys/fs/cgroup/memory/jobs/memory.limit_in_bytes", "7000\n");
    EXPECT_EQ(memory_limit(root.path()), 7000u);
}

TEST_F(MemoryLimit, TheHostsLimitBeatsALargerGroupLimit) {
    write("proc/self/cgroup", "0::/jobs\n");
    write("sys/fs/cgroup/jobs/memory.max", "9000000000\n");
    EXPECT_EQ(memory_limit(root.path()), 1'024'000u);
}

} // namespace
} // namespace cd::tests
