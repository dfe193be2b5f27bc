// SPDX-License-Identifier: Apache-2.0
// What an update costs of a finger on the same ground as a grid of heights (Proxy) and as a mesh of any shape (ShadowPoint), as a
// point and as a ball, beside CHAI3D; how far facets are from the smooth surface that they stand for, plain and shaded; and how
// many of them a device needs. Each tick is timed in several runs of the same stroke, and its least time counts, as other
// programs take the processor away.
//     facets [--csv | --accuracy | --enough]     --csv and --accuracy for tactics chart
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "tactics/haptics/scenes/mesh_scene.h"
#include "tactics/haptics/scenes/proxy.h"
#include "tactics/haptics/scenes/surface_mesh.h"
#include "tests/bench/strokes.h"
#include "tests/haptics/meshes.h"

namespace tactics {
namespace {

constexpr int kTicks = 50'000, kRuns = 4;

// CHAI3D 3.3.0, cAlgorithmFingerProxy with createAABBCollisionDetector on the same ground and stroke, -O3 -march=native, on a
// shared machine of two cores: as measured once for this project, not by this program. Nanoseconds of the static proxy (one
// constraint a call, the default) and of the dynamic one (all constraints).
struct Chai3d {
    int triangles;
    double radius, static_p50, static_p999, dynamic_p50;
};
constexpr Chai3d kChai3d[] = {
    {1'000, 0, 351, 1'312, 1'072},        {10'000, 0, 421, 2'123, 1'292},         {100'000, 0, 581, 10'145, 1'632},
    {1'000'000, 0, 1'292, 56'915, 2'504}, {1'000, 2, 1'953, 7'331, 5'729},        {10'000, 2, 6'329, 35'663, 17'286},
    {100'000, 2, 33'840, 89'784, 98'457}, {1'000'000, 2, 364'533, 15'199'246, 0},
};

struct Times {
    Nanoseconds each{};
    int unsettled = 0;
};

// `update` gives whether it is settled. Each run begins with a finger far above.
template <typename Begin, typename Update>
Times timed(const std::vector<Point3>& way, Begin begin, Update update) {
    using Clock = std::chrono::steady_clock;
    const auto nanoseconds = [](Clock::time_point from) {
        return std::chrono::duration<double, std::nano>(Clock::now() - from).count();
    };
    std::vector<double> least(way.size(), 1e12), empty(way.size(), 1e12);
    Times times;
    for (int run = 0; run < kRuns; ++run) {
        begin();
        times.unsettled = 0;
        for (std::size_t i = 0; i < way.size(); ++i) {
            const auto idle = Clock::now();
            empty[i] = std::min(empty[i], nanoseconds(idle));
            const auto start = Clock::now();
            const bool settled = update(way[i]);
            least[i] = std::min(least[i], nanoseconds(start));
            times.unsettled += settled ? 0 : 1;
        }
    }
    std::sort(least.begin(), least.end());
    std::sort(empty.begin(), empty.end());
    const double clock = empty[empty.size() / 2];
    times.each = {least[least.size() / 2] - clock, least[least.size() / 1000 * 999] - clock};
    return times;
}

// The ground goes on beside the map for a mesh, as it does for the grid: one more sample, far away, on each side.
Mesh continued(const HeightMap& map) {
    Mesh mesh;
    constexpr double kAway = 50;  // mm
    const int columns = map.columns + 2, rows = map.rows + 2;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int i = std::clamp(column - 1, 0, map.columns - 1), j = std::clamp(row - 1, 0, map.rows - 1);
            const auto beside = [&](int at, int count) { return at == 0 ? -kAway : at == count - 1 ? kAway : 0; };
            mesh.vertices.push_back({(i + 0.5) * map.pitch + beside(column, columns), (j + 0.5) * map.pitch + beside(row, rows),
                                     static_cast<double>(map.at(i, j))});
        }
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * columns + column), b = a + 1,
                       c = a + static_cast<std::uint32_t>(columns), d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    return mesh;
}

void print_costs(bool csv) {
    if (csv)
        std::printf("triangles,radius_mm,method,p50_ns,p99.9_ns,unsettled\n");
    else
        std::printf("%9s %6s  %-22s %10s %10s %10s %8s\n", "triangles", "radius", "method", "p50 ns", "p99.9 ns", "unsettled",
                    "built s");
    const auto row = [&](int triangles, double radius, const char* method, const Nanoseconds& each, int unsettled, double built) {
        if (csv)
            std::printf("%d,%g,%s %g mm,%.0f,%.0f,%d\n", triangles, radius, method, radius, each.p50, each.p999, unsettled);
        else
            std::printf("%9d %6g  %-22s %10.0f %10.0f %10d %8.2f\n", triangles, radius, method, each.p50, each.p999, unsettled,
                        built);
        std::fflush(stdout);
    };
    for (const double radius : {0.0, 2.0})
        for (const int triangles : {1'000, 10'000, 100'000, 1'000'000}) {
            const HeightMap map = stroke_ground(pitch_of(triangles));
            const ReliefSurface felt(dilated(map, radius));
            std::vector<Point3> way = stroke(felt, kTicks);
            Proxy proxy(felt);
            const auto update_grid = [&](const Point3& finger) {
                proxy.follow(finger);
                return proxy.settled();
            };
            const Times grid = timed(
                way, [&] { proxy.lift(); }, update_grid);
            row(triangles, radius, "grid", grid.each, grid.unsettled, 0);
            for (Point3& finger : way) finger.z += radius;
            const auto start = std::chrono::steady_clock::now();
            const MeshTree tree(facets_of(continued(map)));
            const double built = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            ShadowPoint shadow(tree, radius);
            const auto begin = [&] {
                shadow.lift();
                shadow.follow({way[0].x, way[0].y, 50});
            };
            const auto update = [&](const Point3& finger) {
                shadow.follow(finger);
                return shadow.settled();
            };
            const Times facets = timed(way, begin, update);
            row(triangles, radius, "facets", facets.each, facets.unsettled, built);
            for (const Chai3d& other : kChai3d) {
                if (other.triangles != triangles || other.radius != radius) continue;
                row(triangles, radius, "CHAI3D static", {other.static_p50, other.static_p999}, 0, 0);
                if (!csv && other.dynamic_p50 > 0) row(triangles, radius, "CHAI3D all, p50 only", {other.dynamic_p50, 0}, 0, 0);
            }
        }
}

// A ball of 30 mm, 1 mm deep: where the shadow is, and which way the force points, are known.
void print_accuracy() {
    std::printf("facets,method,ns,error_mm,direction_degrees\n");
    constexpr double kBall = 30, kDeep = 1;
    std::vector<Point3> way;
    for (int i = 0; i < kTicks / 5; ++i) {
        const double turn = 0.0033 * i, tilt = 1.2 * std::sin(0.0007 * i);
        way.push_back((kBall - kDeep) * Point3{std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt)});
    }
    for (int cuts = 1; cuts <= 8; ++cuts) {
        const Mesh mesh = tests::ball_mesh(cuts, [](const Point3&) { return kBall; });
        const auto tree = std::make_shared<const MeshTree>(facets_of(mesh));
        for (const bool smooth : {false, true}) {
            MeshScene scene(tree, {{1, 0}, 0, smooth});
            double off = 0, turned = 0;
            const auto begin = [&] {
                scene.begin_again();
                scene.feel({(1 + 5 / kBall) * way[0], {}, 0, 0}, 0.001);
                off = turned = 0;
            };
            const auto update = [&](const Point3& finger) {
                const Point3 force = scene.feel({finger, {}, 0, 0}, 0.001).force, out = (1 / length_of(finger)) * finger;
                const Point3 away = finger + force - kBall * out;
                off += dot(away, away);
                turned += std::pow(std::atan2(length_of(cross(force, out)), dot(force, out)), 2);
                return true;
            };
            const Times times = timed(way, begin, update);
            const auto count = static_cast<double>(way.size());
            std::printf("%zu,%s,%.0f,%.3g,%.3g\n", mesh.triangles.size(), smooth ? "shaded" : "plain", times.each.p50,
                        std::sqrt(off / count), std::sqrt(turned / count) * 180 / std::acos(-1));
            std::fflush(stdout);
        }
    }
}

void print_enough() {
    const HeightMap map = stroke_ground(pitch_of(1'000'000));
    for (const double resolution : {0.055, 0.023}) std::printf("%s\n", enough_facets(map, resolution).words.c_str());
}

}  // namespace
}  // namespace tactics

int main(int count, char** words) {
    const char* wish = count > 1 ? words[1] : "";
    if (std::strcmp(wish, "--accuracy") == 0)
        tactics::print_accuracy();
    else if (std::strcmp(wish, "--enough") == 0)
        tactics::print_enough();
    else
        tactics::print_costs(std::strcmp(wish, "--csv") == 0);
}
