#include "master/net/process_figures.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace cd {

namespace {

/// Returns the fields of /proc/self/stat from the third on: the second is the program's name in
/// parentheses, which may hold blanks.
std::vector<std::string> stat_fields() {
    std::ifstream file("/proc/self/stat");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t end = text.rfind(')');
    std::istringstream rest(end == std::string::npos ? "" : text.substr(end + 1));
    return {std::istream_iterator<std::string>(rest), {}};
}

/// Returns the time at which the machine started, in seconds since 1970.
double boot_time() {
    std::ifstream file("/proc/stat");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string key;
        double seconds = 0;
        if (words >> key >> seconds && key == "btime") {
            return seconds;
        }
    }
    return 0;
}

std::uint64_t whole_number(const std::string& text) {
    std::uint64_t number = 0;
    std::istringstream(text) >> number;
    return number;
}

std::uint64_t count_open_files() {
    std::uint64_t count = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator file("/proc/self/fd", error), end;
         !error && file != end;
         file.increment(error)) {
        ++count;
    }
    return count == 0 ? 0 : count - 1; // The iterator itself has one open.
}

} // namespace

ProcessFigures process_figures() {
    // `stat_fields` begins with field 3, so that it has field n of proc(5) at index n - 3.
    constexpr std::size_t threads = 17;
    constexpr std::size_t start = 19;
    constexpr std::size_t virtual_bytes = 20;
    constexpr std::size_t resident_pages = 21;
    ProcessFigures figures;
    if (const std::vector<std::string> fields = stat_fields(); fields.size() > resident_pages) {
        figures.threads = whole_number(fields[threads]);
        figures.virtual_bytes = whole_number(fields[virtual_bytes]);
        figures.resident_bytes = whole_number(fields[resident_pages]) *
                                 static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
        figures.started = boot_time() + static_cast<double>(whole_number(fields[start])) /
                                            static_cast<double>(::sysconf(_SC_CLK_TCK));
    }
    figures.open_files = count_open_files();
    rlimit files{};
    if (::getrlimit(RLIMIT_NOFILE, &files) == 0) {
        figures.open_files_max = files.rlim_cur;
    }
    return figures;
}

} // namespace cd
