// The configuration file of a user of cdctl, and the values that commands take instead.
#pragma once

#include "client/cli/cli.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace cd {

/// A value of the configuration file.
struct FileSetting {
    std::string value; ///< Formats are joined by commas; paths are absolute.
    std::uint32_t line = 0;
};

/// What the configuration file says.
struct Settings {
    std::filesystem::path file; ///< Empty: no file is read.
    bool file_exists = false;
    std::map<std::string, FileSetting, std::less<>> values; ///< By key.

    /// Null if the file does not have the key.
    [[nodiscard]] const FileSetting* find(std::string_view key) const;
};

/// Returns the path of the configuration file: CDCTL_CONFIG, or else cdcluster/cdctl.toml in
/// XDG_CONFIG_HOME or ~/.config. Empty if CDCTL_CONFIG is "none", or if there is no home.
[[nodiscard]] std::filesystem::path settings_path();

/// Parses the text of a configuration file; `file` is used in messages and for relative paths.
/// Errors: BadInput naming the file, the line and the key.
[[nodiscard]] Result<Settings> parse_settings(std::string_view text,
                                              const std::filesystem::path& file);

/// Reads the file `settings_path`. A missing file has no values. Errors: as `parse_settings`; Io,
/// also for a missing file that CDCTL_CONFIG names.
[[nodiscard]] Result<Settings> read_settings();

/// Makes the file's master, credential and tree cache the defaults of the verbs' options. The
/// environment and options override them. `run` takes a master from the environment only if the
/// file has one, too; else it runs on this machine.
void set_defaults(CLI::App& app, const Settings& settings);

/// Gives the file's level and formats to a command. They hold where neither an option nor a job
/// file says otherwise.
void give_usual_values(const Settings& settings, Command& command);

/// Returns each setting with its value and origin; `given` are the values of options. A default of
/// "credential" is empty, because it depends on the master.
[[nodiscard]] std::vector<ChosenSetting> chosen_settings(const Settings& settings,
                                                         const ConfigCommand& given);

} // namespace cd
