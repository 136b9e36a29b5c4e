#include "common/core/host/daemon_options.hpp"

#include "common/core/host/config_file.hpp"
#include "common/core/words.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

namespace {

class TomlConfig final : public CLI::Config {
  public:
    TomlConfig(const CLI::App& app, std::string prefix) : app_(app), prefix_(std::move(prefix)) {}

    std::string to_config(const CLI::App* /*app*/,
                          bool /*defaults*/,
                          bool /*description*/,
                          std::string /*prefix*/) const override {
        return {};
    }

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override {
        const std::string text(std::istreambuf_iterator<char>(input), {});
        Result<std::vector<ConfigEntry>> entries = parse_config(text, "line ");
        if (!entries) {
            throw CLI::ConfigError(entries.error().detail);
        }
        std::vector<CLI::ConfigItem> found;
        for (ConfigEntry& entry : entries.value()) {
            check_is_option(entry);
            CLI::ConfigItem item;
            item.name = std::move(entry.key);
            item.inputs = std::move(entry.values);
            // Skips an option that the environment sets, because CLI11 would prefer the file.
            if (std::getenv(environment_name(prefix_, item.name).c_str()) == nullptr) {
                found.push_back(std::move(item));
            }
        }
        return found;
    }

  private:
    void check_is_option(const ConfigEntry& entry) const {
        if (app_.get_option_no_throw("--" + entry.key) != nullptr) {
            return;
        }
        std::vector<std::string_view> known;
        for (const CLI::Option* const option : app_.get_options()) {
            for (const std::string& name : option->get_lnames()) {
                known.emplace_back(name);
            }
        }
        const auto nearest = nearest_word(entry.key, known);
        throw CLI::ConfigError("line " + std::to_string(entry.line) + ": there is no option '" +
                               entry.key + "'" +
                               (nearest ? "; did you mean '" + std::string(*nearest) + "'?" : ""));
    }

    const CLI::App& app_;
    std::string prefix_;
};

class ExamplesFirst final : public CLI::Formatter {
  public:
    std::string make_description(const CLI::App* app) const override {
        return app->get_description() + "\n\n";
    }
};

} // namespace

std::string environment_name(const std::string& prefix, std::string option) {
    std::transform(option.begin(), option.end(), option.begin(), [](unsigned char c) {
        return c == '-' ? '_' : static_cast<char>(std::toupper(c));
    });
    return prefix + option;
}

std::shared_ptr<CLI::Config> make_toml_config(const CLI::App& app, std::string prefix) {
    return std::make_shared<TomlConfig>(app, std::move(prefix));
}

std::shared_ptr<CLI::FormatterBase> make_examples_first() {
    return std::make_shared<ExamplesFirst>();
}

} // namespace cd
