// A list that grows to millions of elements without copying them.
#pragma once

#include <boost/container/deque.hpp>

#include <cstddef>

namespace cd {

/// Elements in one block of a `GrowingList`.
inline constexpr std::size_t growing_list_block = 1024;

/// A list that stores its elements in blocks of equal size. It grows by adding blocks. A
/// `std::vector` copies its elements to twice the memory, so it needs three times as much
/// meanwhile.
template <class T>
using GrowingList = boost::container::deque<
    T,
    void,
    boost::container::deque_options_t<boost::container::block_size<growing_list_block>>>;

} // namespace cd
