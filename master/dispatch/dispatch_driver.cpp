#include "master/dispatch/dispatch_driver.hpp"

#include <algorithm>
#include <iterator>

namespace cd {

void DispatchDriver::act(Actions actions) {
    std::move(actions.begin(), actions.end(), std::back_inserter(actions_));
    if (is_acting_) {
        return; // The outer call of `act` performs the new actions.
    }
    is_acting_ = true;
    while (!actions_.empty()) {
        const Action action = std::move(actions_.front());
        actions_.pop_front();
        perform_(action);
    }
    is_acting_ = false;
}

} // namespace cd
