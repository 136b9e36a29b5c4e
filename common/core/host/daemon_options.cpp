#include "common/core/host/daemon_options.hpp"

#include <CLI/CLI.hpp>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>
#include <vector>

namespace cd {

namespace {

std::string text_of(const std::string& key, const toml::node& value) {
    if (const auto* text = value.as_string()) {
        return text->get();
    }
    if (const auto* number = value.as_integer()) {
        return std::to_string(number->get());
    }
    if (const auto* truth = value.as_boolean()) {
        return truth->get() ? "true" : "false";
    }
    throw CLI::ConfigError("line " + std::to_string(value.source().begin.line) + ": '" + key +
                           "' is neither text, a whole number, nor true or false");
}

class TomlConfig final : public CLI::Config {
  public:
    explicit TomlConfig(std::string prefix) : prefix_(std::move(prefix)) {}

    std::string to_config(const CLI::App* /*app*/,
                          bool /*defaults*/,
                          bool /*description*/,
                          std::string /*prefix*/) const override {
        return {};
    }

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override {
        toml::table table;
        try {
            table = toml::parse(input);
        } catch (const toml::parse_error& error) {
            throw CLI::ConfigError("line " + std::to_string(error.source().begin.line) + ": " +
                                   std::string(error.description()));
        }
        std::vector<CLI::ConfigItem> found;
        for (const auto& [key, value] : table) {
            CLI::ConfigItem item;
            item.name = std::string(key.str());
            item.inputs = {text_of(item.name, value)};
            // Skips an option that the environment sets, because CLI11 would prefer the file.
            if (std::getenv(environment_name(prefix_, item.name).c_str()) == nullptr) {
                found.push_back(std::move(item));
            }
        }
        return found;
    }

  private:
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

std::shared_ptr<CLI::Config> make_toml_config(std::string prefix) {
    return std::make_shared<TomlConfig>(std::move(prefix));
}

std::shared_ptr<CLI::FormatterBase> make_examples_first() {
    return std::make_shared<ExamplesFirst>();
}

} // namespace cd
