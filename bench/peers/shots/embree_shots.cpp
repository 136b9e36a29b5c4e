// Embree's rays with a filter that keeps each hit and rejects it, so that the search goes on: its
// manual's way to gather all hits. Rays run from 0 to 1 along the whole line.
#include "bench/peers/engines/embree_handles.hpp"
#include "bench/peers/shots/shot_engine.hpp"
#include "common/core/check.hpp"
#include "common/shots/segment_length.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cd::bench {

namespace {

void set_line(RTCRay& ray, const Segment& line, std::uint32_t number) {
    const Vec3 along = line.q - line.p;
    ray.org_x = static_cast<float>(line.p.x());
    ray.org_y = static_cast<float>(line.p.y());
    ray.org_z = static_cast<float>(line.p.z());
    ray.dir_x = static_cast<float>(along.x());
    ray.dir_y = static_cast<float>(along.y());
    ray.dir_z = static_cast<float>(along.z());
    ray.tnear = 0;
    ray.tfar = 1;
    ray.mask = ~0u;
    ray.id = number;
}

/// Sets one ray of a packet.
template <class Packet>
void set_line(Packet& packet, std::size_t i, const Segment& line, std::uint32_t number) {
    RTCRay ray{};
    set_line(ray, line, number);
    packet.org_x[i] = ray.org_x;
    packet.org_y[i] = ray.org_y;
    packet.org_z[i] = ray.org_z;
    packet.dir_x[i] = ray.dir_x;
    packet.dir_y[i] = ray.dir_y;
    packet.dir_z[i] = ray.dir_z;
    packet.tnear[i] = ray.tnear;
    packet.tfar[i] = ray.tfar;
    packet.mask[i] = ray.mask;
    packet.id[i] = ray.id;
}

/// Finds hits with packets of `width` rays; 1: with single rays.
class EmbreeShots final : public ShotBody {
  public:
    EmbreeShots(bool is_robust, std::size_t width) : is_robust_(is_robust), width_(width) {}

    void load(const ShotScene& scene) override {
        device_.reset(rtcNewDevice("threads=1,set_affinity=0"));
        CD_CHECK(device_ != nullptr);
        lines_ = world_lines(scene);
        for (const Segment& line : lines_) {
            lengths_.push_back(segment_length(line));
        }
        scene_.reset(rtcNewScene(device_.get()));
        rtcSetSceneFlags(scene_.get(), is_robust_ ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        add_mesh(*scene.mesh);
        rtcCommitScene(scene_.get());
    }

    void shoot(std::vector<ShotHit>& hits) override {
        hits_ = &hits;
        if (width_ == 16) {
            shoot_packets<RTCRayHit16, 16>(rtcIntersect16);
        } else if (width_ == 8) {
            shoot_packets<RTCRayHit8, 8>(rtcIntersect8);
        } else {
            shoot_single();
        }
    }

  private:
    void add_mesh(const Mesh& mesh) {
        const EmbreeOwned<RTCGeometry> geometry(
            rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(),
                                                                   RTC_BUFFER_TYPE_VERTEX,
                                                                   0,
                                                                   RTC_FORMAT_FLOAT3,
                                                                   3 * sizeof(float),
                                                                   mesh.vertices().size()));
        for (const Vec3& v : mesh.vertices()) {
            vertex = std::copy_n(v.cast<float>().eval().data(), 3, vertex);
        }
        auto* corner =
            static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry.get(),
                                                                RTC_BUFFER_TYPE_INDEX,
                                                                0,
                                                                RTC_FORMAT_UINT3,
                                                                3 * sizeof(std::uint32_t),
                                                                mesh.triangles().size()));
        for (const Triangle& t : mesh.triangles()) {
            corner = std::copy(t.begin(), t.end(), corner);
        }
        rtcSetGeometryUserData(geometry.get(), this);
        rtcSetGeometryIntersectFilterFunction(geometry.get(), keep_and_reject);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene_.get(), geometry.get());
    }

    static void keep_and_reject(const RTCFilterFunctionNArguments* args) {
        auto* self = static_cast<EmbreeShots*>(args->geometryUserPtr);
        for (unsigned i = 0; i < args->N; ++i) {
            if (args->valid[i] == -1) {
                const std::uint32_t line = RTCRayN_id(args->ray, args->N, i);
                const double share = RTCRayN_tfar(args->ray, args->N, i);
                self->hits_->push_back(
                    {line, RTCHitN_primID(args->hit, args->N, i), share * self->lengths_[line]});
                args->valid[i] = 0;
            }
        }
    }

    void shoot_single() {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            RTCRayHit ray{};
            set_line(ray.ray, lines_[i], i);
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_.get(), &context, &ray);
        }
    }

    template <class Packet, std::uint32_t width, class Intersect>
    void shoot_packets(Intersect intersect) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) std::array<int, width> valid{};
        for (std::uint32_t first = 0; first < lines_.size(); first += width) {
            Packet packet{};
            for (std::uint32_t i = 0; i < width; ++i) {
                valid[i] = first + i < lines_.size() ? -1 : 0;
                if (valid[i] != 0) {
                    set_line(packet.ray, i, lines_[first + i], first + i);
                }
                packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            }
            intersect(valid.data(), scene_.get(), &context, &packet);
        }
    }

    bool is_robust_;
    std::size_t width_;
    std::vector<Segment> lines_;
    std::vector<double> lengths_;
    EmbreeOwned<RTCDevice> device_;
    EmbreeOwned<RTCScene> scene_;
    std::vector<ShotHit>* hits_ = nullptr; ///< Of the call in progress.
};

} // namespace

void add_embree_shots(std::vector<ShotEngine>& engines) {
    const auto add = [&](const char* name, bool is_robust, std::size_t width) {
        engines.push_back({name, false, [is_robust, width] {
                               return std::make_unique<EmbreeShots>(is_robust, width);
                           }});
    };
    add("Embree robust", true, 1);
    add("Embree robust, packets of 8", true, 8);
    add("Embree robust, packets of 16", true, 16);
    add("Embree", false, 1);
}

} // namespace cd::bench
