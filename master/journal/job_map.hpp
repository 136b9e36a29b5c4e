// The contact map of a job, from its first result until the job is dropped.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/job/result/contact_map.hpp"

#include <string>

namespace cd {

class JobMap {
  public:
    void add(const ContactMap& map) { total_.add(map); }
    /// Marks the map unusable: part of its sum is wrong, and nobody can tell which.
    void withdraw(const std::string& why) { withdrawn_ = withdrawn_.empty() ? why : withdrawn_; }
    /// Packs the map, to which nothing more is added, to save memory.
    void finish();

    /// Why the map was withdrawn; empty if it is valid.
    [[nodiscard]] const std::string& withdrawn() const { return withdrawn_; }
    /// The finished map, packed. Empty if it was withdrawn.
    [[nodiscard]] const Bytes& packed() const { return packed_; }

  private:
    ContactMapTotal total_;
    Bytes packed_;
    std::string withdrawn_;
};

} // namespace cd
