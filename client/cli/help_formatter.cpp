#include "client/cli/help_formatter.hpp"

#include <CLI/CLI.hpp>

#include <sstream>
#include <string>

namespace cd {

namespace {

class VerbHelp final : public CLI::Formatter {
  public:
    std::string make_description(const CLI::App* app) const override {
        const std::string text = app->get_description();
        const auto end = text.find('\n');
        if (end == std::string::npos) {
            return text + "\n\n";
        }
        return text.substr(end + 1) + "\n\n" + text.substr(0, end) + "\n\n";
    }

    std::string make_subcommand(const CLI::App* verb) const override {
        const std::string text = verb->get_description();
        std::ostringstream out;
        CLI::detail::format_help(
            out, verb->get_name(), text.substr(0, text.find('\n')), get_column_width());
        return out.str();
    }
};

} // namespace

std::shared_ptr<CLI::FormatterBase> make_help_formatter() {
    return std::make_shared<VerbHelp>();
}

} // namespace cd
