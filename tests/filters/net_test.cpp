// SPDX-License-Identifier: Apache-2.0
// The contour net: every kernel against a slow twin, the shipped weights against what the exporter computed, files that lie.
#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <thread>

#include "filters/edge_map.h"
#include "filters/net/nets.h"
#include "tactics/error.h"
#include "tests/filters/net_twin.h"

namespace tactics::net_test {
namespace {

using net_twin::file_of;
using net_twin::random_net;

ContourNet loaded(const net_twin::Net& net) { return ContourNet::from_bytes(file_of(net), "test.net"); }

std::uint64_t hash_of(const std::vector<std::int16_t>& logits) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto logit : logits)
        for (const int byte : {logit & 255, logit >> 8 & 255}) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

// As drawn_picture() in filters/net/train/integers.py.
Image drawn_picture() {
    Image image = make_image(93, 70, 3, 0.25, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            std::array<int, 3> rgb = {150 - x, 90 + y, 60 + x};
            if ((x - 30) * (x - 30) + (y - 35) * (y - 35) < 400) rgb = {40, 90, 200};
            if (x >= 58 && x < 83 && y >= 12 && y < 50) rgb = {230, 160, 30};
            for (std::size_t c = 0; c < 3; ++c)
                image.row(y)[3 * x + static_cast<int>(c)] =
                    static_cast<std::uint8_t>(rgb[c] + ((x * 7919 ^ y * 10473) >> 3 & 15));
        }
    return image;
}

std::shared_ptr<const ContourNet> shipped() {
    const std::vector<std::string> folder = {std::string(TACTICS_SOURCE_DIR) + "/filters/net/weights"};
    return find_net_in(folder);
}

std::string error_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::failed);
        return error.what();
    }
    return {};
}

TEST(Net, EveryKernelAnswersAsTheSlowTwin) {
    const std::vector<net_twin::Net> nets = {
        random_net({8, 8, 8, 8}, {1, 1, 1, 1}, false, 1), random_net({16, 24, 32, 48}, {1, 1, 2, 1}, false, 2),
        random_net({8, 16, 8, 24}, {0, 2, 0, 1}, true, 3), random_net({16, 24, 32, 48}, {1, 1, 1, 2}, true, 4),
        random_net({24, 8, 40, 16}, {2, 0, 1, 0}, false, 5)};
    const std::vector<Image> images = {pictures::random_colour(33, 16, 1), drawn_picture(), pictures::random_grey(15, 17, 2),
                                       pictures::random_colour(1, 7, 3), pictures::random_grey(1, 1, 4)};
    for (const auto& twin : nets) {
        const ContourNet net = loaded(twin);
        for (const Image& image : images) {
            if (image.width > 50 && twin.blocks[0] == 2) continue;  // the twin takes its time
            const auto expected = net_twin::logits_of(twin, image);
            for (const NetKernel* kernel : net_kernels()) {
                const ContourLogits logits = logits_of(net, image, {.kernel = kernel});
                EXPECT_EQ(logits.width, (image.width + 1) / 2);
                EXPECT_EQ(logits.height, (image.height + 1) / 2);
                EXPECT_EQ(logits.values, expected) << kernel->name << ", " << image.width << " x " << image.height;
            }
        }
    }
}

// Row by row, with what the net itself never has: negative numbers to add, rows shorter than a kernel's tile.
TEST(Net, KernelsAgreeOnRows) {
    pictures::Chance chance(17);
    const auto by_chance = [&](std::size_t count, int most) {
        std::vector<std::int16_t> values(count);
        for (auto& value : values) value = static_cast<std::int16_t>(chance.below(2 * most + 1) - most);
        return values;
    };
    if (net_kernels().size() < 2) GTEST_SKIP() << "this machine has one kernel";
    for (int i = 0; i < 200; ++i) {
        NetLayer layer;
        layer.inputs = 8 * (1 + chance.below(6));
        layer.outputs = 8 * (1 + chance.below(8));
        layer.side = 1 + 2 * chance.below(2);
        layer.shift = 1 + chance.below(16);
        const int seen = layer.side * layer.side * layer.inputs, pixels = 1 + chance.below(20);
        // As large as sums can be without passing int32.
        layer.weights = by_chance(static_cast<std::size_t>(seen * layer.outputs), std::min(32767, 262'000 / seen - 1));
        for (int o = 0; o < layer.outputs; ++o) layer.bias.push_back(chance.below(1 << 20) - (1 << 19));
        const auto size = [&](int channels) { return static_cast<std::size_t>((pixels + layer.side + kReadBeyond) * channels); };
        std::vector<std::vector<std::int16_t>> in;
        for (int row = 0; row < 3; ++row) in.push_back(by_chance(size(layer.inputs), kMostActivation));
        const std::vector<std::int16_t> add = by_chance(size(layer.outputs), kMostActivation);
        std::vector<std::vector<std::int16_t>> out;
        for (const NetKernel* kernel : net_kernels()) {
            out.emplace_back(size(layer.outputs), std::int16_t{-1});
            kernel->dense({&layer,
                           {in[0].data(), in[1].data(), in[2].data()},
                           i % 3 == 0 ? nullptr : add.data(),
                           out.back().data(),
                           pixels,
                           i % 2 == 0 ? 0 : -kMostActivation});
            EXPECT_EQ(out.back(), out.front()) << kernel->name;  // what lies beyond the row is left alone, too
        }
    }
}

// Or the first test compares nothing with nothing.
TEST(Net, TheTwinsNetsAreLively) {
    for (const bool wild : {false, true}) {
        const auto logits = net_twin::logits_of(random_net({16, 24, 32, 48}, {1, 1, 2, 1}, wild, 2), drawn_picture());
        EXPECT_GT(std::set<std::int16_t>(logits.begin(), logits.end()).size(), 20u) << wild;
    }
}

// Every kernel hands on one of its corners undiminished, so that a logit sees as far as a net can. It begins small, for every
// block doubles it; or large, so that the last trace of what is farthest away still counts.
net_twin::Net far_sighted(bool upper_left, bool large) {
    net_twin::Net net = random_net({8, 8, 8, 8}, {1, 1, 1, 1}, false, 6);
    for (net_twin::Layer& layer : net.layers) {
        const bool first = layer.inputs == 24;
        std::fill(layer.stored.begin(), layer.stored.end(), 0);
        std::fill(layer.up.begin(), layer.up.end(), 0);
        std::fill(layer.bias.begin(), layer.bias.end(), 0);
        const int taps = layer.side * layer.side;
        for (int o = 0; o < layer.outputs; ++o) {
            const int input = layer.each ? 0 : first ? 20 + o % 4 : o;  // the widest derivatives
            const int at = (o * (layer.each ? 1 : layer.inputs) + input) * taps + (upper_left ? 0 : taps - 1);
            layer.stored[static_cast<std::size_t>(at)] = 64;
        }
        layer.shift = first && !large ? 12 : 6;
    }
    return net;
}

TEST(Net, TilesAreNotSeen) {
    const Image image = pictures::random_colour(703, 599, 7);
    for (const auto& twin : {random_net({8, 8, 8, 8}, {1, 1, 1, 1}, false, 6), far_sighted(true, false),
                             far_sighted(false, false), far_sighted(true, true), far_sighted(false, true)}) {
        const ContourNet net = loaded(twin);
        const ContourLogits whole = logits_of(net, image), tiled = logits_of(net, image, {.most_pixels = 1});
        EXPECT_GT(std::set<std::int16_t>(whole.values.begin(), whole.values.end()).size(), 100u);
        EXPECT_TRUE(whole.values == tiled.values);
    }
}

TEST(Net, TheShippedWeightsAnswerAsTheirExporterSays) {
    const auto net = shipped();
    if (!net) GTEST_SKIP() << "the weights were deleted";
    EXPECT_EQ(net->channels(), (std::array<int, 4>{16, 24, 32, 48}));
    for (const NetKernel* kernel : net_kernels())
        EXPECT_EQ(hash_of(logits_of(*net, drawn_picture(), {.kernel = kernel}).values), net->proof()) << kernel->name;
}

TEST(Net, ContoursOfThingsStandOut) {
    const auto net = shipped();
    if (!net) GTEST_SKIP() << "the weights were deleted";
    Image image = make_image(160, 120, 3, 0.25, 90);
    for (int y = 30; y < 90; ++y) std::fill_n(image.row(y) + 3 * 40, 3 * 80, std::uint8_t{180});
    const EdgeMap map = contour_map(*net, image);
    ASSERT_EQ(map.strength.size(), 160u * 120u);
    ASSERT_EQ(map.normal.size(), map.strength.size());
    EXPECT_FALSE(map.thinned);
    EXPECT_EQ(map.mm_per_pixel, image.mm_per_pixel);
    const auto at = [&](const std::vector<float>& values, int x, int y) { return values[static_cast<std::size_t>(160 * y + x)]; };
    EXPECT_GT(at(map.strength, 40, 60), 128);
    EXPECT_GT(at(map.strength, 80, 30), 128);
    EXPECT_LT(at(map.strength, 80, 60), 26);
    EXPECT_LT(at(map.strength, 12, 12), 26);
    EXPECT_LT(std::abs(std::sin(at(map.normal, 40, 60))), 0.2) << "across an upright edge is along the rows";
    EXPECT_LT(std::abs(std::cos(at(map.normal, 80, 30))), 0.2);
    // A thin line around it, about where the box ends.
    const EdgeMap thin = thin_edges(map, {});
    int crossed = 0;
    for (int x = 20; x < 60; ++x) crossed += at(thin.strength, x, 60) > 100 ? 1 : 0;
    EXPECT_EQ(crossed, 1);
}

TEST(Net, BlankPicturesAndNoiseGiveNoInk) {
    const auto net = shipped();
    if (!net) GTEST_SKIP() << "the weights were deleted";
    pictures::Chance chance(5);
    const auto slope = [](int x, int y) { return 60 + x / 2.0 + y / 3.0; };
    const std::vector<Image> blanks = {
        make_image(200, 150, 3, 0.25, 0), make_image(200, 150, 1, 0.25, 255), pictures::drawn(200, 150, slope),
        pictures::drawn(200, 150, [&](int, int) { return 128 + 5 * chance.normal(); }),
        pictures::drawn(200, 150, [&](int x, int y) { return slope(x, y) + 15 * chance.normal(); })};
    for (std::size_t i = 0; i < blanks.size(); ++i) {
        const EdgeMap map = contour_map(*net, blanks[i]);
        const auto ink = std::count_if(map.strength.begin(), map.strength.end(), [](float s) { return s > 102; });
        EXPECT_LE(ink, 30) << "blank " << i << " of 30000 pixels";
    }
}

TEST(Net, MapsOfAnySizeAreWhole) {
    const ContourNet net = loaded(random_net({8, 8, 8, 8}, {1, 1, 1, 1}, false, 8));
    const std::vector<double> sizes = {0.7, 1, 1.5};
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {15, 17}, {33, 16}, {64, 3}})
        for (const Image& image : {pictures::random_colour(width, height, 9), pictures::random_grey(width, height, 9),
                                   make_image(width, height, 3, 0, 77)}) {
            const EdgeMap map = contour_map(net, image, sizes);
            ASSERT_EQ(map.strength.size(), static_cast<std::size_t>(width * height));
            ASSERT_EQ(map.normal.size(), map.strength.size());
            for (const float s : map.strength) EXPECT_TRUE(s >= 0 && s <= 255);
            for (const float n : map.normal) EXPECT_TRUE(n >= 0 && n < 3.1415927f);
        }
}

TEST(Net, StrengthIsTheProbabilityBetweenTheLogits) {
    const ContourNet net = loaded(random_net({8, 8, 8, 8}, {1, 1, 1, 1}, false, 10));
    const Image image = pictures::random_colour(40, 30, 11);
    const ContourLogits logits = logits_of(net, image);
    const EdgeMap map = contour_map(net, image);
    const auto logit = [&](int x, int y) {
        return logits.values[static_cast<std::size_t>(std::clamp(y, 0, 14) * 20 + std::clamp(x, 0, 19))] / 256.0;
    };
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const int beside = x / 2 + x % 2 * 2 - 1, beyond = y / 2 + y % 2 * 2 - 1;
            const double mean =
                (9 * logit(x / 2, y / 2) + 3 * logit(beside, y / 2) + 3 * logit(x / 2, beyond) + logit(beside, beyond)) / 16;
            EXPECT_NEAR(static_cast<double>(map.strength[static_cast<std::size_t>(40 * y + x)]), 255 / (1 + std::exp(-mean)),
                        0.02);
        }
}

// The mean over sizes lies between what the sizes give, and a size twice as large has its contours at the same place.
TEST(Net, SizesAreAveraged) {
    const auto net = shipped();
    if (!net) GTEST_SKIP() << "the weights were deleted";
    const std::vector<double> one = {1.5}, other = {0.7}, both = {1.5, 0.7};
    const EdgeMap a = contour_map(*net, drawn_picture(), one), b = contour_map(*net, drawn_picture(), other),
                  mean = contour_map(*net, drawn_picture(), both), plain = contour_map(*net, drawn_picture());
    double product = 0, squares = 0, plain_squares = 0;
    for (std::size_t i = 0; i < mean.strength.size(); ++i) {
        EXPECT_NEAR(mean.strength[i], (a.strength[i] + b.strength[i]) / 2, 0.01);
        const double p = static_cast<double>(a.strength[i]), q = static_cast<double>(plain.strength[i]);
        product += p * q;
        squares += p * p;
        plain_squares += q * q;
    }
    EXPECT_GT(product, 0.8 * std::sqrt(squares * plain_squares));
    const std::vector<double> wrong = {0};
    EXPECT_THROW(contour_map(*net, drawn_picture(), wrong), std::logic_error);
}

TEST(Net, ThreadsAndLocalesMakeNoDifference) {
    const ContourNet net = loaded(random_net({16, 24, 32, 48}, {1, 1, 1, 1}, false, 12));
    const EdgeMap alone = contour_map(net, drawn_picture());
    std::vector<EdgeMap> maps(4);
    std::vector<std::thread> threads;
    for (EdgeMap& map : maps) threads.emplace_back([&] { map = contour_map(net, drawn_picture()); });
    for (std::thread& thread : threads) thread.join();
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) std::setlocale(LC_ALL, "C.UTF-8");
    maps.push_back(contour_map(net, drawn_picture()));
    std::setlocale(LC_ALL, before.c_str());
    for (const EdgeMap& map : maps) {
        EXPECT_EQ(map.strength, alone.strength);
        EXPECT_EQ(map.normal, alone.normal);
    }
}

TEST(Net, FilesThatAreCutOrDamagedAreRefused) {
    const std::string whole = file_of(random_net({8, 8, 8, 8}, {0, 0, 1, 1}, false, 13));
    EXPECT_EQ(error_of([&] { ContourNet::from_bytes(whole, "a.net"); }), "");
    pictures::Chance chance(14);
    for (int i = 0; i < 300; ++i) {
        std::string cut = whole.substr(
            0, i < 40 ? static_cast<std::size_t>(i) : static_cast<std::size_t>(chance.below(static_cast<int>(whole.size()))));
        EXPECT_TRUE(error_of([&] { ContourNet::from_bytes(cut, "a.net"); }).starts_with("a.net: "));
        std::string flipped = whole;
        char& hit = flipped[i < 40 ? static_cast<std::size_t>(i)
                                   : static_cast<std::size_t>(chance.below(static_cast<int>(whole.size())))];
        hit = static_cast<char>(hit ^ (1 << chance.below(8)));
        EXPECT_TRUE(error_of([&] { ContourNet::from_bytes(flipped, "a.net"); }).starts_with("a.net: "));
    }
    EXPECT_EQ(error_of([&] { ContourNet::from_bytes(whole.substr(0, whole.size() - 9), "a.net"); }),
              "a.net: the contour net is damaged or cut short (install program and nets again)");
    EXPECT_EQ(error_of([&] { ContourNet::from_bytes("GIF89a", "a.net"); }),
              "a.net: is no contour net (install program and nets again)");
}

// With a checksum that is right, so that it is not what refuses them.
TEST(Net, FilesThatLieAreRefused) {
    net_twin::Net net = random_net({8, 8, 8, 8}, {0, 0, 1, 1}, false, 15);
    const auto refused = [&](const std::string& bytes) { return error_of([&] { ContourNet::from_bytes(bytes, "a.net"); }); };
    const std::string whole = net_twin::unsealed_file(net);
    ASSERT_EQ(refused(net_twin::sealed(whole)), "");
    EXPECT_NE(refused(net_twin::sealed(whole + "x")).find("goes on after its end"), std::string::npos);
    EXPECT_NE(refused(net_twin::sealed(whole.substr(0, whole.size() - 1))).find("cut short"), std::string::npos);
    const auto with = [&](std::size_t at, int value) {
        std::string changed = whole;
        changed[at] = static_cast<char>(value);
        return refused(net_twin::sealed(changed));
    };
    EXPECT_NE(with(4, 9).find("version 9, and this program reads version 1"), std::string::npos);
    EXPECT_NE(with(6, 3).find("other layers"), std::string::npos);
    EXPECT_NE(with(8, 7).find("7 channels"), std::string::npos);
    EXPECT_NE(with(9, 200).find("channels"), std::string::npos);
    EXPECT_NE(with(8, 0).find("0 channels"), std::string::npos);
    EXPECT_NE(with(16, 200).find("200 blocks"), std::string::npos);
    EXPECT_NE(with(36, 5).find("other layers"), std::string::npos) << "the side of a kernel";
    EXPECT_NE(with(38, 0).find("other layers"), std::string::npos) << "a shift of nothing";
    EXPECT_NE(with(38, 60).find("other layers"), std::string::npos);
    net.layers.front().up.front() = 30;
    EXPECT_NE(refused(file_of(net)).find("weights out of range"), std::string::npos);
    net.layers.front().up.front() = 24;
    net.layers.front().stored.front() = -128;  // shifted so far it is the least int, which has no amount
    EXPECT_NE(refused(file_of(net)).find("weights out of range"), std::string::npos);
    net.layers.front().stored.front() = 100;
    net.layers.front().up.front() = 8;
    EXPECT_NE(refused(file_of(net)).find("overflow"), std::string::npos);
    net.layers.front().up.front() = 0;
    // To the last unit: what just fits, and one more.
    net_twin::Layer& last = net.layers.back();
    std::int64_t most = 1LL << (last.shift - 1);
    for (int i = 0; i < last.inputs; ++i) most += std::abs(last.weight(0, i, 0, 0)) * 8191;
    last.bias.front() = static_cast<int>(most - 2147483647);
    EXPECT_EQ(refused(file_of(net)), "");
    --last.bias.front();
    EXPECT_NE(refused(file_of(net)).find("overflow"), std::string::npos);
    last.bias.front() = 0;
    net.layers.front().bias.front() = -2147483647 - 1;
    EXPECT_NE(refused(file_of(net)).find("overflow"), std::string::npos);
}

TEST(Net, IsFoundInTheFirstFolderThatHasIt) {
    const std::filesystem::path top = std::filesystem::path(testing::TempDir()) / "nets_of_test";
    std::filesystem::create_directories(top / "empty");
    std::filesystem::create_directories(top / "bad");
    std::filesystem::create_directories(top / "good");
    std::ofstream(top / "bad" / "bsds500.net") << "no net";
    std::ofstream(top / "good" / "bsds500.net", std::ios::binary) << file_of(random_net({8, 8, 8, 8}, {0, 0, 0, 0}, false, 16));
    const auto in = [&](const char* name) { return (top / name).string(); };
    const std::vector<std::string> none = {"", in("empty"), in("absent")}, second = {in("empty"), in("good"), in("bad")},
                                   bad = {in("bad"), in("good")};
    EXPECT_EQ(find_net_in(none), nullptr);
    EXPECT_NE(find_net_in(second), nullptr);
    EXPECT_EQ(error_of([&] { find_net_in(bad); }),
              in("bad") + "/bsds500.net: is no contour net (install program and nets again)");
    std::filesystem::remove_all(top);
}

// The program in the build folder has its nets beside it.
TEST(Net, IsFoundByTheProgramThatWasBuilt) {
    if (!shipped()) GTEST_SKIP() << "the weights were deleted";
    const auto net = find_net();
    ASSERT_NE(net, nullptr);
    EXPECT_EQ(net, find_net()) << "read once";
}

}  // namespace
}  // namespace tactics::net_test
