#include "client/groups/part_pattern.hpp"

#include <fnmatch.h>

namespace cd {

PartPattern PartPattern::from_text(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
        } else if (text[i] == '/') {
            return {std::string(text.substr(0, i)), std::string(text.substr(i + 1))};
        }
    }
    return {std::nullopt, std::string(text)};
}

bool PartPattern::is_of_body(const std::string& name) const {
    return !body || fnmatch(body->c_str(), name.c_str(), 0) == 0;
}

bool PartPattern::is_of_part(const std::string& name) const {
    return fnmatch(part.c_str(), name.c_str(), 0) == 0;
}

} // namespace cd
