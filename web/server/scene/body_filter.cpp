#include "web/server/scene/body_filter.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>

namespace cd {

Result<BodyFilter> BodyFilter::make(std::span<const std::string> names, const std::string& wanted) {
    BodyFilter filter;
    if (wanted.empty()) {
        return filter;
    }
    const auto named = std::ranges::find(names, wanted);
    const auto number = named == names.end()
                            ? number_in<std::uint32_t>(wanted)
                            : std::optional(static_cast<std::uint32_t>(named - names.begin()));
    if (!number || *number >= names.size()) {
        return bad_input("the job has no body '" + wanted + "'");
    }
    filter.body_ = *number;
    return filter;
}

} // namespace cd
