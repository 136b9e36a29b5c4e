// What the options of both daemons have in common: a TOML file, the environment, and help that
// opens with examples.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class Config;
class FormatterBase;
} // namespace CLI

namespace cd {

/// The environment variable of an option: "CDWORKER_" and "connect-for" give CDWORKER_CONNECT_FOR.
[[nodiscard]] std::string environment_name(const std::string& prefix, std::string option);

/// Reads the flat TOML file of --config. What stands in the environment (under `prefix`) goes
/// before the file. Throws CLI::ConfigError naming the line.
[[nodiscard]] std::shared_ptr<CLI::Config> make_toml_config(std::string prefix);

/// Help that opens with the description, where the examples stand.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_examples_first();

} // namespace cd
