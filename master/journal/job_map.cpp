#include "master/journal/job_map.hpp"

#include "common/job/result/packed_map.hpp"

#include <utility>

namespace cd {

void JobMap::finish() {
    packed_parts_ = packed_parts();
    const ContactMapTotal total = std::exchange(total_, {});
    if (withdrawn_.empty()) {
        packed_ = pack_map(total.map());
    }
}

Bytes JobMap::packed_parts() const {
    return packed_parts_.empty() && withdrawn_.empty() ? pack_map({{}, total_.parts()})
                                                       : packed_parts_;
}

} // namespace cd
