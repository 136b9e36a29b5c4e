#include "worker/peers/fetcher.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/worker.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cd {

void Fetcher::add(Token token, JobId job, std::vector<SubtreeKey> roots) {
    const bool is_new = needs_.try_emplace(token, Need{job, std::move(roots), 0, false}).second;
    CD_CHECK(is_new);
    queue_.push_back(token);
}

bool Fetcher::want_top(TreeId tree) {
    const SubtreeKey top{tree, top_root};
    const bool is_new = !cache_.has(top) && ask_once(top);
    if (is_new) {
        wanted_.push_back(top);
    }
    return is_new;
}

void Fetcher::arrived(const SubtreeKey& key) {
    const auto request = requested_.find(key);
    if (request == requested_.end()) {
        return;
    }
    for (const Token token : request->second.waiting) {
        if (--needs_.at(token).missing == 0) {
            ready_.push_back(token);
        }
    }
    drop_request(request);
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
            request->second.waiting.erase(token);
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
    for (const auto& [key, request] : requested_) {
        keys.push_back(key);
    }
    return keys;
}

Fetcher::Step Fetcher::advance() {
    Step step;
    step.want = std::exchange(wanted_, {});
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
    ask_for_hinted(step);
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
    admission.job = need.job;
    for (const SubtreeKey& key : need.roots) {
        const auto [use, is_first] = used_.try_emplace(key);
        if (is_first) {
            use->second.bytes = cache_.bytes_expected(key);
            used_bytes_ += use->second.bytes;
            cache_.pin(key);
        }
        ++use->second.scenarios;
        if (cache_.has(key)) {
            ++admission.found;
            continue;
        }
        ++need.missing;
        if (ask_once(key)) {
            admission.asked.push_back(key);
            step.want.push_back(key);
        }
        requested_.at(key).waiting.insert(token);
    }
    if (need.missing == 0) {
        ready_.push_back(token);
    }
}

// Hints have a queue of their own, so that they never delay blocks that scenarios wait for.
void Fetcher::hint(const Hinted& hinted) {
    hinted_.push_back(hinted);
    if (hinted_.size() > limits::hints_max) {
        hinted_.pop_front();
    }
}

void Fetcher::ask_for_hinted(Step& step) {
    const auto is_needed = [](const auto& request) { return !request.second.waiting.empty(); };
    if (hinted_.empty() || std::any_of(requested_.begin(), requested_.end(), is_needed)) {
        return;
    }
    for (; !hinted_.empty() && requested_bytes_ < limits::hinted_bytes_max; hinted_.pop_front()) {
        const Hinted& hinted = hinted_.front();
        const SubtreeKey& key = hinted.key;
        const std::uint64_t bytes =
            cache_.bytes_in_use() + requested_bytes_ + cache_.bytes_expected(key);
        if (cache_.at(key) == nullptr && bytes <= cache_.bytes_max() && ask_once(key)) {
            step.hinted.push_back(hinted);
            step.want.push_back(key);
        }
    }
}

bool Fetcher::ask_once(const SubtreeKey& key) {
    const auto [request, is_new] = requested_.try_emplace(key);
    if (is_new) {
        request->second.bytes = cache_.bytes_expected(key);
        requested_bytes_ += request->second.bytes;
    }
    return is_new;
}

void Fetcher::drop_request(std::map<SubtreeKey, Request>::iterator request) {
    requested_bytes_ -= request->second.bytes;
    requested_.erase(request);
}

void Fetcher::forget_requests(TreeId tree) {
    std::erase_if(hinted_, [&](const Hinted& hinted) { return hinted.key.tree == tree; });
    std::erase_if(wanted_, [&](const SubtreeKey& key) { return key.tree == tree; });
    for (auto request = requested_.begin(); request != requested_.end();) {
        const auto next = std::next(request);
        if (request->first.tree == tree) {
            drop_request(request);
        }
        request = next;
    }
}

} // namespace cd
