// Proves that a service manager is told what a daemon says, over both kinds of sockets.
#include "common/core/host/service_notice.hpp"

#include "tests/support/logged.hpp"
#include "tests/support/notify_socket.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace cd::tests {
namespace {

class ServiceNotice : public testing::Test {
  protected:
    static void name_socket(const std::string& name) { ::setenv("NOTIFY_SOCKET", name.c_str(), 1); }
    void TearDown() override { ::unsetenv("NOTIFY_SOCKET"); }

    TemporaryFolder folder_;
    Logged logged_{LogLevel::Info};
};

TEST_F(ServiceNotice, ReachesASocketOfTheFileSystem) {
    const std::string name = (folder_ / "notify").string();
    NotifySocket socket(name);
    name_socket(name);
    notify_service("READY=1");
    notify_service("STOPPING=1");
    EXPECT_EQ(socket.next(), "READY=1");
    EXPECT_EQ(socket.next(), "STOPPING=1");
    EXPECT_EQ(logged_.text(), "");
}

TEST_F(ServiceNotice, ReachesAnAbstractSocket) {
    const std::string name = "@cdcluster-test-" + std::to_string(::getpid());
    NotifySocket socket(name);
    name_socket(name);
    notify_service("READY=1");
    EXPECT_EQ(socket.next(), "READY=1");
    EXPECT_EQ(logged_.text(), "");
}

TEST_F(ServiceNotice, DoesNothingWithoutAServiceManager) {
    notify_service("READY=1");
    name_socket("");
    notify_service("READY=1");
    EXPECT_EQ(logged_.text(), "");
}

TEST_F(ServiceNotice, ASocketThatIsNotThereIsAWarning) {
    for (const std::string& name :
         {(folder_ / "gone").string(), std::string("relative"), "/" + std::string(200, 'x')}) {
        name_socket(name);
        notify_service("READY=1");
        EXPECT_THAT(logged_.text(), testing::HasSubstr("socket=\"" + name + "\""));
    }
}

} // namespace
} // namespace cd::tests
