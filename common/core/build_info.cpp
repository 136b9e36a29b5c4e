#include "common/core/build_info.hpp"

#include "common/core/version.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cd {

namespace {

#if defined(__clang__)
constexpr std::string_view compiler = "Clang " __clang_version__;
#else
constexpr std::string_view compiler = "GCC " __VERSION__;
#endif

struct Library {
    std::string_view name;
    std::string_view version;
};

/// Lists the linked libraries. CMake defines the text as "name version|name version".
constexpr std::string_view library_list = CD_LIBRARIES;

std::vector<Library> libraries() {
    std::vector<Library> found;
    std::string_view rest = library_list;
    while (!rest.empty()) {
        const std::string_view entry = rest.substr(0, rest.find('|'));
        rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
        const std::size_t space = entry.find(' ');
        found.push_back({entry.substr(0, space), entry.substr(space + 1)});
    }
    return found;
}

/// Returns a member of a JSON object. `key` and `value` must not need escapes.
std::string member(std::string_view key, std::string_view value) {
    return "\"" + std::string(key) + "\": \"" + std::string(value) + "\"";
}

std::string json_text(std::string_view program, std::string_view simd_target) {
    std::string text = "{\n  " + member("program", program) + ",\n  " + member("version", version) +
                       ",\n  " + member("commit", build_commit()) + ",\n  " +
                       member("compiler", compiler) + ",\n  " + member("simd", simd_target) +
                       ",\n  \"libraries\": {";
    const char* separator = "\n";
    for (const Library& library : libraries()) {
        text += separator + ("    " + member(library.name, library.version));
        separator = ",\n";
    }
    return text + "\n  }\n}\n";
}

std::string plain_text(std::string_view program, std::string_view simd_target) {
    std::string text = std::string(program) + " " + std::string(version) + "\n";
    const auto line = [&](std::string_view name, std::string_view value) {
        text += "  " + std::string(name) + std::string(12 - name.size(), ' ') + std::string(value) +
                "\n";
    };
    line("commit", build_commit());
    line("compiler", compiler);
    line("SIMD", simd_target);
    std::string names;
    for (const Library& library : libraries()) {
        names += (names.empty() ? "" : ", ") + std::string(library.name) + " " +
                 std::string(library.version);
    }
    line("libraries", names);
    return text;
}

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace

std::string version_text(std::string_view program, std::string_view simd_target, bool as_json) {
    return as_json ? json_text(program, simd_target) : plain_text(program, simd_target);
}

std::optional<std::string> version_answer(std::string_view program,
                                          std::string_view simd_target,
                                          std::span<const std::string> arguments) {
    constexpr std::array<std::string_view, 2> output{"-o", "--output"};
    if (arguments.empty() || arguments[0] != "--version") {
        return std::nullopt;
    }
    if (arguments.size() == 1) {
        return version_text(program, simd_target, false);
    }
    const bool asks_for_json =
        (arguments.size() == 3 && is_one_of(arguments[1], output) && arguments[2] == "json") ||
        (arguments.size() == 2 && arguments[1] == "-ojson");
    return asks_for_json ? std::optional(version_text(program, simd_target, true)) : std::nullopt;
}

} // namespace cd
