// Credentials on disk.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/channel.hpp"
#include "proto/identity/certificate.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cd {

/// The path in `folder` of the credential with which a program connects to this master.
[[nodiscard]] std::filesystem::path credential_path(const std::filesystem::path& folder,
                                                    const Endpoint& master);

/// Writes key, certificate and authority to one PEM file, atomically, with mode 0600. Creates the
/// file's folder. Errors: Io; BadInput if the path names no file.
[[nodiscard]] Status write_credential(const std::filesystem::path& path,
                                      const Credential& credential);

/// Reads a file that `write_credential` wrote. Errors: those of `read_private`; BadInput if the
/// file holds no credential.
[[nodiscard]] Result<Credential> read_credential(const std::filesystem::path& path);

/// Checks that the file can be written, before a step that cannot be repeated. Creates the file's
/// folder. Errors: BadInput if the path names no file; Io.
[[nodiscard]] Status check_can_write(const std::filesystem::path& path);
/// Writes a small file atomically, with mode 0600. Creates the file's folder. Errors: BadInput; Io.
[[nodiscard]] Status write_private(const std::filesystem::path& path, std::string_view text);
/// The owners from whom `read_private` takes a file: the process's user and root, or also others,
/// for a look at the state of another user.
enum class FileOwner : std::uint8_t { UserOrRoot, Anyone };
/// Reads a small file. Errors: NotFound; Io; TooLarge; Refused if other users than its owner may
/// read the file, or if `owner` excludes its owner.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& path,
                                               FileOwner owner = FileOwner::UserOrRoot);

/// Returns when to renew a certificate: after half of its validity. The validity begins
/// `timing::clock_difference_max` before the issue; that time does not count.
[[nodiscard]] WallTime renew_at(const Identity& identity);

} // namespace cd
