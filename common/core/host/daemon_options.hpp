// Shared option handling of both daemons: a TOML file, the environment, and help that opens with
// examples.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class Config;
class FormatterBase;
} // namespace CLI

namespace cd {

/// Names an option's environment variable: "CDWORKER_" and "connect-for" give CDWORKER_CONNECT_FOR.
[[nodiscard]] std::string environment_name(const std::string& prefix, std::string option);

/// Reads the flat TOML file of --config. Environment variables (with `prefix`) override the file.
/// Throws CLI::ConfigError naming the line.
[[nodiscard]] std::shared_ptr<CLI::Config> make_toml_config(std::string prefix);

/// Formats help so that it opens with the description, which holds the examples.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_examples_first();

} // namespace cd
