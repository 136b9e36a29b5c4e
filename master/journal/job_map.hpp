// The map of a job's contacts, from its first result until the job is dropped.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/job/result/contact_map.hpp"

#include <string>

namespace cd {

class JobMap {
  public:
    void add(const ContactMap& map) { total_.add(map); }
    /// What was summed is not to be used, and nobody can tell which part of it.
    void withdraw(const std::string& why) { withdrawn_ = withdrawn_.empty() ? why : withdrawn_; }
    /// Nothing more comes: it is kept in little memory.
    void finish();

    /// Why it was withdrawn; else empty.
    [[nodiscard]] const std::string& withdrawn() const { return withdrawn_; }
    /// Finished, and packed. Empty when it was withdrawn.
    [[nodiscard]] const Bytes& packed() const { return packed_; }

  private:
    ContactMapTotal total_;
    Bytes packed_;
    std::string withdrawn_;
};

} // namespace cd
