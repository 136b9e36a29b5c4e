#include "client/base/standard_output.hpp"

#include "client/base/exit_code.hpp"

#include <cstdio>

namespace cd {

int finish_standard_output(int code) {
    const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (is_written || (code != exit_done && code != exit_contacts)) {
        return code;
    }
    std::fputs("cdctl: standard output: not all could be written; is its disk full, or its reader "
               "gone?\n",
               stderr);
    return exit_incomplete;
}

} // namespace cd
