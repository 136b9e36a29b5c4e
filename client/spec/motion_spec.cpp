#include "client/spec/motion_spec.hpp"

#include <algorithm>

namespace cd {

void read_motion(const TomlFields& job, Query& query) {
    const toml::table* table = job.table("motion");
    if (table == nullptr) {
        return;
    }
    if (job.has("shots")) {
        job.refuse("motion", "lines of [shots] do not move; leave out [motion], or [shots]");
    }
    const TomlFields fields(table, job, "[motion]", {"resolution", "until"});
    MotionQuery motion;
    const auto resolution = fields.number("resolution");
    if (!resolution) {
        fields.refuse("",
                      "resolution is missing: the length, in the job's unit, below which a part of "
                      "the motion may stay open");
    }
    if (!(*resolution > 0)) {
        fields.refuse("resolution", "resolution is a length above 0, in the job's unit");
    }
    motion.resolution = *resolution;
    if (const auto word = fields.word("until", until_words)) {
        const auto place = std::ranges::find(until_words, *word) - until_words.begin();
        motion.until = static_cast<Until>(place);
    }
    query.question = Question::Motion;
    query.motion = motion;
}

} // namespace cd
