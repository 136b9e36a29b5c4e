#include "client/cli/settings.hpp"

#include "client/cli/cli_options.hpp"
#include "client/spec/job_file.hpp"
#include "client/spec/query_spec.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/config_file.hpp"
#include "common/core/host/daemon_options.hpp"
#include "common/core/words.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

namespace cd {

namespace {

constexpr std::array<std::string_view, 5> setting_keys{
    "master", "credential", "formats", "level", "tree-cache"};
/// The settings that the environment can give, as CDCTL_MASTER does.
constexpr std::array<std::string_view, 3> environment_keys{"master", "credential", "tree-cache"};
constexpr const char* no_settings_file = "none";

std::optional<std::string> variable(const std::string& name) {
    const char* const value = std::getenv(name.c_str());
    return value != nullptr && *value != '\0' ? std::optional<std::string>(value) : std::nullopt;
}

std::string variable_of(std::string_view key) {
    return environment_name("CDCTL_", std::string(key));
}

std::optional<std::string> environment_value(std::string_view key) {
    return std::ranges::find(environment_keys, key) != environment_keys.end()
               ? variable(variable_of(key))
               : std::nullopt;
}

/// Returns a path of the file as an absolute one: `~/` is the home, and other relative paths start
/// at the file's folder. Words such as "off", which are no paths, stay.
std::string
setting_path(const std::string& text, std::string_view word, const std::filesystem::path& file) {
    if (text == word) {
        return text;
    }
    const auto home = variable("HOME");
    return text.starts_with("~/") && home ? *home + text.substr(1) : beside(file, text).string();
}

Status check_level(const std::string& text) {
    return std::ranges::find(asked_levels, text) != asked_levels.end()
               ? Status(Done{})
               : bad_input("level \"" + text + "\" is not known" + suggestion(text, asked_levels));
}

/// Returns the value of an entry as an option would have it. Errors: BadInput without a place.
Result<std::string> value_of(const ConfigEntry& entry, const std::filesystem::path& file) {
    if (entry.key == "formats") {
        for (const std::string& format : entry.values) {
            CD_TRY(check_format(format));
        }
        return fmt::format("{}", fmt::join(entry.values, ","));
    }
    if (entry.values.size() != 1 || entry.values.front().empty()) {
        return bad_input(entry.key + " has to be one text in quotes");
    }
    const std::string& text = entry.values.front();
    if (entry.key == "level") {
        CD_TRY(check_level(text));
    }
    return entry.key == "credential"   ? setting_path(text, "none", file)
           : entry.key == "tree-cache" ? setting_path(text, no_tree_cache, file)
                                       : text;
}

std::string default_of(std::string_view key) {
    return key == "master"       ? loopback_master
           : key == "formats"    ? fmt::format("{}", fmt::join(OutputSpec().formats, ","))
           : key == "level"      ? std::string(asked_level(Query{}))
           : key == "tree-cache" ? default_tree_cache()
                                 : "";
}

void set_default(CLI::App& verb, std::string_view key, const std::string& value) {
    if (CLI::Option* const option = verb.get_option_no_throw("--" + std::string(key))) {
        option->default_val(value);
    }
}

std::vector<std::string> formats_in(const std::string& list) {
    return list.empty() ? std::vector<std::string>() : CLI::detail::split(list, ',');
}

} // namespace

const FileSetting* Settings::find(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
}

std::filesystem::path settings_path() {
    if (const auto file = variable("CDCTL_CONFIG")) {
        std::error_code unknown; // If the current folder is unknown, the path stays relative.
        return *file == no_settings_file ? std::filesystem::path()
                                         : std::filesystem::absolute(*file, unknown);
    }
    const std::filesystem::path below = std::filesystem::path("cdcluster") / "cdctl.toml";
    if (const auto config = variable("XDG_CONFIG_HOME"); config && config->starts_with('/')) {
        return *config / below;
    }
    const auto home = variable("HOME");
    return home && home->starts_with('/') ? *home / (".config" / below) : std::filesystem::path();
}

Result<Settings> parse_settings(std::string_view text, const std::filesystem::path& file) {
    Settings settings;
    settings.file = file;
    settings.file_exists = true;
    std::vector<ConfigEntry> entries = CD_TRY(parse_config(text, file.string() + ":"));
    std::ranges::sort(entries, {}, &ConfigEntry::line);
    for (const ConfigEntry& entry : entries) {
        const std::string place = file.string() + ":" + std::to_string(entry.line) + ": ";
        if (std::ranges::find(setting_keys, entry.key) == setting_keys.end()) {
            return bad_input(place + "cdctl has no setting \"" + entry.key + "\"" +
                             suggestion(entry.key, setting_keys));
        }
        auto value = CD_TRY(within(place, value_of(entry, file)));
        settings.values[entry.key] = {std::move(value), entry.line};
    }
    return settings;
}

Result<Settings> read_settings() {
    Settings none;
    none.file = settings_path();
    if (none.file.empty()) {
        return none;
    }
    std::error_code unknown;
    if (!std::filesystem::exists(none.file, unknown) && !variable("CDCTL_CONFIG")) {
        return none;
    }
    std::ifstream file(none.file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file || std::filesystem::is_directory(none.file, unknown)) {
        return Error{ErrorCode::Io, none.file.string() + ": cannot be read"};
    }
    return parse_settings(text, none.file);
}

void set_defaults(CLI::App& app, const Settings& settings) {
    for (CLI::App* const verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (verb->get_name() == "config") {
            continue; // It tells options from the file.
        }
        for (const std::string_view key : environment_keys) {
            const FileSetting* const setting = settings.find(key);
            if (setting == nullptr) {
                continue;
            }
            const bool heeds_no_variable = key == "master" && verb->get_name() == "run";
            const auto overriding = heeds_no_variable ? environment_value(key) : std::nullopt;
            set_default(*verb, key, overriding.value_or(setting->value));
        }
        set_defaults(*verb, settings);
    }
}

void give_usual_values(const Settings& settings, Command& command) {
    const auto value = [&](std::string_view key) {
        const FileSetting* const setting = settings.find(key);
        return setting == nullptr ? std::string() : setting->value;
    };
    const auto give = [&](JobOptions& job) {
        job.query.usual_level = value("level");
        job.output.usual_formats = formats_in(value("formats"));
    };
    if (auto* const run = std::get_if<RunCommand>(&command)) {
        give(run->job);
    } else if (auto* const submit = std::get_if<SubmitCommand>(&command)) {
        give(submit->job);
    } else if (auto* const results = std::get_if<ResultsCommand>(&command)) {
        results->usual_formats = formats_in(value("formats"));
    } else if (auto* const complete = std::get_if<CompleteCommand>(&command)) {
        // The line may name neither; then the shell asks the master that a verb would use.
        ConfigCommand given;
        given.given = {{"master", complete->master.address},
                       {"credential", complete->master.credential}};
        const std::vector<ChosenSetting> chosen = chosen_settings(settings, given);
        complete->master.address = chosen[0].value;
        complete->master.credential = chosen[1].value;
    } else if (auto* const config = std::get_if<ConfigCommand>(&command)) {
        config->settings = chosen_settings(settings, *config);
        config->file = settings.file;
        config->file_exists = settings.file_exists;
    }
}

std::vector<ChosenSetting> chosen_settings(const Settings& settings, const ConfigCommand& given) {
    std::vector<ChosenSetting> chosen;
    for (const std::string_view key : setting_keys) {
        ChosenSetting setting;
        setting.key = key;
        const auto option = given.given.find(setting.key);
        const FileSetting* const written = settings.find(key);
        if (option != given.given.end() && !option->second.empty()) {
            setting.value = option->second;
            setting.origin = SettingOrigin::Option;
            setting.place = "--" + setting.key;
        } else if (const auto variable = environment_value(key)) {
            setting.value = *variable;
            setting.origin = SettingOrigin::Environment;
            setting.place = variable_of(key);
        } else if (written != nullptr) {
            setting.value = written->value;
            setting.origin = SettingOrigin::File;
            setting.place = settings.file.string() + ":" + std::to_string(written->line);
        } else {
            setting.value = default_of(key);
        }
        chosen.push_back(std::move(setting));
    }
    return chosen;
}

} // namespace cd
