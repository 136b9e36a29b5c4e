#include "client/cli/completion.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// The completion asks cdctl for each word, so that it knows this version's verbs and options.
constexpr std::string_view bash_script =
    R"bash(# Completion of cdctl in bash: source <(cdctl completion bash)
_cdctl() {
    local line files='' current=${COMP_WORDS[COMP_CWORD]}
    COMPREPLY=()
    [[ $current == = ]] && current=''
    while IFS= read -r line; do
        if [[ $line == :files ]]; then
            files=yes
        else
            COMPREPLY+=("$line")
        fi
    done < <("${COMP_WORDS[0]}" complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    if [[ $files ]]; then
        compopt -o filenames 2>/dev/null
        while IFS= read -r line; do
            COMPREPLY+=("$line")
        done < <(compgen -f -- "$current")
    fi
}
complete -F _cdctl cdctl
)bash";

constexpr std::string_view zsh_script = R"zsh(#compdef cdctl
# Completion of cdctl in zsh: source <(cdctl completion zsh)
_cdctl() {
    local line files=''
    local -a found
    for line in ${(f)"$($words[1] complete "${(@)words[2,CURRENT]}" 2>/dev/null)"}; do
        if [[ $line == :files ]]; then
            files=yes
        else
            found+=("$line")
        fi
    done
    (( $#found )) && compadd -- "${found[@]}"
    [[ -n $files ]] && _files
    return 0
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    _cdctl "$@"
else
    compdef _cdctl cdctl
fi
)zsh";

constexpr std::string_view fish_script =
    R"fish(# Completion of cdctl in fish: cdctl completion fish | source
function __cdctl_complete
    set -l words (commandline -opc)
    set -l current (commandline -ct)
    for line in (command $words[1] complete $words[2..] "$current" 2>/dev/null)
        if test "$line" = :files
            __fish_complete_path "$current"
        else
            echo $line
        end
    end
end
complete -c cdctl -f -a '(__cdctl_complete)'
)fish";

bool is_hidden(const CLI::Option& option) {
    return option.get_group().empty();
}

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

/// Returns the words of a list such as {text,json} in the type that the help shows.
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t open = type.find('{');
    const std::size_t close = type.find('}', open);
    if (open == std::string::npos || close == std::string::npos) {
        return {};
    }
    return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

/// Whether a value of this option may be of a kind, such as FILE in FILE|none or MESH.
bool has_kind(const CLI::Option& option, std::span<const std::string_view> kinds) {
    std::string type = option.get_type_name();
    type = type.substr(0, type.find_first_of(":. "));
    return std::ranges::any_of(CLI::detail::split(type, '|'), [&](const std::string& word) {
        return std::ranges::find(kinds, word) != kinds.end();
    });
}

std::vector<const CLI::App*> verbs_below(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

/// Reads a command line word by word, and completes its last one.
class WordReader {
  public:
    explicit WordReader(const CLI::App& app) : verb_(&app) {}

    void read(const std::string& word) {
        if (waiting_ != nullptr) {
            if (word != "=") { // Bash makes a word of the sign in --option=value.
                take_value(*std::exchange(waiting_, nullptr), word);
            }
        } else if (word == "--") {
            only_arguments_ = true;
        } else if (is_option(word)) {
            read_option(word);
        } else if (const CLI::App* below = verb_named(word)) {
            verb_ = below;
            arguments_ = 0;
        } else {
            ++arguments_;
        }
    }

    CompleteCommand complete(const std::string& last) {
        if (waiting_ != nullptr) {
            offer_values(*waiting_, last == "=" ? "" : last, "");
        } else if (is_option(last) || (last == "-" && !only_arguments_)) {
            const std::size_t equals = last.find('=');
            const CLI::Option* option = verb_->get_option_no_throw(last.substr(0, equals));
            if (equals == std::string::npos) {
                offer_options(last);
            } else if (option != nullptr) {
                offer_values(*option, last.substr(equals + 1), last.substr(0, equals + 1));
            }
        } else {
            for (const CLI::App* below : verbs_below(*verb_)) {
                offer(below->get_name(), last, "");
            }
            if (const CLI::Option* argument = current_argument()) {
                offer_values(*argument, last, "");
            }
        }
        return std::move(found_);
    }

  private:
    [[nodiscard]] bool is_option(const std::string& word) const {
        return !only_arguments_ && word.size() > 1 && word[0] == '-';
    }

    [[nodiscard]] const CLI::App* verb_named(const std::string& word) const {
        for (const CLI::App* below : verbs_below(*verb_)) {
            if (below->get_name() == word) {
                return below;
            }
        }
        return nullptr;
    }

    void read_option(const std::string& word) {
        const std::size_t equals = word.find('=');
        const CLI::Option* option = verb_->get_option_no_throw(word.substr(0, equals));
        if (option == nullptr) {
            return;
        }
        if (!takes_value(*option)) {
            take_value(*option, "");
        } else if (equals == std::string::npos) {
            waiting_ = option;
        } else {
            take_value(*option, word.substr(equals + 1));
        }
    }

    /// Keeps the options that say how to reach the master.
    void take_value(const CLI::Option& option, const std::string& value) {
        if (option.check_lname("master")) {
            found_.master.address = value;
        } else if (option.check_lname("credential")) {
            found_.master.credential = value;
        } else if (option.check_lname("insecure")) {
            found_.master.insecure = true;
        }
    }

    /// Returns the argument without a name at which the line is. The last may take several words.
    [[nodiscard]] const CLI::Option* current_argument() const {
        std::size_t before = 0;
        for (const CLI::Option* option : verb_->get_options()) {
            if (option->get_positional()) {
                before += static_cast<std::size_t>(option->get_items_expected_max());
                if (arguments_ < before) {
                    return option;
                }
            }
        }
        return nullptr;
    }

    void offer(const std::string& word, const std::string& begin, const std::string& before) {
        if (word.starts_with(begin)) {
            found_.words.push_back(before + word);
        }
    }

    void offer_options(const std::string& begin) {
        for (const CLI::Option* option : verb_->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                if (!is_hidden(*option)) {
                    offer("--" + name, begin, "");
                }
            }
        }
    }

    void offer_values(const CLI::Option& option, std::string begin, std::string before) {
        if (option.get_delimiter() != '\0') { // Of a list, the last value is completed.
            const std::size_t start = begin.rfind(option.get_delimiter()) + 1;
            before += begin.substr(0, start);
            begin.erase(0, start);
        }
        for (const std::string& choice : choices_of(option)) {
            offer(choice, begin, before);
        }
        constexpr std::array<std::string_view, 6> files{
            "FILE", "DIR", "MESH", "FOLDER", "OLD", "NEW"};
        constexpr std::array<std::string_view, 3> jobs{"JOB", "OLD", "NEW"};
        found_.has_files |= has_kind(option, files);
        if (has_kind(option, jobs)) {
            found_.job_begin = begin;
        }
    }

    const CLI::App* verb_;
    const CLI::Option* waiting_ = nullptr; ///< Its value is the next word.
    std::size_t arguments_ = 0;            ///< Words so far that are no options or values.
    bool only_arguments_ = false;          ///< After --.
    CompleteCommand found_;
};

} // namespace

CompleteCommand complete_words(const CLI::App& app, std::span<const std::string> words) {
    WordReader reader(app);
    if (words.empty()) {
        return reader.complete("");
    }
    for (const std::string& word : words.first(words.size() - 1)) {
        reader.read(word);
    }
    return reader.complete(words.back());
}

std::string_view completion_script(std::string_view shell) {
    return shell == "bash" ? bash_script : shell == "zsh" ? zsh_script : fish_script;
}

} // namespace cd
