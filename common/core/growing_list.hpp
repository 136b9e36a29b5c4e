// A list of millions of elements that grows without copying them.
#pragma once

#include <boost/container/deque.hpp>

#include <cstddef>

namespace cd {

/// Elements in one block of a `GrowingList`.
inline constexpr std::size_t growing_list_block = 1024;

/// A list in blocks of equal size. Growing adds blocks, while a `std::vector` would copy all
/// elements, and would need memory for three times as many while it does.
template <class T>
using GrowingList = boost::container::deque<
    T,
    void,
    boost::container::deque_options_t<boost::container::block_size<growing_list_block>>>;

} // namespace cd
