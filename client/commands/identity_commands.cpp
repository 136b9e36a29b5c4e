// The verbs that obtain credentials: `join` and `token create`.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/remote/membership.hpp"
#include "common/core/duration.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/wire.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace cd {

namespace {

/// Returns the default name of a client: USER@HOST.
std::string default_name() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) {
        host[0] = '\0';
    }
    const char* const user = std::getenv("USER");
    const std::string name = std::string(user == nullptr ? "cdctl" : user) + "@" + host.data();
    return name.substr(0, limits::certified_name_bytes_max);
}

Result<JoinToken> token_of(const JoinCommand& command) {
    if (command.token_file.empty()) {
        return parse_join_token(command.token);
    }
    std::ifstream file(command.token_file);
    std::string line;
    if (!std::getline(file, line)) {
        return bad_input("cannot read a token from '" + command.token_file + "'");
    }
    return parse_join_token(line);
}

} // namespace

Result<int> perform(const JoinCommand& command) {
    const JoinToken token = CD_TRY(token_of(command));
    const Endpoint master = CD_TRY(parse_endpoint(command.master.address));
    const auto path = client_credential_path(command.master, master);
    if (path.empty()) {
        return bad_input("--credential none leaves no place for a credential");
    }
    const auto identity = CD_TRY(
        join_as_client(master, token, command.name.empty() ? default_name() : command.name, path));
    std::printf("joined %s as %s (%s); credential %s\n",
                command.master.address.c_str(),
                std::string(to_text(identity.role)).c_str(),
                identity.name.c_str(),
                path.c_str());
    return exit_done;
}

Result<int> perform(const TokenCommand& command) {
    const InterruptGuard interrupts;
    const std::chrono::seconds life = CD_TRY(parse_duration(command.ttl));
    auto connection = CD_TRY(open_master(command.master));
    TokenCreate create;
    create.role = certified_role_from_text(command.role).value();
    create.seconds = static_cast<std::uint64_t>(life.count());
    create.uses = command.uses;
    const TokenCreated created = CD_TRY(connection->create_token(create));
    const Result<JoinToken> token = parse_join_token(created.token);
    if (!token) {
        return Error{ErrorCode::BadFrame, "the master answers something else than a token"};
    }
    std::printf("%s\n", created.token.c_str());
    std::fprintf(stderr,
                 "for %u %s, within %s; authority %s\n",
                 command.uses,
                 (command.role + (command.uses == 1 ? "" : "s")).c_str(),
                 command.ttl.c_str(),
                 to_hex(token.value().authority).c_str());
    return exit_done;
}

} // namespace cd
