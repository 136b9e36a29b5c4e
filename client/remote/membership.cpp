#include "client/remote/membership.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/state_folder.hpp"
#include "proto/access/credential_file.hpp"
#include "proto/access/join.hpp"

#include <cstdio>
#include <utility>

namespace cd {

namespace {

constexpr std::string_view no_credential = "none";

asio::awaitable<void> keep(asio::awaitable<Result<Credential>> coroutine,
                           std::optional<Result<Credential>>& result) {
    result = co_await std::move(coroutine);
}

/// Runs a conversation with a master on this thread until it ends or is stopped. Each wait in it
/// has a deadline. Errors: the conversation's; Interrupted.
Result<Credential> run(asio::awaitable<Result<Credential>> conversation,
                       const std::stop_token& stop = {}) {
    asio::io_context context(1);
    const std::stop_callback end(stop, [&context] { context.stop(); });
    std::optional<Result<Credential>> result;
    asio::co_spawn(
        context, keep(std::move(conversation), result), [](const std::exception_ptr& thrown) {
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        });
    context.run();
    return result ? std::move(*result) : Error{ErrorCode::Interrupted, "interrupted"};
}

Result<Credential> renewed(const Endpoint& master,
                           std::shared_ptr<const Tls> tls,
                           const std::filesystem::path& path,
                           const std::stop_token& stop) {
    Credential credential = CD_TRY(run(renew_credential(master, std::move(tls)), stop));
    CD_TRY(write_credential(path, credential));
    return credential;
}

} // namespace

std::filesystem::path client_credential_path(const MasterOptions& options, const Endpoint& master) {
    if (options.credential == no_credential) {
        return {};
    }
    return options.credential.empty() ? credential_path(state_folder() / "client", master)
                                      : std::filesystem::path(options.credential);
}

Result<std::shared_ptr<const Tls>>
client_tls(const MasterOptions& options, const Endpoint& master, const std::stop_token& stop) {
    const std::filesystem::path path = client_credential_path(options, master);
    if (path.empty()) {
        return std::shared_ptr<const Tls>();
    }
    const Result<Credential> credential = read_credential(path);
    if (!credential) {
        const bool is_optional = options.credential.empty();
        return is_optional && credential.error().code == ErrorCode::NotFound
                   ? Result<std::shared_ptr<const Tls>>(nullptr)
                   : Result<std::shared_ptr<const Tls>>(credential.error());
    }
    auto tls = Tls::make(credential.value());
    if (!tls || std::chrono::system_clock::now() < renew_at(*tls.value()->identity())) {
        return tls;
    }
    const Result<Credential> next = renewed(master, tls.value(), path, stop);
    if (!next && next.error().code == ErrorCode::Interrupted) {
        return tls;
    }
    if (!next) {
        // Keeps the old credential, which may still be valid; if not, the master refuses it.
        std::fprintf(stderr,
                     "cdctl: warning: the credential %s was not renewed: %s\n",
                     path.c_str(),
                     next.error().detail.c_str());
        return tls;
    }
    return Tls::make(next.value());
}

Result<std::optional<Identity>> own_identity(const MasterOptions& options, const Endpoint& master) {
    const std::filesystem::path path = client_credential_path(options, master);
    if (path.empty()) {
        return std::optional<Identity>();
    }
    const Result<Credential> credential = read_credential(path);
    if (!credential) {
        const bool is_optional = options.credential.empty();
        return is_optional && credential.error().code == ErrorCode::NotFound
                   ? Result<std::optional<Identity>>(std::optional<Identity>())
                   : Result<std::optional<Identity>>(credential.error());
    }
    auto identity = CD_TRY(read_identity(credential.value().certificate));
    return std::optional<Identity>(std::move(identity));
}

std::optional<std::chrono::system_clock::time_point> renewal_time(const MasterOptions& options,
                                                                  const Endpoint& master) {
    const auto identity = own_identity(options, master);
    return identity && identity.value() ? std::optional(renew_at(*identity.value())) : std::nullopt;
}

Result<Identity> join_as_client(const Endpoint& master,
                                const JoinToken& token,
                                const std::string& name,
                                const std::filesystem::path& path) {
    // Checks first that the credential can be written, since a join consumes a use of the token.
    CD_TRY(check_can_write(path));
    const Credential credential = CD_TRY(run(join_cluster(master, token, name)));
    CD_TRY(write_credential(path, credential));
    return read_identity(credential.certificate);
}

} // namespace cd
