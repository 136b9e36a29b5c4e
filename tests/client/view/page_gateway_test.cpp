// Proves that a gateway ends when it has to, and only then.
#include "client/view/page_gateway.hpp"

#include "client/view/folder_source.hpp"
#include "tests/client/view/viewed_scene.hpp"

#include <chrono>
#include <optional>

namespace cd::tests {

using namespace std::chrono_literals;

TEST_F(Viewed, AGatewayEndsAfterTheLastRequest) {
    auto gateway = PageGateway::listen(0);
    ASSERT_TRUE(gateway);
    FolderSource source(gateway.value()->executor(), view("level = \"any\""), never());
    gateway.value()->serve(source, never(), 1ms); // Returns, although `stop` never says so.
}

TEST_F(Viewed, AGatewayWithoutALimitEndsOnlyWhenStopped) {
    auto gateway = PageGateway::listen(0);
    ASSERT_TRUE(gateway);
    FolderSource source(gateway.value()->executor(), view("level = \"any\""), never());
    int asked = 0;
    gateway.value()->serve(
        source, [&asked] { return ++asked == 4; }, std::nullopt);
    EXPECT_EQ(asked, 4);
}

} // namespace cd::tests
