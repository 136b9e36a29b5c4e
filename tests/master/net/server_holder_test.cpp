// Proves that equal process numbers of two certificate holders are two processes.
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

namespace cd::tests {
namespace {

constexpr Stage secured{.is_secured = true};

std::optional<WorkerStatus> alive_at(Master& master) {
    const auto workers = master.cluster().workers;
    const auto here = std::ranges::find(workers, WorkerState::Alive, &WorkerStatus::state);
    return here == workers.end() ? std::nullopt : std::optional(*here);
}

TEST(ServerHolder, AProcessNumberOfAnotherHolderEndsNoSession) {
    Master master(no_return, {}, secured);
    const FakeWorker first(master, {.instance = 7, .holder = "first"});
    master.run_until([&] { return alive_at(master).has_value(); });
    const FakeWorker second(master, {.instance = 7, .holder = "second"});
    const auto here = [&] {
        const auto workers = master.cluster().workers;
        return std::ranges::count(workers, WorkerState::Alive, &WorkerStatus::state);
    };
    master.run_until([&] { return first.ended || here() == 2; });
    EXPECT_FALSE(first.ended);
    EXPECT_EQ(here(), 2);
    const FakeWorker again(master, {.instance = 7, .holder = "first"});
    master.run_until([&] { return first.ended; });
    EXPECT_FALSE(second.ended);
}

} // namespace
} // namespace cd::tests
