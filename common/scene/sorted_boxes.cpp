#include "common/scene/sorted_boxes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace cd {

SortedBoxes::SortedBoxes(std::span<const WorldBox> boxes,
                         std::span<const std::uint32_t> order,
                         const std::array<std::size_t, 3>& axes)
    : body_(order.size() + sweep_padding, 0) {
    std::ranges::copy(order, body_.begin());
    for (std::size_t k = 0; k < 3; ++k) {
        low_[k].resize(body_.size(), std::numeric_limits<float>::quiet_NaN());
        high_[k].resize(body_.size(), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t at = 0; at < order.size(); ++at) {
            low_[k][at] = boxes[order[at]].low[axes[k]];
            high_[k][at] = boxes[order[at]].high[axes[k]];
        }
    }
}

SweepColumns SortedBoxes::columns() const {
    return {{low_[0].data(), low_[1].data(), low_[2].data()},
            {high_[0].data(), high_[1].data(), high_[2].data()},
            body_.data(),
            static_cast<std::uint32_t>(count())};
}

void PairCollector::add_within(const SortedBoxes& boxes) {
    add(boxes, boxes, SweepFrom::Next);
}

void PairCollector::add_between(const SortedBoxes& left, const SortedBoxes& right) {
    add(left, right, SweepFrom::Equal);
    add(right, left, SweepFrom::After);
}

void PairCollector::add(const SortedBoxes& rows, const SortedBoxes& others, SweepFrom from) {
    const std::size_t row_keys = others.count() + sweep_padding;
    blocks_.resize(std::max(blocks_.size(), row_keys));
    SweepPlace place;
    while (place.row < rows.count()) {
        if (keys_.size() - count_ < row_keys) {
            keys_.resize(std::max(2 * keys_.size(), count_ + 4 * row_keys));
        }
        count_ += write_overlaps(rows.columns(),
                                 others.columns(),
                                 from,
                                 place,
                                 blocks_,
                                 std::span(keys_).subspan(count_));
    }
}

std::vector<std::uint32_t> PairCollector::take() {
    keys_.resize(std::exchange(count_, 0));
    return std::move(keys_);
}

} // namespace cd
