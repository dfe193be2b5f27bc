// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/hid_displays.h"

#include <algorithm>
#include <fstream>

#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/hid_reports.h"
#include "tactics/transport/kernel_lists.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::streamsize kMostBytes = 4096;  // HID_MAX_DESCRIPTOR_SIZE of the kernel

std::vector<std::uint8_t> descriptor_of(const fs::path& device) {
    std::vector<std::uint8_t> bytes(kMostBytes);
    std::ifstream file(device / "report_descriptor", std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), kMostBytes);
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return bytes;
}

std::string property_of(const fs::path& device, const std::string& name) {
    std::ifstream file(device / "uevent");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name + "=")) return to_line(std::string_view(line).substr(name.size() + 1));
    return "";
}

constexpr std::string_view kHexDigits = "0123456789abcdefABCDEF";

// Of eight digits those that number a vendor or a product; empty: it is none.
std::string four_digits(std::string_view part) {
    return part.size() == 8 && part.find_first_not_of(kHexDigits) == std::string_view::npos ? std::string(part.substr(4)) : "";
}

std::string in_small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

// The device's distinguishing attributes; empty: the kernel does not give any. Only on USB does its parent device have these
// attributes; on Bluetooth its own name has the numbers.
std::string udev_match(std::string_view id) {
    if (id.size() != 22 || id[4] != ':' || id[13] != ':') return "";
    const std::string vendor = four_digits(id.substr(5, 8)), product = four_digits(id.substr(14));
    if (vendor.empty() || product.empty() || id.substr(0, 4).find_first_not_of(kHexDigits) != std::string_view::npos) return "";
    if (id.starts_with("0003:"))
        return "ATTRS{idVendor}==\"" + in_small_letters(vendor) + "\", ATTRS{idProduct}==\"" + in_small_letters(product) + "\"";
    return "KERNELS==\"" + std::string(id.substr(0, 5)) + vendor + ":" + product + ".*\"";
}

Phrase permission_for(const std::string& path, const std::string& kernel_id, const std::string& file) {
    const std::string rule = udev_rule(kernel_id);
    if (rule.empty())
        return phrase(
            "you are not permitted to use it; sudo setfacl -m u:$USER:rw {0} permits it until it is unplugged; for good "
            "write a udev rule for it with TAG+=\"uaccess\" in /etc/udev/rules.d/{1}, and plug it in again",
            path, file);
    return phrase(
        "you are not permitted to use it; sudo setfacl -m u:$USER:rw {0} permits it until it is unplugged; for good "
        "write this line into /etc/udev/rules.d/{1}: {2}, and plug it in again",
        path, file, rule);
}

}  // namespace

std::vector<HidDisplay> hid_displays(const std::string& root) {
    std::vector<HidDisplay> displays;
    for (const fs::path& entry : entries_of(root + "/sys/class/hidraw")) {
        const fs::path device = entry / "device";
        BrailleReports reports = braille_reports(descriptor_of(device));
        if (reports.lines.empty()) continue;
        displays.push_back({"/dev/" + entry.filename().string(), property_of(device, "HID_NAME"), std::move(reports),
                            property_of(device, "HID_ID")});
    }
    return displays;
}

std::vector<std::string> hid_paths(std::uint16_t page, std::uint8_t usage, const std::string& root) {
    // Usage page of two bytes, usage of one: how a report descriptor for a device of a maker's own begins (HID 1.11, 6.2.2).
    const std::vector<std::uint8_t> begin{0x06, static_cast<std::uint8_t>(page & 0xFF), static_cast<std::uint8_t>(page >> 8),
                                          0x09, usage};
    std::vector<std::string> paths;
    for (const fs::path& entry : entries_of(root + "/sys/class/hidraw")) {
        const std::vector<std::uint8_t> descriptor = descriptor_of(entry / "device");
        if (descriptor.size() >= begin.size() && std::equal(begin.begin(), begin.end(), descriptor.begin()))
            paths.push_back("/dev/" + entry.filename().string());
    }
    return paths;
}

std::string hid_name(const std::string& path, const std::string& root) {
    return property_of(fs::path(root + "/sys/class/hidraw") / fs::path(path).filename() / "device", "HID_NAME");
}

HidDisplay hid_display(const std::string& path, const std::string& root) {
    const std::vector<HidDisplay> displays = hid_displays(root);
    const std::string place = path.empty() ? "hid" : path;
    if (!path.empty()) {
        std::error_code fault;
        const std::string name = fs::weakly_canonical(path, fault).filename().string();
        for (const HidDisplay& display : displays)
            if (display.path == "/dev/" + name) return display;
    }
    if (displays.empty() || !path.empty())
        throw Error(Fault::failed, place,
                    phrase("there is no braille display of the HID standard; plug it in, switch it on and choose HID in its "
                           "menu; see tactics devices"));
    if (displays.size() == 1) return displays.front();
    std::string all;
    for (const HidDisplay& display : displays)
        all += (all.empty() ? "" : ", ") + display.path + (display.name.empty() ? "" : " (" + display.name + ")");
    throw Error(Fault::failed, place, phrase("several braille displays are there: {0}; name one of them", all));
}

std::string udev_rule(std::string_view kernel_id) {
    const std::string match = udev_match(kernel_id);
    return match.empty() ? "" : "KERNEL==\"hidraw*\", " + match + ", TAG+=\"uaccess\"";
}

Phrase how_to_be_permitted(const HidDisplay& display) {
    return permission_for(display.path, display.kernel_id, "70-tactics-display.rules");
}

Phrase how_to_be_permitted(const std::string& path, const std::string& root) {
    const fs::path device = fs::path(root + "/sys/class/hidraw") / fs::path(path).filename() / "device";
    return permission_for(path, property_of(device, "HID_ID"), "70-tactics-mouse.rules");
}

}  // namespace tactics
