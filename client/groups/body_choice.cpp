#include "client/groups/body_choice.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <string_view>

namespace cd {

Result<BodyChoice> BodyChoice::of_names(std::span<const std::string> names,
                                        std::span<const std::string> bodies) {
    BodyChoice choice;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(bodies, name);
        if (found == bodies.end()) {
            const std::vector<std::string_view> known(bodies.begin(), bodies.end());
            return bad_input("--body: the run has no body \"" + name + "\"" +
                             suggestion(name, known));
        }
        choice.is_chosen_.resize(bodies.size());
        choice.is_chosen_[static_cast<std::size_t>(found - bodies.begin())] = true;
        choice.text_ += (choice.text_.empty() ? "" : ", ") + name;
    }
    return choice;
}

} // namespace cd
