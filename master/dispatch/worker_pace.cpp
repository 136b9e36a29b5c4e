#include "master/dispatch/worker_pace.hpp"

namespace cd {

void LearnedRate::add(double done, double seconds) {
    constexpr double kept = 0.9;
    if (!(done > 0) || !(seconds > 0)) {
        return;
    }
    done_ = kept * done_ + done;
    seconds_ = kept * seconds_ + seconds;
}

} // namespace cd
