// Handles of Embree that are released by themselves.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>

namespace cd::bench {

struct ReleaseEmbree {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

template <class Handle>
using EmbreeOwned = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseEmbree>;

} // namespace cd::bench
