// The contact map of a job, from its first result until the job is dropped.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/job/result/contact_map.hpp"
#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

/// True if contacts of a job are summed: by triangle and part with maps, else by part where results
/// list pairs. Sums are of two bodies, so a job with more has none.
[[nodiscard]] inline bool sums_contacts(const Submit& submit) {
    return submit.bodies.size() <= 2 && (submit.query.maps || submit.query.level >= Level::Pairs);
}

class JobMap {
  public:
    void add(const ContactMap& map) { total_.add(map); }
    /// Marks the map as unusable: it contains wrong contributions, which cannot be subtracted.
    void withdraw(const std::string& why) { withdrawn_ = withdrawn_.empty() ? why : withdrawn_; }
    /// Packs the map to save memory. Nothing may be added afterwards.
    void finish();

    /// Reason why the map was withdrawn; empty if it is valid.
    [[nodiscard]] const std::string& withdrawn() const { return withdrawn_; }
    /// The packed map. Empty before `finish`, and if the map was withdrawn.
    [[nodiscard]] const Bytes& packed() const { return packed_; }
    /// Returns the packed map without triangles, also before `finish`; empty if it was withdrawn.
    [[nodiscard]] Bytes packed_parts() const;

  private:
    ContactMapTotal total_;
    Bytes packed_;
    Bytes packed_parts_; ///< Empty before `finish`.
    std::string withdrawn_;
};

} // namespace cd
