// Graphiti and Graphiti Plus of Orbit Research: pins that stand at one of several heights, over a serial line on USB (Space with dot 8
// on its keypad sets it to that).
//
// A message is ESC, a command, data in which an ESC is sent twice, and a checksum: the two's complement of the sum of all bytes between.
#include <algorithm>
#include <cstdint>

#include "print/dots.h"
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/pin_display.h"

namespace tactics {

namespace {

constexpr int kColumns = 60, kRows = 40;
constexpr char kEscape = 0x1B, kUpdate = 0x15, kKeys = 0x31, kKey = 0x32, kAnswer = 0x53;

constexpr Option kOptions[] = {
    {.name = "height", .type = Option::Type::whole, .fallback = 4, .min = 1, .max = 4, .unit = "", .summary = "of the pins of lines and braille, 4 the highest",
     .choices = ""},
    {.name = "pattern", .type = Option::Type::whole, .fallback = 2, .min = 1, .max = 4, .unit = "", .summary = "height of the pins of patterns", .choices = ""},
    {.name = "pitch", .type = Option::Type::length, .fallback = 2.5, .min = 1, .max = 10, .unit = "mm",
     .summary = "from pin to pin; it says only how large words of mm are, as all pins are used", .choices = ""},
};

constexpr ProtocolFact kFacts[] = {
    {"ESC, command, data with ESC twice, checksum; command 15h shows all pins, row by row from the top, a height of 0 to 4 and a rate of blinking each",
     "Orbit Research, Graphiti API library", Confidence::good},
    {"it answers ESC 53h with 0: done; 1 to 5: faults; and waits for nothing more", "Orbit Research, Graphiti API library", Confidence::medium},
    {"command 31h with 1: tell of keys, which ESC 31h answers and ESC 32h does", "Orbit Research, Graphiti API library", Confidence::good},
    {"its answers need no acknowledgement", "this project", Confidence::uncertain},
    {"60 by 40 pins", "Orbit Research, Graphiti API library", Confidence::good},
    {"an ESC that is sent twice counts twice in the checksum", "Orbit Research, Graphiti API library", Confidence::medium},
    {"pins 2.5 mm apart, for want of a source", "this project", Confidence::uncertain},
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

DotSetting dots(const Settings& settings) {
    const double pitch = settings.number("pitch");
    return {{pitch, 3 * pitch, 4 * pitch, 1.6}, {{pitch / 2, pitch / 2}, pitch, 3}, pitch * kColumns, pitch * kRows};
}

std::string encode_pages(std::span<const Page> pages, const Settings& settings) {
    std::string bytes;
    for (const Page& page : pages) {
        Page lines = page;
        std::erase_if(lines.strokes, [](const PageStroke& stroke) { return stroke.role == Role::pattern; });
        const Dots all = raise_on_bed(page), high = raise_on_bed(lines);
        std::string data(2 * kColumns * kRows, '\0');
        for (int row = 0; row < std::min(kRows, all.rows); ++row)
            for (int column = 0; column < std::min(kColumns, all.columns); ++column)
                if (all.at(column, row) != 0)
                    data[2 * static_cast<std::size_t>(row * kColumns + column)] = static_cast<char>(settings.whole(high.at(column, row) != 0 ? "height" : "pattern"));
        bytes += message_of(kUpdate + twice_escaped(data));
    }
    return bytes;
}

// Its messages have no length; those of encode are one for each page, all of one size, as no height is an ESC.
std::size_t message(std::string_view bytes) {
    const std::size_t next = bytes.find(std::string{kEscape, kUpdate}, 1);
    return std::min(next, bytes.size());
}

// To tell of its keys: what answers that is one.
constexpr char kQuestion[] = {kEscape, kKeys, 1, static_cast<char>(-(kKeys + 1))};

bool learn(std::string_view heard, Settings&) { return heard.find(std::string{kEscape, kKeys}) != std::string_view::npos; }

PinDisplay::Reply reply(std::string_view heard) {
    const std::size_t at = heard.find(std::string{kEscape, kAnswer});
    if (at != std::string_view::npos && at + 2 < heard.size()) return heard[at + 2] == 0 ? PinDisplay::Reply::taken : PinDisplay::Reply::refused;
    return heard.find(std::string{kEscape, kKey}) != std::string_view::npos ? PinDisplay::Reply::key : PinDisplay::Reply::none;
}

constexpr PinDisplay kDisplay{.baud = 115200, .question = {kQuestion, sizeof kQuestion}, .learn = learn, .message = message, .reply = reply};

constexpr Embosser kEmbosser{
    .models = "Graphiti, Graphiti Plus",
    .punch = punch_graphiti,
    .facts = kFacts,
    .display = &kDisplay,
};

}  // namespace

extern const Format graphiti_format;
const Format graphiti_format{
    .name = "graphiti",
    .summary = "Graphiti: 60 x 40 pins, lines high and patterns lower",
    .extensions = "",
    .medium = "embosser",
    .paper = "a5",
    .options = kOptions,
    .encode_pages = encode_pages,
    .embosser = &kEmbosser,
    .dots = dots,
};

}  // namespace tactics
