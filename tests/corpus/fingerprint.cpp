#include "tests/corpus/fingerprint.hpp"

#include <bit>

namespace cd::tests {

void Fingerprint::add(std::uint64_t value) {
    // FNV-1a, 64 bits, byte by byte.
    for (int byte = 0; byte < 8; ++byte) {
        value_ = (value_ ^ (value >> (8 * byte) & 0xff)) * 0x100000001b3;
    }
}

void Fingerprint::add(double value) {
    add(std::bit_cast<std::uint64_t>(value));
}

void Fingerprint::add(const Pose& pose) {
    add(static_cast<std::uint64_t>(pose.kind()));
    if (pose.kind() == Pose::Kind::Matrix) {
        for (int i = 0; i < 9; ++i) {
            add(pose.matrix()(i / 3, i % 3));
        }
    } else {
        const Quaternion& q = pose.quaternion();
        for (const double part : {q.w, q.x, q.y, q.z}) {
            add(part);
        }
    }
    for (const double part : pose.translation()) {
        add(part);
    }
}

void Fingerprint::add(const PosedPair& pair) {
    for (const Corners* t : {&pair.a, &pair.b}) {
        for (const Vec3& corner : *t) {
            for (const double coordinate : corner) {
                add(coordinate);
            }
        }
    }
    add(pair.poses.a);
    add(pair.poses.b);
}

void Fingerprint::add(const Scene& scene) {
    for (const Body* body : {&scene.a, &scene.b}) {
        for (const Vec3& vertex : body->mesh->vertices()) {
            for (const double coordinate : vertex) {
                add(coordinate);
            }
        }
        for (const Triangle& t : body->mesh->triangles()) {
            for (const std::uint32_t corner : t) {
                add(std::uint64_t{corner});
            }
        }
    }
    add(scene.poses.a);
    add(scene.poses.b);
}

} // namespace cd::tests
