#include "common/core/host/man_page.hpp"

#include "common/core/version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <vector>

namespace cd {

namespace {

/// Escapes what man(7) would take as a request or an escape.
std::string man_text(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool begins_line = at == 0 || text[at - 1] == '\n';
        if (begins_line && (text[at] == '.' || text[at] == '\'')) {
            out += "\\&";
        }
        switch (text[at]) {
        case '\\':
            out += "\\e";
            break;
        case '-':
            out += "\\-";
            break;
        case '~':
            out += "\\(ti";
            break;
        case '^':
            out += "\\(ha";
            break;
        case '`':
            out += "\\(ga";
            break;
        case '\'':
            out += "\\(aq";
            break;
        default:
            out += text[at];
        }
    }
    return out;
}

/// Returns lines that keep their breaks and columns, without empty ones at either end.
std::string literal_text(const std::string& text) {
    const std::size_t begin = text.find_first_not_of('\n');
    const std::size_t end = text.find_last_not_of('\n');
    return begin == std::string::npos
               ? ""
               : ".nf\n" + man_text(text.substr(begin, end - begin + 1)) + "\n.fi\n";
}

std::string today() {
    const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now =
        epoch != nullptr ? static_cast<std::time_t>(std::atoll(epoch)) : std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

std::vector<const CLI::App*> visible_subcommands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* below) { return !below->get_group().empty(); });
}

/// Adds an option: its names and type, what it does, its default, and its environment variable.
void add_option(std::string& page, const CLI::Option& option) {
    const std::string names = option.get_positional() ? "" : option.get_name(false, true);
    std::string type = option.get_items_expected_max() > 0 ? option.get_type_name() : "";
    std::replace(type.begin(), type.end(), '\n', ' ');
    page += ".TP\n";
    page += names.empty() ? "" : "\\fB" + man_text(names) + "\\fR";
    page += names.empty() || type.empty() ? "" : " ";
    page += type.empty() ? "" : "\\fI" + man_text(type) + "\\fR";
    std::istringstream lines(option.get_description());
    std::string separator = "\n";
    for (std::string line; std::getline(lines, line); separator = "\n.br\n") {
        page +=
            separator + man_text(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    }
    if (!option.get_default_str().empty()) {
        page += "\n.br\nDefault: " + man_text(option.get_default_str());
    }
    if (!option.get_envname().empty()) {
        page += "\n.br\nEnvironment: " + man_text(option.get_envname());
    }
    page += "\n";
}

void add_options(std::string& page, const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_group().empty()) {
            add_option(page, *option);
        }
    }
}

void add_subcommands(std::string& page, const CLI::App& app, const std::string& command) {
    for (const CLI::App* below : visible_subcommands(app)) {
        const std::string name = command + " " + below->get_name();
        const std::string text = below->get_description();
        const std::size_t first = std::min(text.find('\n'), text.size());
        page += ".SS " + man_text(name) + "\n" + man_text(text.substr(0, first)) + "\n";
        if (const std::string rest = literal_text(text.substr(first)); !rest.empty()) {
            page += ".PP\n" + rest;
        }
        add_options(page, *below);
        add_subcommands(page, *below, name);
    }
}

} // namespace

std::string man_page(const CLI::App& app, int section, std::string_view summary) {
    const std::string name = app.get_name();
    std::string title = name;
    std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) {
        return static_cast<char>(std::toupper(c));
    });
    const bool has_verbs = !visible_subcommands(app).empty();
    std::string page = ".TH " + title + " " + std::to_string(section) + " " + today() +
                       " \"cdcluster " + std::string(version) + "\" \"cdcluster\"\n";
    page += ".SH NAME\n" + name + " \\- " + man_text(summary) + "\n";
    page += ".SH SYNOPSIS\n\\fB" + name + "\\fR " + (has_verbs ? "[\\fISUBCOMMAND\\fR] " : "") +
            "[\\fIOPTION\\fR...]\n";
    page += ".SH DESCRIPTION\n" + literal_text(app.get_description());
    page += ".SH OPTIONS\n";
    add_options(page, app);
    if (has_verbs) {
        page += ".SH SUBCOMMANDS\n";
        add_subcommands(page, app, name);
    }
    return page;
}

} // namespace cd
