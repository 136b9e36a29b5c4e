#include "worker/fetcher.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void Fetcher::add(Token token, std::vector<SubtreeKey> roots) {
    const bool is_new = needs_.try_emplace(token, Need{std::move(roots), 0, false}).second;
    CD_CHECK(is_new);
    queue_.push_back(token);
}

void Fetcher::arrived(const SubtreeKey& key) {
    const auto request = requested_.find(key);
    if (request == requested_.end()) {
        return;
    }
    for (const Token token : request->second) {
        if (--needs_.at(token).missing == 0) {
            ready_.push_back(token);
        }
    }
    requested_.erase(request);
}

void Fetcher::finished(Token token) {
    const auto found = needs_.find(token);
    CD_CHECK(found != needs_.end());
    const Need need = std::move(found->second);
    needs_.erase(found);
    if (!need.is_admitted) {
        return;
    }
    --admitted_;
    std::erase(ready_, token);
    for (const SubtreeKey& key : need.roots) {
        if (const auto request = requested_.find(key); request != requested_.end()) {
            request->second.erase(token);
        }
        const auto use = used_.find(key);
        CD_CHECK(use != used_.end());
        if (--use->second.scenarios == 0) {
            used_bytes_ -= use->second.bytes;
            used_.erase(use);
            cache_.unpin(key);
        }
    }
}

std::vector<SubtreeKey> Fetcher::awaited() const {
    std::vector<SubtreeKey> keys;
    for (const auto& [key, tokens] : requested_) {
        keys.push_back(key);
    }
    return keys;
}

Fetcher::Step Fetcher::advance() {
    Step step;
    while (!queue_.empty()) {
        const auto found = needs_.find(queue_.front());
        if (found != needs_.end()) {
            if (!fits(found->second)) {
                break;
            }
            admit(found->first, found->second, step);
        }
        queue_.pop_front();
    }
    step.ready = std::exchange(ready_, {});
    std::sort(step.want.begin(), step.want.end());
    return step;
}

bool Fetcher::fits(const Need& need) const {
    std::uint64_t bytes = used_bytes_;
    for (const SubtreeKey& key : need.roots) {
        bytes += used_.contains(key) ? 0 : cache_.bytes_expected(key);
    }
    return admitted_ == 0 || bytes <= cache_.bytes_max();
}

void Fetcher::admit(Token token, Need& need, Step& step) {
    need.is_admitted = true;
    ++admitted_;
    Admission& admission = step.admitted.emplace_back();
    admission.token = token;
    for (const SubtreeKey& key : need.roots) {
        const auto [use, is_first] = used_.try_emplace(key);
        if (is_first) {
            use->second.bytes = cache_.bytes_expected(key);
            used_bytes_ += use->second.bytes;
            cache_.pin(key);
        }
        ++use->second.scenarios;
        if (cache_.at(key) != nullptr) {
            ++admission.found;
            continue;
        }
        ++need.missing;
        const auto [request, is_new] = requested_.try_emplace(key);
        request->second.insert(token);
        if (is_new) {
            admission.asked.push_back(key);
            step.want.push_back(key);
        }
    }
    if (need.missing == 0) {
        ready_.push_back(token);
    }
}

void Fetcher::forget_requests(TreeId tree) {
    std::erase_if(requested_, [&](const auto& request) { return request.first.tree == tree; });
}

} // namespace cd
