#include "common/tree/planes/plane_stack.hpp"

namespace cd {

namespace {

/// More steps part hardly more pairs than opening their nodes does.
constexpr std::uint32_t plane_steps = 3;

} // namespace

void PlaneStack::reset(const PlanePose& pose, const WideView& a, const WideView& b) {
    pose_ = pose;
    a_.emplace(a);
    b_.emplace(b);
    pairs_.clear();
}

void PlaneStack::push_roots() {
    pairs_.push_back({{0, 0}, first_normal(pose_)});
}

std::optional<WidePair> PlaneStack::next() {
    while (!pairs_.empty()) {
        Waiting pair = pairs_.back();
        pairs_.pop_back();
        if (!separate(pose_, *a_, pair.nodes.a, *b_, pair.nodes.b, plane_steps, pair.normal)) {
            normal_ = pair.normal;
            return pair.nodes;
        }
    }
    return std::nullopt;
}

void PlaneStack::push_children(std::span<const WidePair> pairs) {
    for (const WidePair& pair : pairs) {
        pairs_.push_back({pair, normal_});
    }
}

WidePair PlaneStack::pop() {
    const WidePair pair = pairs_.back().nodes;
    pairs_.pop_back();
    return pair;
}

} // namespace cd
