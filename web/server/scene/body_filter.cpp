#include "web/server/scene/body_filter.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>

namespace cd {

Result<std::uint32_t> body_number(std::span<const std::string> names, const std::string& wanted) {
    const auto named = std::ranges::find(names, wanted);
    const auto number = named == names.end()
                            ? number_in<std::uint32_t>(wanted)
                            : std::optional(static_cast<std::uint32_t>(named - names.begin()));
    if (!number || *number >= names.size()) {
        return bad_input("the job has no body '" + wanted + "'");
    }
    return *number;
}

Result<BodyFilter> BodyFilter::make(std::span<const std::string> names, const std::string& wanted) {
    BodyFilter filter;
    if (!wanted.empty()) {
        filter.body_ = CD_TRY(body_number(names, wanted));
    }
    return filter;
}

} // namespace cd
