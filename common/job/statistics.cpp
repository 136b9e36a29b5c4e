#include "common/job/statistics.hpp"

namespace cd {

InsideStatistics& InsideStatistics::operator+=(const InsideStatistics& other) {
    scenarios += other.scenarios;
    seconds += other.seconds;
    work += other.work;
    return *this;
}

JobStatistics& JobStatistics::operator+=(const JobStatistics& other) {
    search += other.search;
    inside += other.inside;
    return *this;
}

} // namespace cd
