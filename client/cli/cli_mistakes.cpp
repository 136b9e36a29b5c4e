#include "client/cli/cli_mistakes.hpp"

#include "common/core/words.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <span>
#include <string_view>

namespace cd {

namespace {

/// Returns "; did you mean 'run'?", or a hint at the command that lists the known words.
std::string
remedy(std::string_view word, const std::vector<std::string>& known, const std::string& command) {
    const std::vector<std::string_view> views(known.begin(), known.end());
    const auto nearest = nearest_word(word, views);
    return nearest ? "; did you mean '" + std::string(*nearest) + "'?"
                   : "; `" + command + " --help` lists those that exist";
}

std::vector<std::string> verbs_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(verb->get_name());
    }
    return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::optional<std::string> unknown_option(const CLI::App& app,
                                          std::span<const std::string> arguments,
                                          const std::string& command) {
    for (const std::string& argument : arguments) {
        if (argument == "--") {
            break;
        }
        const std::string name = argument.substr(0, argument.find('='));
        if (name.starts_with("--") && app.get_option_no_throw(name) == nullptr) {
            return "no option '" + name + "' of `" + command + "`" +
                   remedy(name, options_of(app), command);
        }
    }
    return std::nullopt;
}

} // namespace

std::string first_steps() {
    return "cdctl: which verb? For example\n"
           "  cdctl demo                           a local cluster and two vehicles\n"
           "  cdctl inspect car.obj                size, parts, closed or not\n"
           "  cdctl run --a car.obj --b post.stl --random 1000\n"
           "  cdctl run --a car.obj --b post.stl --poses poses.csv --out out\n"
           "  cdctl run job.toml --dry-run         checks inputs, estimates time and size\n"
           "  cdctl run job.toml --master HOST:7600\n"
           "  cdctl submit job.toml                then watch, wait, results\n"
           "  cdctl status                         the cluster and its jobs\n"
           "`cdctl --help` lists all verbs; `cdctl VERB --help` explains one.\n";
}

std::optional<std::string> unknown_word(const CLI::App& app,
                                        const std::vector<std::string>& arguments) {
    std::string command = app.get_name();
    const CLI::App* verb = &app;
    std::span<const std::string> rest = arguments;
    while (!rest.empty() && !rest.front().starts_with('-')) {
        const std::vector<std::string> known = verbs_of(*verb);
        if (known.empty()) {
            break;
        }
        if (std::ranges::find(known, rest.front()) == known.end()) {
            return (verb == &app ? "no verb '" : "no verb '" + verb->get_name() + " ") +
                   rest.front() + "'" + remedy(rest.front(), known, command);
        }
        verb = verb->get_subcommand(rest.front());
        command += " " + rest.front();
        rest = rest.subspan(1);
    }
    return unknown_option(*verb, rest, command);
}

} // namespace cd
