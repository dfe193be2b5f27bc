// SPDX-License-Identifier: Apache-2.0
// Graphiti and Graphiti Plus of Orbit Research: pins that stand at one of several heights, over a serial line on USB (Space with
// dot 8 on its keypad sets it to that).
//
// A message is ESC, a command, data in which an ESC is sent twice, and a checksum: the two's complement of the sum of all bytes
// between.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "print/dots.h"
#include "print/embosser.h"
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/pin_display.h"

namespace tactics {

namespace {

constexpr int kColumns = 60, kRows = 40, kHighest = 4;
constexpr char kEscape = 0x1B, kUpdate = 0x15, kKeys = 0x31, kKey = 0x32, kAnswer = 0x53;

constexpr Option lower_pins(std::string_view name, std::string_view summary) {
    return {.name = name, .type = Option::Type::whole, .fallback = 0, .min = 0, .max = kHighest, .summary = summary};
}

constexpr Option kGraphitiOptions[] = {
    {.name = "height",
     .type = Option::Type::whole,
     .fallback = kHighest,
     .min = 1,
     .max = kHighest,
     .summary = "height of the pins of lines and braille; 4 is the highest"},
    lower_pins("pattern", "height of the pins of patterns; 0: by which kinds of lines there are"),
    lower_pins("inner", "height of the pins of lines inside things; 0: likewise"),
    lower_pins("axes", "height of the pins of axes, ticks, lead lines, scale bars and marks; 0: likewise"),
    lower_pins("grid", "height of the pins of grid lines; 0: likewise"),
    {.name = "pitch",
     .type = Option::Type::length,
     .fallback = 2.5,
     .min = 1,
     .max = 10,
     .unit = "mm",
     .summary = "distance from pin to pin; all pins are used, so this only scales what is given in mm"},
};

constexpr ProtocolFact kGraphitiFacts[] = {
    {"ESC, command, data with each ESC doubled, checksum; command 15h shows all pins, row by row from the top, each with a "
     "height of 0 to 4 and a blink rate",
     "Orbit Research, Graphiti API library", Confidence::good},
    {"it answers ESC 53h with 0 for done or 1 to 5 for faults (3: wrong checksum), and expects ESC 51h after each answer",
     "Orbit Research, Graphiti API library", Confidence::good},
    {"command 31h with 1 turns on key reports; ESC 31h acknowledges it, and ESC 32h reports the keys that are down",
     "Orbit Research, Graphiti API library", Confidence::good},
    {"60 by 40 pins", "Orbit Research, Graphiti API library", Confidence::good},
    {"a doubled ESC counts twice in the checksum", "Orbit Research, Graphiti API library", Confidence::medium},
    {"pins 2.5 mm apart (assumed; no source found)", "this project", Confidence::uncertain},
};

std::string twice_escaped(std::string_view data) {
    std::string bytes;
    for (const char c : data) bytes.append(c == kEscape ? 2 : 1, c);
    return bytes;
}

std::string message_of(std::string_view data) {
    std::uint8_t sum = 0;
    for (const char c : data) sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(c));
    return kEscape + std::string(data) + twice_escaped({std::string(1, static_cast<char>(-sum))});
}

DotSetting graphiti_dots(const Settings& settings) {
    DotSetting pins = display_pins(settings.number("pitch"), kColumns, kRows);
    const int full = settings.whole("height");
    pins.heights.levels = full + 1;
    for (std::size_t kind = 1; kind < kLineKinds; ++kind)
        pins.heights.wished[kind] = static_cast<double>(std::min(full, settings.whole(kKindSettings[kind]))) / full;
    return pins;
}

std::string encode_pages_graphiti(std::span<const Page> pages, const Settings& settings) {
    const int full = settings.whole("height");
    std::string bytes;
    for (const Page& page : pages) {
        const Dots kinds = kinds_on_bed(page);
        const auto height = [&](std::uint8_t dot) {
            return static_cast<char>(std::max(1L, std::lround(full * page.heights.share(kind_of_dot(dot)))));
        };
        std::string data(2 * kColumns * kRows, '\0');
        for (int row = 0; row < std::min(kRows, kinds.rows); ++row)
            for (int column = 0; column < std::min(kColumns, kinds.columns); ++column)
                if (const std::uint8_t dot = kinds.at(column, row); dot != 0)
                    data[2 * static_cast<std::size_t>(row * kColumns + column)] = height(dot);
        bytes += message_of(kUpdate + twice_escaped(data));
    }
    return bytes;
}

// Its messages have no length; those of encode are one for each page, all of one size, as no height is an ESC.
std::size_t graphiti_message(std::string_view bytes) {
    const std::size_t next = bytes.find(std::string{kEscape, kUpdate}, 1);
    return std::min(next, bytes.size());
}

// To tell of its keys: what answers that is one.
constexpr char kGraphitiQuestion[] = {kEscape, kKeys, 1, static_cast<char>(-(kKeys + 1))};
constexpr char kFarewell[] = {kEscape, kKeys, 0, static_cast<char>(-kKeys)};
constexpr char kThanks[] = {kEscape, 0x51, static_cast<char>(-0x51)};

// ESC, the kind, that many bytes, and the sum; every ESC after the first is doubled. Removed together with anything before it.
std::optional<std::string> take_answer(std::string& heard) {
    for (std::size_t at = heard.find(kEscape); at != std::string::npos; at = heard.find(kEscape, at + 1)) {
        if (at + 1 >= heard.size()) break;
        const char kind = heard[at + 1];
        const std::size_t count = kind == kKey ? 3 : kind == kKeys || kind == kAnswer ? 1 : 0;
        if (count == 0) continue;
        std::string bytes(1, kind);
        std::uint8_t sum = static_cast<std::uint8_t>(kind);
        std::size_t end = at + 2;
        while (bytes.size() < count + 2 && end < heard.size()) {
            const char c = heard[end++];
            if (c == kEscape && end == heard.size()) return std::nullopt;  // its second is to come
            if (c == kEscape && heard[end++] != kEscape) break;
            // What is sent twice counts twice, but for the sum itself.
            sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(c) * (c == kEscape && bytes.size() <= count ? 2 : 1));
            bytes += c;
        }
        if (bytes.size() < count + 2 && end >= heard.size()) return std::nullopt;
        if (bytes.size() < count + 2 || sum != 0) continue;
        heard.erase(0, end);
        return bytes;
    }
    return std::nullopt;
}

std::optional<PinAnswer> graphiti_next(std::string& heard, Settings&) {
    const auto answer = take_answer(heard);
    if (!answer) return std::nullopt;
    const std::string& bytes = *answer;
    if (bytes[0] == kKeys) return PinAnswer{PinAnswer::Kind::told};
    if (bytes[0] == kAnswer)
        return PinAnswer{bytes[1] == 0   ? PinAnswer::Kind::standing
                         : bytes[1] == 3 ? PinAnswer::Kind::again
                                         : PinAnswer::Kind::refused};
    return PinAnswer{bytes[1] == 0 && bytes[2] == 0 ? PinAnswer::Kind::keys_up : PinAnswer::Kind::keys_down};
}

constexpr PinDisplay kGraphitiDisplay{.question = {kGraphitiQuestion, sizeof kGraphitiQuestion},
                                      .farewell = {kFarewell, sizeof kFarewell},
                                      .thanks = {kThanks, sizeof kThanks},
                                      .next = graphiti_next,
                                      .message = graphiti_message,
                                      .row = [](std::string_view) { return -1; }};

constexpr Embosser kGraphitiEmbosser{
    .models = "Graphiti, Graphiti Plus",
    .called = "graphiti-plus",
    .punch = punch_graphiti,
    .facts = kGraphitiFacts,
    .display = &kGraphitiDisplay,
};

}  // namespace

extern const Format graphiti_format;
const Format graphiti_format{
    .name = "graphiti",
    .summary = "Graphiti: 60 x 40 pins, lines high, axes, grids and patterns lower",
    .medium = "embosser",
    .paper = "a5",
    .options = kGraphitiOptions,
    .encode_pages = encode_pages_graphiti,
    .embosser = &kGraphitiEmbosser,
    .dots = graphiti_dots,
};

}  // namespace tactics
