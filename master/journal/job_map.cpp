#include "master/journal/job_map.hpp"

#include "common/job/result/packed_map.hpp"

#include <utility>

namespace cd {

void JobMap::finish() {
    const ContactMapTotal total = std::exchange(total_, {});
    if (withdrawn_.empty()) {
        packed_ = pack_map(total.map());
    }
}

} // namespace cd
