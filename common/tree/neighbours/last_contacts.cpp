#include "common/tree/neighbours/last_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cd {

namespace {

/// Bounds how far any point of a box moves between two poses, approximately.
double motion_between(const RelativePose& from, const RelativePose& to, const WideNode& box) {
    Vec3 center(box.origin[0], box.origin[1], box.origin[2]);
    double square = 0;
    constexpr double half = 0.5 * 255;
    for (std::size_t k = 0; k < 3; ++k) {
        const double reach = half * static_cast<double>(box.steps[k]);
        for (std::size_t c = 0; c < 3; ++c) {
            center[static_cast<int>(c)] += reach * static_cast<double>(box.columns[c][k]);
        }
        square += reach * reach;
    }
    const Mat3 turn = to.rotation - from.rotation;
    const Vec3 shift = turn * center + to.translation - from.translation;
    return shift.norm() + std::sqrt(turn.squaredNorm() * square);
}

bool are_same(std::span<const WideNode> left, std::span<const WideNode> right) {
    return left.data() == right.data() && left.size() == right.size();
}

double diagonal_of(const WideNode& box) {
    return 255 * std::hypot(box.steps[0], box.steps[1], box.steps[2]);
}

} // namespace

void LastContacts::move_to(const RelativePose& b_to_a, const WideView& a, const WideView& b) {
    // Smaller shares lose the memory at the ends of a grid's rows.
    constexpr double near_share = 0.4;
    const WideNode& root = b.nodes.front();
    is_near_ = are_same(nodes_a_, a.nodes) && are_same(nodes_b_, b.nodes) &&
               motion_between(pose_, b_to_a, root) <= near_share * diagonal_of(root);
    if (!is_near_) {
        count_ = 0;
    }
    pose_ = b_to_a;
    nodes_a_ = a.nodes;
    nodes_b_ = b.nodes;
}

std::uint32_t LastContacts::Parents::of(const WideView& tree, std::uint32_t block) {
    const std::size_t blocks = tree.triangles.vertex_begin.size() - 1;
    if (!are_same(nodes_, tree.nodes) || of_block_.size() != blocks) {
        nodes_ = tree.nodes;
        of_block_.assign(blocks, 0);
        for (std::uint32_t parent = 0; parent < tree.nodes.size(); ++parent) {
            const WideNode& node = tree.nodes[parent];
            for (std::uint32_t i = 0; !node.is_leaf && i < node.count; ++i) {
                const WideNode& child = tree.nodes[node.first + i];
                if (child.is_leaf) {
                    of_block_[child.first] = parent;
                }
            }
        }
    }
    return of_block_[block];
}

void LastContacts::add(const WideView& a, const WideView& b, const Candidate& contact) {
    if (!is_near_) {
        return;
    }
    const WidePair place{parents_a_.of(a, contact.a / block_size),
                         parents_b_.of(b, contact.b / block_size)};
    const auto end = places_.begin() + static_cast<std::ptrdiff_t>(count_);
    auto at = std::find(places_.begin(), end, place);
    if (at == end) {
        count_ = std::min(count_ + 1, places_max);
        at = places_.begin() + static_cast<std::ptrdiff_t>(count_ - 1);
        *at = place;
    }
    std::rotate(places_.begin(), at, at + 1);
}

void LastContacts::note_answer(bool touches) {
    has_touched_ = touches;
    lately_ = std::clamp(lately_ + (touches ? 1 : -1), 0, lately_max);
}

bool LastContacts::expects_contact() const {
    // Looking for a contact in vain costs less than finding one by planes.
    constexpr int likely = 3;
    return is_near_ ? has_touched_ : lately_ >= likely;
}

} // namespace cd
