// The verbs that obtain credentials: `join` and `token create`.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/remote/membership.hpp"
#include "common/core/duration.hpp"
#include "common/core/limits/wire.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace cd {

namespace {

/// The default name of a client: USER@HOST.
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
        return Error{ErrorCode::BadInput, "cannot read a token from '" + command.token_file + "'"};
    }
    return parse_join_token(line);
}

} // namespace

int execute(const JoinCommand& command) {
    const Result<JoinToken> token = token_of(command);
    if (!token) {
        return fail(token.error());
    }
    const Result<Endpoint> master = parse_endpoint(command.master.address);
    if (!master) {
        return fail(master.error());
    }
    const auto path = client_credential_path(command.master, master.value());
    if (path.empty()) {
        return fail({ErrorCode::BadInput, "--credential none leaves no place for a credential"});
    }
    const auto identity = join_as_client(
        master.value(), token.value(), command.name.empty() ? default_name() : command.name, path);
    if (!identity) {
        return fail(identity.error());
    }
    std::printf("joined %s as %s (%s); credential %s\n",
                command.master.address.c_str(),
                std::string(to_text(identity.value().role)).c_str(),
                identity.value().name.c_str(),
                path.c_str());
    return exit_done;
}

int execute(const TokenCommand& command) {
    const InterruptGuard interrupts;
    const Result<std::chrono::seconds> life = parse_duration(command.ttl);
    if (!life) {
        return fail(life.error());
    }
    auto connection = open_master(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    TokenCreate create;
    create.role = certified_role_from_text(command.role).value();
    create.seconds = static_cast<std::uint64_t>(life.value().count());
    create.uses = command.uses;
    const Result<TokenCreated> created = connection.value()->create_token(create);
    if (!created) {
        return fail(created.error());
    }
    const Result<JoinToken> token = parse_join_token(created.value().token);
    if (!token) {
        return fail({ErrorCode::BadFrame, "the master answers something else than a token"});
    }
    std::printf("%s\n", created.value().token.c_str());
    std::fprintf(stderr,
                 "for %u %s, within %s; authority %s\n",
                 command.uses,
                 (command.role + (command.uses == 1 ? "" : "s")).c_str(),
                 command.ttl.c_str(),
                 to_hex(token.value().authority).c_str());
    return exit_done;
}

} // namespace cd
