// SPDX-License-Identifier: Apache-2.0
// What an update costs of a finger on the same ground as a grid of heights (Proxy) and as a mesh of any shape (ShadowPoint),
// whole and with no more facets than a device tells (enough_facets), as a point and as a ball, beside CHAI3D; how far facets are
// from the smooth surface that they stand for, plain and shaded; how many of them a device needs, and how long it takes until
// they can be felt. Each tick is timed in several runs of the same stroke, and its least time counts, as other programs take the
// processor away; "first" is 99.9 % of the first run alone, when nothing is in the caches yet. "work" counts what 99.9 % of the
// ticks look at (ShadowPoint::work), "moves" those of the ticks beyond.
//     facets [--csv | --accuracy | --enough | --levels | --shares]     --csv, --accuracy, --levels and --shares for tactics chart
// --shares: less work a tick, on a million facets, against how far that leaves the finger from where it should be.
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <numeric>
#include <string>

#include "tactics/haptics/scenes/enough_mesh.h"
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
    double p99 = 0, most = 0, mean = 0;
    double first = 0, work = 0,
           moves = 0;  // 99.9 % of the first run alone; of what each tick looked at; moves of the ticks beyond
    int unsettled = 0;
};

// `update` gives whether it is settled. Each run begins with a finger far above.
template <typename Begin, typename Update>
Times timed(const std::vector<Point3>& way, Begin begin, Update update) {
    using Clock = std::chrono::steady_clock;
    const auto nanoseconds = [](Clock::time_point from) {
        return std::chrono::duration<double, std::nano>(Clock::now() - from).count();
    };
    std::vector<double> least(way.size(), 1e12), empty(way.size(), 1e12), first;
    Times times;
    for (int run = 0; run < kRuns; ++run) {
        begin();
        times.unsettled = 0;
        for (std::size_t i = 0; i < way.size(); ++i) {
            const auto idle = Clock::now();
            empty[i] = std::min(empty[i], nanoseconds(idle));
            const auto start = Clock::now();
            const bool settled = update(way[i]);
            const double took = nanoseconds(start);
            if (run == 0) first.push_back(took);
            least[i] = std::min(least[i], took);
            times.unsettled += settled ? 0 : 1;
        }
    }
    std::sort(least.begin(), least.end());
    std::sort(first.begin(), first.end());
    std::sort(empty.begin(), empty.end());
    const double clock = empty[empty.size() / 2];
    times.each = {least[least.size() / 2] - clock, least[least.size() / 1000 * 999] - clock};
    times.p99 = least[least.size() / 100 * 99] - clock;
    times.most = least.back() - clock;
    times.first = first[first.size() / 1000 * 999] - clock;
    times.mean = std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(least.size()) - clock;
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

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What is counted is the same in each run, and on each machine.
template <typename Begin>
Times with_work(Times times, const std::vector<Point3>& way, Begin begin, ShadowPoint& shadow) {
    begin();
    std::vector<std::pair<int, int>> ticks;  // work, moves
    for (const Point3& finger : way) {
        shadow.follow(finger);
        ticks.emplace_back(shadow.work(), shadow.moves());
    }
    std::sort(ticks.begin(), ticks.end());
    const std::size_t beyond = ticks.size() / 1000 * 999;
    times.work = ticks[beyond].first;
    for (std::size_t i = beyond; i < ticks.size(); ++i)
        times.moves += ticks[i].second / static_cast<double>(ticks.size() - beyond);
    return times;
}

Times times_on(const MeshTree& tree, double radius, const std::vector<Point3>& way, int tick_work = ShadowPoint::kTickWork) {
    ShadowPoint shadow(tree, radius, tick_work);
    const auto begin = [&] {
        shadow.lift();
        shadow.follow({way[0].x, way[0].y, 50});
    };
    const Times times = timed(way, begin, [&](const Point3& finger) {
        shadow.follow(finger);
        return shadow.settled();
    });
    return with_work(times, way, begin, shadow);
}

void print_row(bool csv, int triangles, std::size_t kept, double radius, const std::string& method, const Times& times,
               double ready) {
    if (csv)
        std::printf("%d,%zu,%s %g mm,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.1f,%d,%.3f\n", triangles, kept, method.c_str(), radius,
                    times.each.p50, times.p99, times.each.p999, times.first, times.most, times.work, times.moves, times.unsettled,
                    ready);
    else
        std::printf("%9d %8zu %6g  %-16s %9.0f %9.0f %9.0f %9.0f %9.0f %6.0f %5.1f %10d %8.3f\n", triangles, kept, radius,
                    method.c_str(), times.each.p50, times.p99, times.each.p999, times.first, times.most, times.work, times.moves,
                    times.unsettled, ready);
    std::fflush(stdout);
}

void print_costs(bool csv) {
    std::printf(csv ? "triangles,kept,method,p50_ns,p99_ns,p99.9_ns,first_p99.9_ns,most_ns,work,moves,unsettled,ready_s\n"
                    : "triangles     kept radius  method              p50 ns    p99 ns  p99.9 ns     first   most ns   work "
                      "moves  unsettled  ready s\n");
    for (const double radius : {0.0, 2.0})
        for (const int triangles : {1'000, 10'000, 100'000, 1'000'000}) {
            const HeightMap map = stroke_ground(pitch_of(triangles));
            const ReliefSurface felt(dilated(map, radius));
            std::vector<Point3> way = stroke(felt, kTicks);
            Proxy proxy(felt);
            const auto all = static_cast<std::size_t>(triangles);
            const Times grid = timed(
                way, [&] { proxy.lift(); },
                [&](const Point3& finger) {
                    proxy.follow(finger);
                    return proxy.settled();
                });
            print_row(csv, triangles, all, radius, "grid", grid, 0);
            for (Point3& finger : way) finger.z += radius;
            const Mesh mesh = continued(map);
            for (const double resolution : {0.0, 0.023, 0.055}) {
                std::unique_ptr<MeshTree> tree;
                const double ready = seconds_of([&] {
                    MeshFacets facets = facets_of(mesh);
                    if (resolution > 0) facets = enough_facets(std::move(facets), resolution).facets;
                    tree = std::make_unique<MeshTree>(std::move(facets));
                });
                char name[40] = "facets";
                if (resolution > 0) std::snprintf(name, sizeof name, "for %g mm", resolution);
                print_row(csv, triangles, tree->facets().facets.size(), radius, name, times_on(*tree, radius, way), ready);
            }
            for (const Chai3d& other : kChai3d) {
                if (csv || other.triangles != triangles || other.radius != radius) continue;
                std::printf("%9d %8zu %6g  %-16s %9.0f %9s %9.0f\n", triangles, all, radius, "CHAI3D static", other.static_p50,
                            "", other.static_p999);
                if (other.dynamic_p50 > 0)
                    std::printf("%9d %8zu %6g  %-16s %9.0f\n", triangles, all, radius, "CHAI3D all", other.dynamic_p50);
            }
        }
}

// Coarser and coarser facets of the ground of 1e6: what they cost, and how far they are from it at most.
void print_levels() {
    std::printf("kept,method,ns,error_mm,bound_mm\n");
    const HeightMap map = stroke_ground(pitch_of(1'000'000));
    const MeshFacets all = facets_of(continued(map));
    for (const double radius : {0.0, 2.0}) {
        const ReliefSurface felt(dilated(map, radius));
        std::vector<Point3> way = stroke(felt, kTicks / 5);
        for (Point3& finger : way) finger.z += radius;
        for (const double tolerance : {0.005, 0.011, 0.023, 0.055, 0.11, 0.22, 0.44}) {
            EnoughMesh enough = enough_facets(all, tolerance);
            const MeshTree tree(std::move(enough.facets));
            double most = 0;
            for (const Point3& corner : all.corners) {
                int work = ShadowPoint::kMostWork;
                most = std::max(most, tree.nearest(corner, 10, {}, work).distance);
            }
            std::printf("%zu,%s,%.0f,%.3g,%.3g\n", tree.facets().facets.size(), radius > 0 ? "ball 2 mm" : "point",
                        times_on(tree, radius, way).mean, most, enough.error);
            std::fflush(stdout);
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

// The share of work that a tick has, on a million facets: what a tick takes, how many go on in the next, and how far that leaves
// the shadow from where it would be without end.
void print_shares() {
    std::printf("method,work,p99.9_ns,unsettled,off_p99.9_mm,off_most_mm\n");
    const HeightMap map = stroke_ground(pitch_of(1'000'000));
    const MeshTree tree(facets_of(continued(map)));
    for (const double radius : {0.0, 2.0}) {
        const ReliefSurface felt(dilated(map, radius));
        std::vector<Point3> way = stroke(felt, kTicks);
        for (Point3& finger : way) finger.z += radius;
        const auto places = [&](int share) {
            ShadowPoint shadow(tree, radius, share);
            shadow.follow({way[0].x, way[0].y, 50});
            std::vector<Point3> all;
            for (const Point3& finger : way) all.push_back(shadow.follow(finger));
            return all;
        };
        const std::vector<Point3> settled = places(ShadowPoint::kMostWork);
        for (const int share : {200, 300, 450, 700, 1'000, 1'500, 3'000}) {
            const Times times = times_on(tree, radius, way, share);
            const std::vector<Point3> now = places(share);
            std::vector<double> off;
            for (std::size_t i = 0; i < way.size(); ++i) off.push_back(length_of(now[i] - settled[i]));
            std::sort(off.begin(), off.end());
            std::printf("%s,%d,%.0f,%d,%.3g,%.3g\n", radius > 0 ? "ball 2 mm" : "point", share, times.each.p999, times.unsettled,
                        off[off.size() / 1000 * 999], off.back());
            std::fflush(stdout);
        }
    }
}

void print_enough() {
    const HeightMap map = stroke_ground(pitch_of(1'000'000));
    for (const double resolution : {0.055, 0.023})
        std::printf("as a grid: %s\n", enough_facets(map, resolution).words.english().c_str());
    const MeshFacets all = facets_of(continued(map));
    for (const double resolution : {0.055, 0.023})
        std::printf("as a mesh: %s\n", enough_facets(all, resolution).words.english().c_str());
}

}  // namespace
}  // namespace tactics

int main(int count, char** words) {
    const char* wish = count > 1 ? words[1] : "";
    if (std::strcmp(wish, "--accuracy") == 0)
        tactics::print_accuracy();
    else if (std::strcmp(wish, "--enough") == 0)
        tactics::print_enough();
    else if (std::strcmp(wish, "--levels") == 0)
        tactics::print_levels();
    else if (std::strcmp(wish, "--shares") == 0)
        tactics::print_shares();
    else
        tactics::print_costs(std::strcmp(wish, "--csv") == 0);
}
