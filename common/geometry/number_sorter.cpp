#include "common/geometry/number_sorter.hpp"

#include <hwy/contrib/sort/vqsort.h>

namespace cd {

struct NumberSorter::Scratch {
    hwy::Sorter sorter;
};

NumberSorter::NumberSorter() : scratch_(std::make_unique<Scratch>()) {}
NumberSorter::~NumberSorter() = default;

void NumberSorter::sort(std::vector<std::uint32_t>& numbers) const {
    scratch_->sorter(numbers.data(), numbers.size(), hwy::SortAscending());
}

void NumberSorter::sort(std::vector<std::uint64_t>& numbers) const {
    scratch_->sorter(numbers.data(), numbers.size(), hwy::SortAscending());
}

} // namespace cd
