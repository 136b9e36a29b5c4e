// The verb that shows the user's settings.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "client/remote/membership.hpp"
#include "common/core/errors.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

namespace {

std::string_view to_text(SettingOrigin origin) {
    switch (origin) {
    case SettingOrigin::Default:
        return "default";
    case SettingOrigin::File:
        return "file";
    case SettingOrigin::Environment:
        return "environment";
    case SettingOrigin::Option:
        return "option";
    }
    return "";
}

Table settings_table(const std::vector<ChosenSetting>& settings) {
    TableOf<ChosenSetting> table(settings);
    table.add("setting", "SETTING", CellKind::Text, &ChosenSetting::key);
    table.add("value", "VALUE", CellKind::Text, &ChosenSetting::value);
    table.add("from", "FROM", CellKind::Text, [](const ChosenSetting& setting) {
        return std::string(to_text(setting.origin));
    });
    table.add("place", "", CellKind::Text, &ChosenSetting::place);
    return table.take();
}

/// Completes the settings by what depends on others: the credential's default on the master.
/// Errors: BadInput for a master that is no HOST:PORT, naming where it is set.
Result<std::vector<ChosenSetting>> completed(std::vector<ChosenSetting> settings) {
    Endpoint master;
    for (ChosenSetting& setting : settings) {
        if (setting.key == "master") {
            const std::string place = setting.place.empty() ? "" : setting.place + ": ";
            master = CD_TRY(within(place, parse_endpoint(setting.value)));
        } else if (setting.key == "credential" && setting.origin == SettingOrigin::Default) {
            setting.value = client_credential_path({}, master).string();
        }
    }
    return settings;
}

} // namespace

Result<int> perform(const ConfigCommand& command) {
    const auto settings = CD_TRY(completed(command.settings));
    const Table table = settings_table(settings);
    if (command.output == "json") {
        nlohmann::ordered_json json;
        json["file"] = command.file;
        json["exists"] = command.file_exists;
        json["settings"] = table_json(table);
        std::fputs(json_text(json).c_str(), stdout);
        return exit_done;
    }
    const std::string file = command.file.empty() ? "no configuration file is read"
                             : command.file_exists
                                 ? command.file
                                 : command.file + " does not exist; every key is optional";
    std::fputs((file + "\n" + table_text(table, true)).c_str(), stdout);
    return exit_done;
}

} // namespace cd
