// Option handling that both daemons share: a TOML file, environment variables, and help that opens
// with examples.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
class Config;
class FormatterBase;
} // namespace CLI

namespace cd {

/// Returns an option's environment variable: CDWORKER_CONNECT_FOR for "CDWORKER_", "connect-for".
[[nodiscard]] std::string environment_name(const std::string& prefix, std::string option);

/// Makes a reader of the flat TOML file given with --config, whose keys are options of `app`, which
/// must outlive it. Environment variables whose names begin with `prefix` override the file. The
/// reader throws CLI::ConfigError naming the line.
[[nodiscard]] std::shared_ptr<CLI::Config> make_toml_config(const CLI::App& app,
                                                            std::string prefix);

/// Makes a formatter of help that opens with the description, which holds the examples.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_examples_first();

} // namespace cd
