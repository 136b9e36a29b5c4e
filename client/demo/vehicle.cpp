#include "client/demo/vehicle.hpp"

#include "client/demo/sheet.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// A cross-section of a body: half its width, and its lower and upper ends.
struct Station {
    double x;
    double half_width;
    double bottom;
    double top;
};

Station between(std::span<const Station> stations, double u) {
    const double x = stations.front().x + u * (stations.back().x - stations.front().x);
    std::size_t i = 0;
    while (i + 2 < stations.size() && stations[i + 1].x < x) {
        ++i;
    }
    const Station& from = stations[i];
    const Station& to = stations[i + 1];
    const double t = (x - from.x) / (to.x - from.x);
    const double smooth = t * t * (3 - 2 * t);
    const auto mix = [&](double a, double b) { return a + smooth * (b - a); };
    return {
        x, mix(from.half_width, to.half_width), mix(from.bottom, to.bottom), mix(from.top, to.top)};
}

/// A skin around stations, narrower towards the roof, inset by `inset`, with `ribs` waves of
/// `rib_depth` along it.
struct Skin {
    std::vector<Station> stations;
    double taper = 0.2;
    double inset = 0;
    double ribs = 0;
    double rib_depth = 0;
};

Surface skin(Skin shape) {
    return [shape = std::move(shape)](double u, double v) {
        const Station at = between(shape.stations, u);
        const auto [c, s] = boxy_point(v);
        const double in = shape.inset + shape.rib_depth * saw(shape.ribs * u);
        const double wide = (at.half_width - in) * (1 - shape.taper * std::max(0.0, s));
        const double middle = 0.5 * (at.top + at.bottom);
        const double high = 0.5 * (at.top - at.bottom) - in;
        return Vec3(at.x, c * wide, middle + s * high);
    };
}

struct Wheel {
    Vec3 center;
    double radius;
    double half_width;
    double side; ///< -1 or 1: the direction in y that its face looks towards.
};

/// A tyre with lugs, around the y axis.
Surface tyre(const Wheel& wheel) {
    return [wheel](double u, double v) {
        const auto [c, s] = circle_point(u);
        const auto [out, across] = boxy_point(v);
        const double lug = std::clamp(4 * saw(36 * u + (across > 0 ? 0.5 : 0)) - 1.5, 0.0, 1.0);
        const double tube = 0.22 * wheel.radius;
        const double r =
            wheel.radius - tube + out * tube + (out > 0.8 ? 0.03 * lug : 0) * wheel.radius;
        return Vec3(wheel.center + Vec3(r * c, across * wheel.half_width, r * s));
    };
}

Surface rim(const Wheel& wheel) {
    return [wheel](double u, double v) {
        const auto [c, s] = circle_point(u);
        const double r = wheel.radius * (0.12 + 0.5 * v);
        const double dish = wheel.half_width * (0.9 - 0.5 * saw(v)) + 0.02 * saw(10 * u);
        return Vec3(wheel.center + Vec3(r * c, wheel.side * dish, r * s));
    };
}

Surface ball(const Vec3& center, const Vec3& half) {
    return [=](double u, double v) {
        const auto [c, s] = circle_point(u);
        // Leaves a tiny hole at both ends, so that no triangle degenerates to a point.
        const auto [height, width] = circle_point(0.5 * (0.02 + 0.96 * v));
        return Vec3(center + Vec3(half.x() * c * width, half.y() * s * width, half.z() * height));
    };
}

/// A flat or bent panel from `corner` along two edges, with waves of `depth` along the first.
Surface
panel(const Vec3& corner, const Vec3& first, const Vec3& second, double waves, double depth) {
    const Vec3 normal = first.cross(second).normalized();
    return [=](double u, double v) {
        return Vec3(corner + u * first + v * second + depth * saw(waves * u) * normal);
    };
}

/// Half a cylinder above a wheel.
Surface mudguard(const Wheel& wheel) {
    return [wheel](double u, double v) {
        const auto [c, s] = circle_point(0.5 * u);
        const double r = 1.12 * wheel.radius;
        return Vec3(wheel.center + Vec3(r * c, (2 * v - 1) * 1.1 * wheel.half_width, r * s));
    };
}

/// Collects the sheets of a vehicle.
class VehicleSheets {
  public:
    /// Begins a part: the sheets that follow belong to it.
    void begin(std::string part) { part_ = std::move(part); }

    void closed(Surface at, double share, double cells_u_per_v) {
        sheets_.push_back({std::move(at), share, cells_u_per_v, true, false, part_});
    }
    void open(Surface at, double share, double cells_u_per_v) {
        sheets_.push_back({std::move(at), share, cells_u_per_v, false, false, part_});
    }
    void bar(std::vector<Vec3> path, double wide, double high, double share, double ratio) {
        closed(tube({std::move(path), Vec3(0, 0, 1), wide, high, true}), share, ratio);
    }
    void pipe(std::vector<Vec3> path, double radius, double share, double ratio) {
        closed(tube({std::move(path), Vec3(0.1, 0.2, 1), radius, radius, false}), share, ratio);
    }

    void wheel(const Wheel& wheel, double share) {
        sheets_.push_back({tyre(wheel), 0.7 * share, 3, true, true, part_});
        closed(rim(wheel), 0.2 * share, 3);
        for (int i = 0; i < 6; ++i) {
            const auto [c, s] = circle_point(i / 6.0);
            const Vec3 at = wheel.center + Vec3(0.2 * wheel.radius * c,
                                                wheel.side * 0.9 * wheel.half_width,
                                                0.2 * wheel.radius * s);
            pipe({at, at + Vec3(0, 0.03 * wheel.side, 0)}, 0.012, share / 60, 4);
        }
    }

    /// Adds rivets along a line, protruding towards `out`.
    void rivets(const Vec3& from, const Vec3& to, const Vec3& out, int count, double share) {
        for (int i = 0; i < count; ++i) {
            const Vec3 at = from + (i + 0.5) / count * (to - from);
            pipe({at - 0.01 * out, at + 0.006 * out}, 0.008, share / count, 4);
        }
    }

    void seat(const Vec3& at, double share) {
        closed(ball(at, {0.26, 0.25, 0.1}), 0.4 * share, 1);
        closed(ball(at + Vec3(-0.25, 0, 0.35), {0.08, 0.24, 0.36}), 0.45 * share, 1);
        closed(ball(at + Vec3(-0.27, 0, 0.75), {0.05, 0.13, 0.1}), 0.15 * share, 1);
    }

    /// Adds a block with hoses around it.
    void engine(const Vec3& at, double share) {
        begin("engine");
        bar({at - Vec3(0.3, 0, 0), at + Vec3(0.3, 0, 0)}, 0.22, 0.2, 0.2 * share, 1);
        for (int i = 0; i < 4; ++i) {
            const Vec3 row = at + Vec3(-0.24 + 0.16 * i, 0.1, 0.22);
            pipe({row, row + Vec3(0.02, 0.15, 0.06), row + Vec3(0.05, 0.3, -0.1)},
                 0.025,
                 0.1 * share,
                 0.4);
            pipe(
                {row - Vec3(0, 0.2, 0), row + Vec3(-0.04, -0.4, 0.05), row + Vec3(0.1, -0.5, -0.2)},
                0.018,
                0.1 * share,
                0.2);
        }
    }

    /// Adds long thin slats across the front at x.
    void grille(double x, double half_width, double bottom, double top, int count, double share) {
        begin("grille");
        for (int i = 0; i < count; ++i) {
            const double z = bottom + (i + 0.5) / count * (top - bottom);
            bar({{x, -half_width, z}, {x, half_width, z}}, 0.004, 0.012, share / count, 0.25);
        }
    }

    [[nodiscard]] const std::vector<Sheet>& sheets() const { return sheets_; }

  private:
    std::string part_;
    std::vector<Sheet> sheets_;
};

/// Returns "PART_left" for the side 1 (y points to the left), "PART_right" for -1.
std::string on_side(const std::string& part, double side) {
    return part + (side > 0 ? "_left" : "_right");
}

void add_car_body(VehicleSheets& car) {
    const std::vector<Station> body{{0.00, 0.60, 0.45, 0.85},
                                    {0.10, 0.82, 0.30, 1.00},
                                    {0.90, 0.88, 0.22, 1.08},
                                    {1.50, 0.86, 0.20, 1.42},
                                    {2.60, 0.86, 0.20, 1.45},
                                    {3.30, 0.88, 0.20, 1.00},
                                    {4.20, 0.84, 0.22, 0.85},
                                    {4.40, 0.60, 0.40, 0.65}};
    car.begin("body");
    car.closed(skin({body, 0.2, 0, 0, 0}), 22, 1.2);
    car.begin("lining");
    car.closed(skin({body, 0.2, 0.03, 0, 0}), 12, 1);
    car.begin("floor");
    car.open(panel({0.3, -0.75, 0.24}, {3.8, 0, 0}, {0, 1.5, 0}, 16, 0.02), 6, 4);
    car.begin("bumper_rear");
    car.open(panel({0.02, -0.8, 0.5}, {0, 1.6, 0}, {-0.08, 0, -0.15}, 1, 0.05), 1.5, 8);
    car.begin("bumper_front");
    car.open(panel({4.36, -0.8, 0.35}, {0, 1.6, 0}, {0.06, 0, 0.2}, 1, -0.05), 1.5, 8);
    for (const double side : {-1.0, 1.0}) {
        // Trims and sills: one cell wide over several metres.
        car.begin(on_side("trim", side));
        car.bar({{0.7, 0.89 * side, 0.6}, {3.6, 0.89 * side, 0.62}}, 0.008, 0.02, 1, 0.1);
        car.begin(on_side("sill", side));
        car.bar({{0.8, 0.84 * side, 0.25}, {3.4, 0.84 * side, 0.25}}, 0.05, 0.04, 1, 0.15);
        car.begin(on_side("roof_rail", side));
        car.bar({{1.5, 0.68 * side, 1.38}, {2.6, 0.68 * side, 1.41}}, 0.006, 0.01, 0.5, 0.1);
        car.begin(on_side("mirror", side));
        car.closed(ball({3.0, 0.98 * side, 0.98}, {0.06, 0.1, 0.07}), 0.8, 1);
        car.begin(on_side("headlight", side));
        car.closed(ball({4.22, 0.6 * side, 0.66}, {0.14, 0.17, 0.08}), 1, 1);
        car.begin(on_side("tail_light", side));
        car.closed(ball({0.1, 0.62 * side, 0.86}, {0.08, 0.16, 0.07}), 1, 1);
        car.begin(on_side("rivets", side));
        car.rivets({0.9, 0.85 * side, 0.35}, {3.3, 0.85 * side, 0.35}, {0, side, 0}, 24, 1);
    }
}

void add_car_inside(VehicleSheets& car) {
    for (const double side : {-1.0, 1.0}) {
        car.begin(on_side("seat_front", side));
        car.seat({2.2, 0.38 * side, 0.5}, 2);
        car.begin(on_side("seat_rear", side));
        car.seat({1.3, 0.38 * side, 0.5}, 2);
    }
    car.begin("dashboard");
    car.bar({{2.95, -0.72, 0.85}, {2.95, 0.72, 0.85}}, 0.18, 0.12, 3, 1);
    car.engine({3.75, 0, 0.55}, 8);
    car.begin("exhaust");
    car.pipe(
        {{3.4, 0.1, 0.3}, {2.4, 0.15, 0.22}, {1.2, 0.15, 0.22}, {0.1, 0.4, 0.28}}, 0.03, 2, 0.15);
    car.begin("drive_shaft");
    car.pipe({{3.5, -0.1, 0.34}, {0.8, -0.1, 0.3}}, 0.04, 1, 0.1);
    car.grille(4.33, 0.5, 0.42, 0.6, 8, 2);
}

VehicleSheets car_sheets() {
    VehicleSheets car;
    add_car_body(car);
    add_car_inside(car);
    for (const double side : {-1.0, 1.0}) {
        for (const double x : {0.85, 3.5}) {
            const std::string end = x < 2 ? "rear" : "front";
            const Wheel wheel{{x, 0.76 * side, 0.32}, 0.31, 0.1, side};
            car.begin(on_side("wheel_" + end, side));
            car.wheel(wheel, 6);
            car.begin(on_side("mudguard_" + end, side));
            car.open(mudguard(wheel), 1, 2);
        }
    }
    for (const double x : {0.85, 3.5}) {
        car.begin(x < 2 ? "axle_rear" : "axle_front");
        car.pipe({{x, -0.7, 0.32}, {x, 0.7, 0.32}}, 0.035, 0.6, 0.3);
    }
    return car;
}

void add_truck_body(VehicleSheets& truck) {
    const std::vector<Station> cab{{6.9, 1.15, 0.75, 2.6},
                                   {7.1, 1.22, 0.65, 2.95},
                                   {8.3, 1.22, 0.60, 3.0},
                                   {8.8, 1.20, 0.55, 2.1},
                                   {8.9, 1.05, 0.60, 1.8}};
    const std::vector<Station> box{{0, 1.25, 1.2, 3.6}, {6.6, 1.25, 1.2, 3.6}};
    truck.begin("cab");
    truck.closed(skin({cab, 0.12, 0, 0, 0}), 11, 0.6);
    truck.begin("cab_lining");
    truck.closed(skin({cab, 0.12, 0.04, 0, 0}), 6, 0.6);
    truck.begin("box");
    truck.closed(skin({box, 0, 0, 48, 0.02}), 16, 2.5);
    truck.begin("box_lining");
    truck.closed(skin({box, 0, 0.06, 0, 0}), 7, 0.7);
    truck.begin("box_doors");
    truck.open(panel({0, -1.2, 1.25}, {0, 2.4, 0}, {0, 0, 2.3}, 12, 0.02), 2, 2);
    truck.begin("box_front");
    truck.open(panel({6.6, -1.2, 1.25}, {0, 2.4, 0}, {0, 0, 2.3}, 12, 0.02), 2, 2);
    truck.begin("box_floor");
    truck.open(panel({0.1, -1.2, 1.3}, {6.4, 0, 0}, {0, 2.4, 0}, 64, 0.01), 4, 4);
    truck.begin("bumper");
    truck.bar({{8.95, -1.2, 0.65}, {8.95, 1.2, 0.65}}, 0.08, 0.15, 2, 1);
    for (const double side : {-1.0, 1.0}) {
        truck.begin(on_side("rivets", side));
        truck.rivets({0.1, 1.25 * side, 1.3}, {6.5, 1.25 * side, 1.3}, {0, side, 0}, 60, 1.5);
        truck.rivets({0.1, 1.25 * side, 3.4}, {6.5, 1.25 * side, 3.4}, {0, side, 0}, 60, 1.5);
        truck.begin(on_side("rail_low", side));
        truck.bar({{0, 1.27 * side, 1.22}, {6.6, 1.27 * side, 1.22}}, 0.02, 0.05, 1.5, 0.08);
        truck.begin(on_side("rail_top", side));
        truck.bar({{0, 1.24 * side, 3.58}, {6.6, 1.24 * side, 3.58}}, 0.03, 0.03, 1.5, 0.08);
        truck.begin(on_side("mirror", side));
        truck.closed(ball({8.4, 1.4 * side, 2.2}, {0.08, 0.12, 0.25}), 1, 1);
        truck.begin(on_side("headlight", side));
        truck.closed(ball({8.88, 0.9 * side, 0.95}, {0.08, 0.15, 0.1}), 1, 1);
    }
    truck.grille(8.93, 0.8, 1.0, 1.6, 12, 3);
}

void add_truck_frame(VehicleSheets& truck) {
    for (const double side : {-1.0, 1.0}) {
        truck.begin(on_side("beam", side));
        truck.bar({{0.1, 0.45 * side, 0.95}, {8.6, 0.45 * side, 0.95}}, 0.04, 0.13, 3, 0.2);
        truck.begin(on_side("tank", side));
        truck.pipe({{4.4, 0.95 * side, 0.8}, {5.9, 0.95 * side, 0.8}}, 0.3, 2, 1);
        truck.begin(on_side("seat", side));
        truck.seat({7.7, 0.55 * side, 1.3}, 1.5);
    }
    truck.begin("cross_members");
    for (int i = 0; i < 8; ++i) {
        const double x = 0.5 + 1.1 * i;
        truck.bar({{x, -0.45, 0.95}, {x, 0.45, 0.95}}, 0.05, 0.08, 0.5, 0.5);
    }
    truck.engine({8.2, 0, 1.0}, 5);
    truck.begin("exhaust");
    truck.pipe(
        {{8.0, 0.3, 0.8}, {6.8, 0.7, 0.75}, {6.75, 1.1, 1.0}, {6.72, 1.1, 3.2}}, 0.06, 2, 0.2);
    truck.begin("drive_shaft");
    truck.pipe({{7.6, 0, 0.9}, {1.2, 0, 0.6}}, 0.06, 1, 0.1);
}

VehicleSheets truck_sheets() {
    VehicleSheets truck;
    add_truck_body(truck);
    add_truck_frame(truck);
    for (const double x : {1.2, 2.6, 7.6}) {
        const std::string axle = x < 2 ? "rear" : x < 5 ? "middle" : "front";
        truck.begin("axle_" + axle);
        truck.pipe({{x, -1, 0.52}, {x, 1, 0.52}}, 0.07, 0.6, 0.3);
        for (const double side : {-1.0, 1.0}) {
            const Wheel outer{{x, 1.08 * side, 0.52}, 0.51, 0.14, side};
            truck.begin(on_side("wheel_" + axle, side));
            truck.wheel(outer, 3);
            truck.begin(on_side("mudguard_" + axle, side));
            truck.open(mudguard(outer), 1, 2);
            if (x < 5) {
                truck.begin(on_side("inner_wheel_" + axle, side));
                truck.wheel({{x, 0.76 * side, 0.52}, 0.51, 0.14, -side}, 3);
            }
        }
    }
    return truck;
}

} // namespace

std::shared_ptr<const Mesh> make_vehicle(VehicleKind kind, std::uint64_t triangles) {
    const VehicleSheets vehicle = kind == VehicleKind::Car ? car_sheets() : truck_sheets();
    return join_sheets(vehicle.sheets(), triangles);
}

} // namespace cd
