// Credentials on disk.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/channel.hpp"
#include "proto/identity/certificate.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace cd {

/// Where a program keeps what it shows to this master.
[[nodiscard]] std::filesystem::path credential_path(const std::filesystem::path& folder,
                                                    const Endpoint& master);

/// One PEM file: key, certificate, authority. For its owner alone (0600), and replaced whole. Makes
/// its folder. Errors: Io; BadInput for what is no name of a file.
[[nodiscard]] Status write_credential(const std::filesystem::path& path,
                                      const Credential& credential);

/// Errors: NotFound; Io; BadInput for what is no such file; Refused for one that others may read.
[[nodiscard]] Result<Credential> read_credential(const std::filesystem::path& path);

/// Whether a file of that name can be written: what cannot be done again is done after this. Makes
/// its folder. Errors: BadInput for what is no name of a file; Io.
[[nodiscard]] Status check_can_write(const std::filesystem::path& path);
/// A small file for its owner alone, replaced whole. Makes its folder. Errors: as above.
[[nodiscard]] Status write_private(const std::filesystem::path& path, std::string_view text);
/// Errors: NotFound; Io; TooLarge; Refused for one that others may read, or that belongs to
/// another.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& path);

/// From then on it is time for a new one.
[[nodiscard]] WallTime renew_at(const Identity& identity);

} // namespace cd
