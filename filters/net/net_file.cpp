// SPDX-License-Identifier: Apache-2.0
// The file that train/export.py writes. Nothing in it is believed: sizes are those of the net that is asked for, and weights
// that could make a sum overflow are refused, so that the kernels need not look.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include "filters/net/net.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr std::string_view kMagic = "TNET";
constexpr int kVersion = 1;
constexpr int kMostBlocks = 8;
constexpr int kMostShift = 24;
constexpr int kMostUp = 8;            // -128 shifted by it is as far as 16 bits go
constexpr int kPictureChannels = 24;  // 12 of the picture, 12 of its derivatives

// CRC-32 as zlib computes it.
std::uint32_t checksum_of(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

// Little-endian numbers, one after the other.
class Numbers {
public:
    Numbers(std::string_view bytes, const std::string& place) : bytes_(bytes), place_(place) {}

    std::uint64_t next(int size) {
        if (bytes_.size() < static_cast<std::size_t>(size)) fail(phrase("is cut short"));
        std::uint64_t value = 0;
        for (int i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[static_cast<std::size_t>(i)]);
        bytes_.remove_prefix(static_cast<std::size_t>(size));
        return value;
    }
    int small(int size) { return static_cast<int>(next(size)); }
    std::size_t left() const { return bytes_.size(); }
    [[noreturn]] void fail(const Phrase& what) const {
        throw Error(Fault::failed, place_, phrase("the contour net {0} (install program and nets again)", what));
    }

private:
    std::string_view bytes_;
    const std::string& place_;
};

NetLayer layer(int inputs, int outputs, int side, bool each) {
    NetLayer made;
    made.inputs = inputs;
    made.outputs = outputs;
    made.side = side;
    made.each = each;
    return made;
}

// What fold() in train/model.py lists, for these channels and blocks.
std::vector<NetLayer> layers_for(const std::array<int, 4>& channels, const std::array<int, 4>& blocks) {
    std::vector<NetLayer> layers;
    const auto residual = [&](int width, int side, bool each) {
        layers.push_back(layer(width, width, side, each));
        layers.push_back(layer(width, width, each ? 1 : side, false));
    };
    int inputs = kPictureChannels;
    for (std::size_t scale = 0; scale < 4; ++scale) {
        layers.push_back(layer(inputs, channels[scale], scale == 3 ? 1 : 3, false));
        for (int i = 0; i < blocks[scale]; ++i) residual(channels[scale], scale < 2 ? 3 : 5, scale >= 2);
        inputs = channels[scale];
    }
    layers.push_back(layer(channels[3], channels[2], 1, false));
    residual(channels[2], 5, true);
    layers.push_back(layer(channels[2], channels[1], 1, false));
    residual(channels[1], 3, true);
    layers.push_back(layer(channels[1], channels[0], 1, false));
    layers.push_back(layer(channels[0], channels[0], 3, false));
    layers.push_back(layer(channels[0], 1, 1, false));
    return layers;
}

// Where the kernels look for a weight.
std::size_t place_of(const NetLayer& layer, int filled, int output, int input, int tap) {
    const int number = layer.each ? tap : tap * layer.inputs + input;
    return static_cast<std::size_t>((number / 2 * filled + output) * 2 + number % 2);
}

void read_weights(Numbers& numbers, NetLayer& layer) {
    const int taps = layer.side * layer.side, inputs = layer.each ? 1 : layer.inputs;
    const int filled = (layer.outputs + kChannelGroup - 1) / kChannelGroup * kChannelGroup;
    if (numbers.left() < static_cast<std::size_t>(layer.outputs * (5 + inputs * taps))) numbers.fail(phrase("is cut short"));
    std::vector<int> up;  // of each output: by how many bits its weights are larger than the file has them
    for (int o = 0; o < layer.outputs; ++o) {
        up.push_back(numbers.small(1));
        if (up.back() > kMostUp) numbers.fail(phrase("has weights out of range"));
    }
    layer.bias.assign(static_cast<std::size_t>(filled), 0);
    for (int o = 0; o < layer.outputs; ++o)
        layer.bias[static_cast<std::size_t>(o)] = static_cast<std::int32_t>(static_cast<std::uint32_t>(numbers.next(4)));
    layer.weights.assign(static_cast<std::size_t>((inputs * taps + 1) / 2 * 2 * filled), 0);
    for (int o = 0; o < layer.outputs; ++o) {
        // The largest that a sum can become, with half of what the shift loses.
        long long most = std::llabs(layer.bias[static_cast<std::size_t>(o)]) + (1LL << (layer.shift - 1));
        for (int i = 0; i < inputs; ++i)
            for (int tap = 0; tap < taps; ++tap) {
                const int weight = static_cast<std::int8_t>(numbers.small(1)) * (1 << up[static_cast<std::size_t>(o)]);
                if (std::abs(weight) > std::numeric_limits<std::int16_t>::max()) numbers.fail(phrase("has weights out of range"));
                layer.weights[place_of(layer, filled, o, i, tap)] = static_cast<std::int16_t>(weight);
                most += static_cast<long long>(std::abs(weight)) * kMostActivation;
            }
        if (most > std::numeric_limits<std::int32_t>::max()) numbers.fail(phrase("has sums that can overflow"));
    }
    layer.outputs = filled;
}

}  // namespace

ContourNet ContourNet::from_bytes(std::string_view bytes, const std::string& place) {
    Numbers head(bytes, place);
    if (!bytes.starts_with(kMagic))
        throw Error(Fault::failed, place, phrase("is no contour net (install program and nets again)"));
    head.next(static_cast<int>(kMagic.size()));
    if (const int version = head.small(2); version != kVersion)
        head.fail(
            phrase("is of version {0}, and this program reads version {1}", std::to_string(version), std::to_string(kVersion)));
    if (head.left() < 4) head.fail(phrase("is cut short"));
    const std::string_view checked = bytes.substr(0, bytes.size() - 4);
    if (checksum_of(checked) != Numbers(bytes.substr(checked.size()), place).next(4))
        head.fail(phrase("is damaged or cut short"));

    Numbers numbers(checked.substr(kMagic.size() + 2), place);
    const int count = numbers.small(2);
    ContourNet net;
    for (int& channels : net.channels_) {
        channels = numbers.small(2);
        if (channels < kChannelGroup || channels > kMostChannels || channels % kChannelGroup != 0)
            numbers.fail(phrase("has {0} channels", std::to_string(channels)));
    }
    for (int& blocks : net.blocks_) {
        blocks = numbers.small(2);
        if (blocks > kMostBlocks) numbers.fail(phrase("has {0} blocks at a scale", std::to_string(blocks)));
    }
    net.proof_ = numbers.next(8);
    net.layers_ = layers_for(net.channels_, net.blocks_);
    bool as_expected = count == static_cast<int>(net.layers_.size());
    for (NetLayer& layer : net.layers_) {
        if (!as_expected) break;
        as_expected = numbers.small(2) == layer.outputs && numbers.small(2) == layer.inputs && numbers.small(1) == layer.side &&
                      numbers.small(1) == (layer.each ? 1 : 0);
        layer.shift = numbers.small(1);
        as_expected = as_expected && layer.shift >= 1 && layer.shift <= kMostShift && numbers.small(1) == 0;
    }
    if (!as_expected) numbers.fail(phrase("has other layers than this program knows"));
    for (NetLayer& layer : net.layers_) read_weights(numbers, layer);
    if (numbers.left() != 0) numbers.fail(phrase("goes on after its end"));
    return net;
}

}  // namespace tactics
