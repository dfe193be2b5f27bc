// SPDX-License-Identifier: Apache-2.0
// `tactics help mouse`: for people who build a haptic mouse, or describe one for --lever.
#include <algorithm>
#include <cstdio>

#include "cli/help/topics.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/devices/mouse_report.h"
#include "tactics/haptics/simulated/lever_file.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string in_hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02X", byte);
        text += (text.empty() ? "" : " ") + std::string(digits);
    }
    return text;
}

std::string range_of(std::size_t first, std::size_t last) {
    return first == last ? "byte " + std::to_string(first) : "bytes " + std::to_string(first) + " to " + std::to_string(last);
}

std::string mouse_layout(std::span<const ReportField> fields) {
    std::string text;
    for (const ReportField& field : fields)
        text += "  " + range_of(field.first, field.last) + ": " + std::string(field.what) + "\n";
    return text;
}

// HID 1.11, 6.2.2: the kind of an item by its first byte, whose two lowest bits give its length.
std::string_view name_of_item(std::uint8_t first) {
    switch (first & 0xFC) {
        case 0x04: return "usage page";
        case 0x08: return "usage";
        case 0x14: return "logical minimum";
        case 0x24: return "logical maximum";
        case 0x74: return "report size, bits";
        case 0x80: return "input";
        case 0x90: return "output";
        case 0x94: return "report count";
        case 0xA0: return "collection";
        case 0xC0: return "end of the collection";
        default: return "another item";
    }
}

std::string descriptor() {
    std::string text;
    for (std::span<const std::uint8_t> rest(kMouseDescriptor); !rest.empty();) {
        const std::size_t size = std::min<std::size_t>(rest.size(), 1 + ((rest[0] & 3) == 3 ? 4 : rest[0] & 3));
        text += "  " + in_hexadecimal(rest.first(size)) + ": " + std::string(name_of_item(rest[0])) + "\n";
        rest = rest.subspan(size);
    }
    return text;
}

// Too long for one line; in udev rules a backslash continues the line.
std::string rule() {
    std::string text = udev_rule("0003:00001209:00000005");
    const auto second = text.find("ATTRS{idProduct}");
    if (second != std::string::npos) text.insert(second, "\\\n    ");
    return "  " + text + "\n";
}

template <typename Presets>
std::string names_of(const Presets& presets) {
    std::string text;
    for (std::size_t i = 0; i < presets.size(); ++i)
        text += (i == 0 ? "" : i + 1 < presets.size() ? ", " : " or ") + std::string(presets[i].name);
    return text;
}

std::string indented(const std::string& lines) {
    std::string text = "  ";
    for (std::size_t i = 0; i < lines.size(); ++i) {
        text += lines[i];
        if (lines[i] == '\n' && i + 1 < lines.size()) text += "  ";
    }
    return text;
}

const std::string& hold() {
    static const std::string time = std::to_string(kForceHold) + " ms";
    return time;
}

std::string reports_text() {
    const ReportBytes example = bytes_of(ForceReport{true, 1, 1.5, kForceHold});
    const std::span<const std::uint8_t> bytes(example);
    return "Anyone can build a haptic mouse. A thousand times a second it sends one report\n"
           "and receives another, of 64 bytes each. Numbers of several bytes begin with the\n"
           "lowest byte; numbers ending in h are hexadecimal.\n\n"
           "On USB it is a full-speed HID device with one interrupt endpoint each way,\n"
           "64 bytes, interval 1. Reports have no ids. tactics recognises the mouse by its\n"
           "report descriptor; its vendor and product numbers do not matter.\n\n"
           "Report to the computer, one every millisecond, whatever the computer sends:\n" +
           mouse_layout(kMouseFields) +
           "All sensor counts are of that kind. x points to the right and y towards the\n"
           "hand, as on maps.\n\n"
           "Report from the computer:\n" +
           mouse_layout(kForceFields) + "For example a force of 1.5 N for " + hold() + ":\n" + "  " + range_of(0, 7) + ": " +
           in_hexadecimal(bytes.first(8)) + "\n" + "  " + range_of(8, 61) + ": 00\n" + "  " + range_of(62, 63) + ": " +
           in_hexadecimal(bytes.last(2)) + "\n" +
           "\n"
           "CRC-16: polynomial 1021h, initial value FFFFh, no reflection, no final XOR\n"
           "(CRC-16/CCITT-FALSE; the text 123456789 gives 29B1h).\n\n";
}

std::string duties_text() {
    return "What the mouse must do by itself:\n"
           "  It ignores reports that are short, of another kind or version, or whose CRC\n"
           "  is wrong.\n"
           "  A force holds for the time in its report, of which tactics play gives " +
           hold() +
           ".\n"
           "  When that time has passed without a good report, it takes its force to zero\n"
           "  within 2 ms and reports a fault, until the next good report.\n"
           "  It gives no force while the motor is off or too hot.\n"
           "What tactics play does:\n"
           "  It sends no force before the first good report, and none after 3 ms without\n"
           "  one or while the mouse reports a fault; after that it begins softly. The stop\n"
           "  key ends the play. At the end it switches the motor off.\n"
           "\n"
           "The report descriptor, " +
           std::to_string(kMouseDescriptor.size()) + " bytes in hexadecimal, one item per line:\n" + descriptor() + "\n";
}

std::string permission_text() {
    return "To get permission to use it, write a udev rule with its vendor and product\n"
           "numbers (tactics devices prints yours; here 1209 and 0005) into\n"
           "/etc/udev/rules.d/70-tactics-mouse.rules, and plug it in again:\n" +
           rule() +
           "Until it is unplugged, this command also gives permission:\n"
           "  sudo setfacl -m u:$USER:rw /dev/hidraw0\n\n";
}

std::string lever_file_text() {
    return "The file for tactics play --lever FILE describes the machine, the finger on it\n"
           "and its sensors. Each line is NAME = VALUE UNIT; # begins a comment. Settings\n"
           "that are not named keep their defaults. These two choose a preset; put them\n"
           "first:\n"
           "  lever = " +
           names_of(kLevers) + "\n  finger = " + names_of(kFingers) +
           "\n"
           "finger = none is a simulated lever that nobody touches.\n"
           "All others with their defaults; after # come the range and the meaning:\n" +
           indented(to_text(MouseSettings{})) +
           "A real mouse sends counts; lever.encoder and the sensors' numbers turn them into\n"
           "mm. With a real mouse a lever.delay of 0 counts as " +
           to_text(kHidDelay) +
           " s.\n"
           "Example: tactics play relief.png --device hid: --lever mouse.txt\n";
}

std::string mouse_text() { return reports_text() + duties_text() + permission_text() + lever_file_text(); }

}  // namespace

extern const Topic mouse_topic;
const Topic mouse_topic{"mouse", "how to build a haptic mouse, and the file for play --lever", mouse_text};

}  // namespace tactics
