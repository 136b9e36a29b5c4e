// The credential of a user: obtained with a token, kept in a file, and renewed.
#pragma once

#include "client/cli/cli.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace cd {

/// Returns the path of the credential for this master: as `options` say, or in the user's state
/// folder. The path is empty if the options say "none".
[[nodiscard]] std::filesystem::path client_credential_path(const MasterOptions& options,
                                                           const Endpoint& master);

/// Returns the TLS settings of a connection: null, for plain text, if the options say "none", or if
/// they name no credential and the user has none. Renews a credential past half of its lifetime;
/// prints a warning if that fails. `stop` aborts the renewal. Errors: as `read_credential`.
[[nodiscard]] Result<std::shared_ptr<const Tls>>
client_tls(const MasterOptions& options, const Endpoint& master, const std::stop_token& stop = {});

/// Returns the holder and validity in the user's credential for this master; nothing if the options
/// say "none", or if they name no credential and the user has none. Errors: as `read_credential`.
[[nodiscard]] Result<std::optional<Identity>> own_identity(const MasterOptions& options,
                                                           const Endpoint& master);

/// Returns when the credential for this master is due for renewal; nothing without a credential.
[[nodiscard]] std::optional<std::chrono::system_clock::time_point>
renewal_time(const MasterOptions& options, const Endpoint& master);

/// Joins the cluster with a token, and writes the new credential to the file `path`. Returns the
/// identity in its certificate. Errors: as `join_cluster` and `write_credential`.
[[nodiscard]] Result<Identity> join_as_client(const Endpoint& master,
                                              const JoinToken& token,
                                              const std::string& name,
                                              const std::filesystem::path& path);

} // namespace cd
