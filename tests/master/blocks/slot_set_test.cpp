// Proves that SlotSet agrees with std::set on membership, iteration and intersection.
#include "master/blocks/slot_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <vector>

namespace cd::tests {
namespace {

std::vector<SlotSet::Slot> members_of(const SlotSet& slots) {
    std::vector<SlotSet::Slot> all;
    for (auto slot = slots.next(0); slot != SlotSet::none; slot = slots.next(slot + 1)) {
        all.push_back(slot);
    }
    return all;
}

std::vector<SlotSet::Slot> common_of(const SlotSet& a, const SlotSet& b) {
    std::vector<SlotSet::Slot> all;
    for (auto slot = a.next_common(b, 0); slot != SlotSet::none;
         slot = a.next_common(b, slot + 1)) {
        all.push_back(slot);
    }
    return all;
}

TEST(SlotSets, HaveWhatWasInserted) {
    std::mt19937_64 random(1);
    for (const SlotSet::Slot end : {1u, 63u, 64u, 65u, 300u}) {
        SlotSet slots;
        std::set<SlotSet::Slot> truth;
        for (int i = 0; i < 2000; ++i) {
            const auto slot = static_cast<SlotSet::Slot>(random() % end);
            ASSERT_EQ(slots.contains(slot), truth.contains(slot));
            if (random() % 2 == 0) {
                ASSERT_EQ(slots.insert(slot), truth.insert(slot).second);
            } else {
                ASSERT_EQ(slots.erase(slot), truth.erase(slot) == 1);
            }
            ASSERT_EQ(slots.size(), truth.size());
            ASSERT_EQ(slots.empty(), truth.empty());
            const auto from = static_cast<SlotSet::Slot>(random() % (end + 100));
            const auto next = truth.lower_bound(from);
            ASSERT_EQ(slots.next(from), next == truth.end() ? SlotSet::none : *next);
        }
        EXPECT_TRUE(std::ranges::equal(members_of(slots), truth));
    }
}

TEST(SlotSets, MeetOthersOfAnySize) {
    std::mt19937_64 random(2);
    for (int round = 0; round < 200; ++round) {
        SlotSet a;
        SlotSet b;
        for (int i = 0; i < 100; ++i) {
            a.insert(static_cast<SlotSet::Slot>(random() % (1 + random() % 300)));
            b.insert(static_cast<SlotSet::Slot>(random() % (1 + random() % 300)));
        }
        const auto of_a = members_of(a);
        const auto of_b = members_of(b);
        std::vector<SlotSet::Slot> truth;
        std::ranges::set_intersection(of_a, of_b, std::back_inserter(truth));
        EXPECT_EQ(common_of(a, b), truth);
        EXPECT_EQ(common_of(b, a), truth);
        a.intersect(b);
        EXPECT_EQ(members_of(a), truth);
        EXPECT_EQ(a.size(), truth.size());
    }
}

} // namespace
} // namespace cd::tests
