// SPDX-License-Identifier: Apache-2.0
// Dot Pad: pins at equal distances, and mostly a line of braille cells below them, over a serial line on USB.
//
// A packet is AA 55, the count of the following bytes (16 bits, high byte first), a destination, a command (16 bits), a number,
// data, and a checksum: A5h XOR all bytes from the destination on. Each row of cells (two pins across, four down) is a separate
// packet.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "print/dots.h"
#include "print/embosser.h"
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/pin_display.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kDotPadOptions[] = {
    {.name = "columns",
     .type = Option::Type::whole,
     .fallback = 60,
     .min = 8,
     .max = 160,
     .unit = "pins",
     .summary = "number of pins from left to right"},
    {.name = "rows",
     .type = Option::Type::whole,
     .fallback = 40,
     .min = 8,
     .max = 160,
     .unit = "pins",
     .summary = "number of pins from top to bottom"},
    {.name = "pitch",
     .type = Option::Type::length,
     .fallback = 2.5,
     .min = 1,
     .max = 10,
     .unit = "mm",
     .summary = "distance from pin to pin"},
    {.name = "text",
     .type = Option::Type::whole,
     .fallback = 20,
     .min = 0,
     .max = 80,
     .unit = "cells",
     .summary = "cells in the braille line that shows the title; 0: it has no such line, and the pins show the title"},
    {.name = "first",
     .type = Option::Type::whole,
     .fallback = 1,
     .min = 0,
     .max = 8,
     .summary = "number of the uppermost row of pins, after the lines of text"},
};

constexpr ProtocolFact kDotPadFacts[] = {
    {"packets with a checksum, A5h XOR all bytes from the destination on; command 0200h carries a zero, then the cells of the "
     "row given as the destination",
     "BRLTTY, driver DotPad", Confidence::good},
    {"dots 1 2 3 7 of a cell are bits 0 to 3, dots 4 5 6 8 bits 4 to 7", "BRLTTY, driver DotPad", Confidence::good},
    {"the line of text is destination 0, pins follow", "BRLTTY, driver DotPad", Confidence::good},
    {"60 by 40 pins, 2.5 mm apart, 20 cells of text; other models report their size in the board information (0110h)",
     "BRLTTY; dot pad's software kit", Confidence::medium},
    {"the display answers a row with 0201h (0 accepted, 1 refused, 2 wait, 3 wrong checksum), and with 0202h when its pins are "
     "set",
     "BRLTTY, driver DotPad", Confidence::good},
    {"0302h, 0312h, 0322h and 0332h report keys, with a bit for each key that is down", "BRLTTY, driver DotPad",
     Confidence::good},
};

// Numbers of commands.
constexpr int kAskBoard = 0x0110, kBoard = 0x0111, kShow = 0x0200, kShowAnswer = 0x0201, kShown = 0x0202, kFault = 0x9902;
constexpr int kScroll = 0x0302, kPerkins = 0x0312, kRouting = 0x0322, kFunction = 0x0332;  // keys that are down, a bit each
constexpr std::size_t kHead = 4, kLeast = 5,
                      kMost = 512;  // bytes before the destination; behind them, of a packet without data and of any

std::string packet(int destination, int command, std::string_view data) {
    const std::size_t length = kLeast + data.size();
    std::string bytes{'\xAA',
                      '\x55',
                      static_cast<char>(length >> 8),
                      static_cast<char>(length & 0xFF),
                      static_cast<char>(destination),
                      static_cast<char>(command >> 8),
                      static_cast<char>(command & 0xFF),
                      '\0'};
    bytes += data;
    std::uint8_t sum = 0xA5;
    for (std::size_t i = kHead; i < bytes.size(); ++i) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(bytes[i]));
    return bytes + static_cast<char>(sum);
}

int byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

struct Packet {
    int row = 0, command = 0;
    std::string data;
};

// The first whole packet, which is taken off with what stands before it.
std::optional<Packet> take_packet(std::string& heard) {
    for (std::size_t at = heard.find("\xAA\x55"); at != std::string::npos; at = heard.find("\xAA\x55", at + 1)) {
        if (heard.size() < at + kHead) break;
        const auto length = static_cast<std::size_t>(byte_at(heard, at + 2) * 256 + byte_at(heard, at + 3));
        if (length < kLeast || length > kMost) continue;
        const std::size_t end = at + kHead + length;
        if (end > heard.size()) break;
        std::uint8_t sum = 0xA5;
        for (std::size_t i = at + kHead; i + 1 < end; ++i) sum = static_cast<std::uint8_t>(sum ^ byte_at(heard, i));
        if (sum != byte_at(heard, end - 1)) continue;
        const Packet packet{byte_at(heard, at + 4), byte_at(heard, at + 5) * 256 + byte_at(heard, at + 6),
                            heard.substr(at + kHead + 4, length - kLeast)};
        heard.erase(0, end);
        return packet;
    }
    return std::nullopt;
}

// Dots 1 to 8 are bits 0 to 7 everywhere else.
char to_own_bits(std::uint8_t cell) {
    return static_cast<char>((cell & 0x07) | (cell & 0x40) >> 3 | (cell & 0x38) << 1 | (cell & 0x80));
}

DotSetting dot_pad_dots(const Settings& settings) {
    DotSetting set = display_pins(settings.number("pitch"), settings.whole("columns"), settings.whole("rows"));
    set.title_cells = settings.whole("text");
    return set;
}

std::string encode_pages_dot_pad(std::span<const Page> pages, const Settings& settings) {
    constexpr std::uint8_t kBits[4][2] = {{0x01, 0x10}, {0x02, 0x20}, {0x04, 0x40}, {0x08, 0x80}};
    const int columns = settings.whole("columns"), rows = settings.whole("rows"), text = settings.whole("text");
    std::string bytes;
    for (const Page& page : pages) {
        const Dots raised = raise_on_bed(page);
        for (int line = 0; line < (rows + 3) / 4; ++line) {
            std::string data(1 + static_cast<std::size_t>(columns + 1) / 2, '\0');
            for (int row = 4 * line; row < std::min({4 * line + 4, rows, raised.rows}); ++row)
                for (int column = 0; column < std::min(columns, raised.columns); ++column)
                    if (raised.at(column, row) != 0)
                        data[1 + static_cast<std::size_t>(column) / 2] |= static_cast<char>(kBits[row % 4][column % 2]);
            bytes += packet(settings.whole("first") + line, kShow, data);
        }
        if (text == 0) continue;
        const std::vector<std::uint8_t> title = page.title.empty() || page.braille_table.empty()
                                                    ? std::vector<std::uint8_t>()
                                                    : to_braille(page.title, page.braille_table);
        std::string data(1 + static_cast<std::size_t>(text), '\0');
        for (std::size_t i = 0; i < std::min(title.size(), data.size() - 1); ++i) data[1 + i] = to_own_bits(title[i]);
        bytes += packet(0, kShow, data);
    }
    return bytes;
}

// Features, dots of a cell (1: eight), tenths of a mm from pin to pin, function keys; then of the text and of the pins: lines,
// cells, two numbers of no use here. Features: 80h pins, 40h text.
PinAnswer::Kind learn(std::string_view board, Settings& settings) {
    if (board.size() < 12) return PinAnswer::Kind::other;
    if ((byte_at(board, 0) & 0x80) == 0) return PinAnswer::Kind::too_small;
    const bool text = (byte_at(board, 0) & 0x40) != 0;
    const int columns = 2 * byte_at(board, 9), rows = (byte_at(board, 1) == 1 ? 4 : 3) * byte_at(board, 8);
    const auto set = [&](std::string_view name, double value) {
        try {
            settings.set(name, to_text(value), "", "dot-pad");
        } catch (const Error&) {
            throw Error(Fault::failed, "dot-pad",
                        phrase("the display tells of {0} x {1} pins, which none has; switch it off and on again",
                               std::to_string(columns), std::to_string(rows)));
        }
    };
    set("columns", columns);
    set("rows", rows);
    if (byte_at(board, 2) > 0) set("pitch", byte_at(board, 2) / 10.0);
    set("text", text ? byte_at(board, 5) : 0);
    set("first", text ? byte_at(board, 4) : 1);
    return PinAnswer::Kind::told;
}

std::optional<PinAnswer> dot_pad_next(std::string& heard, Settings& settings) {
    const auto packet = take_packet(heard);
    if (!packet) return std::nullopt;
    const auto answer = [&](PinAnswer::Kind kind) { return PinAnswer{kind, packet->row}; };
    switch (packet->command) {
        case kBoard: return answer(learn(packet->data, settings));
        case kShown: return answer(PinAnswer::Kind::standing);
        case kFault: return answer(PinAnswer::Kind::refused);
        case kShowAnswer: {
            const int code = packet->data.empty() ? 0 : byte_at(packet->data, 0);  // 0 taken, 1 refused, 2 wait, 3 wrong sum
            return answer(code == 0 ? PinAnswer::Kind::taken : code == 1 ? PinAnswer::Kind::refused : PinAnswer::Kind::again);
        }
        case kScroll:
        case kPerkins:
        case kRouting:
        case kFunction:
            return answer(packet->data.find_first_not_of('\0') == std::string::npos ? PinAnswer::Kind::keys_up
                                                                                    : PinAnswer::Kind::keys_down);
        default: return answer(PinAnswer::Kind::other);
    }
}

std::size_t dot_pad_message(std::string_view bytes) {
    return bytes.size() < kHead
               ? bytes.size()
               : std::min(bytes.size(), kHead + static_cast<std::size_t>(byte_at(bytes, 2) * 256 + byte_at(bytes, 3)));
}

int row(std::string_view bytes) { return bytes.size() <= kHead ? -1 : byte_at(bytes, kHead); }

constexpr char kDotPadQuestion[] = {'\xAA',
                                    '\x55',
                                    0,
                                    5,
                                    0,
                                    kAskBoard >> 8,
                                    kAskBoard & 0xFF,
                                    0,
                                    static_cast<char>(0xA5 ^ (kAskBoard >> 8) ^ (kAskBoard & 0xFF))};

constexpr PinDisplay kDotPadDisplay{.question = {kDotPadQuestion, sizeof kDotPadQuestion},
                                    .farewell = {},
                                    .thanks = {},
                                    .next = dot_pad_next,
                                    .message = dot_pad_message,
                                    .row = row};

constexpr Embosser kDotPadEmbosser{
    .models = "Dot Pad 320, 832 and others that report their size",
    .called = "dot-pad-320 dot-pad-832",
    .punch = punch_dot_pad,
    .facts = kDotPadFacts,
    .display = &kDotPadDisplay,
};

}  // namespace

extern const Format dot_pad_format;
const Format dot_pad_format{
    .name = "dot-pad",
    .summary = "Dot Pad: 60 x 40 pins, and the title on its line of braille",
    .medium = "embosser",
    .paper = "a5",
    .options = kDotPadOptions,
    .encode_pages = encode_pages_dot_pad,
    .embosser = &kDotPadEmbosser,
    .dots = dot_pad_dots,
};

}  // namespace tactics
