// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/devices.h"

#include <unistd.h>

#include <algorithm>

#include "tactics/text/utf8.h"
#include "tactics/transport/child.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/transport/kernel_lists.h"
#include "tactics/transport/usb_printers.h"

namespace tactics {

namespace fs = std::filesystem;

std::string printer_id(const std::string& path, const std::string& root) {
    const std::string name = fs::path(path).filename().string();
    return line_of(root + "/sys/class/usbmisc/" + name + "/device/ieee1284_id");
}

std::vector<AttachedDevice> attached_devices(const std::string& root) {
    std::vector<AttachedDevice> devices;
    for (const fs::path& entry : entries_of(root + "/sys/class/usbmisc")) {
        const std::string name = entry.filename().string();
        if (!name.starts_with("lp")) continue;
        const std::string path = "/dev/usb/" + name;
        std::string id = printer_id(path, root);
        if (id.empty()) id = product_of(entry / "device");
        devices.push_back({path, id, note_for(root, path, "lp")});
    }
    // Printers that no driver of the kernel has: usblp is not loaded, or a program (usbfs) talks to them.
    for (const UsbPrinter& printer : usb_printers(root)) {
        if (!printer.driver.empty() && printer.driver != "usbfs") continue;
        Phrase note = note_for(root, printer.node(), "lp");
        if (note.empty() && !printer.driver.empty()) note = phrase("another program has it, perhaps CUPS: use its print queue");
        devices.push_back({"usb:" + printer.place, printer.name,
                           note.empty() ? phrase("the kernel has no driver for it, it is used directly") : note});
    }
    for (const fs::path& entry : entries_of(root + "/sys/class/tty")) {
        const std::string name = entry.filename().string();
        if (!name.starts_with("ttyUSB") && !name.starts_with("ttyACM")) continue;
        devices.push_back({"/dev/" + name, product_of(entry / "device"), note_for(root, "/dev/" + name, "dialout")});
    }
    for (const HidDisplay& display : hid_displays(root)) {
        const BrailleReports& reports = display.reports;
        Phrase note =
            phrase("braille display of {0} x {1} cells", std::to_string(reports.columns), std::to_string(reports.lines.size()));
        if (const Phrase missing = note_if_missing(root, display.path); !missing.empty())
            note = phrase("{0}; {1}", std::move(note), missing);
        else if (access((root + display.path).c_str(), R_OK | W_OK) != 0)
            note = phrase("{0}; {1}", std::move(note), how_to_be_permitted(display));
        devices.push_back({"hid:" + display.path, display.name, note});
    }
    return devices;
}

std::vector<AttachedDevice> queues_told(std::string_view lpstat) {
    std::vector<AttachedDevice> queues;
    while (!lpstat.empty()) {
        const std::string_view line = lpstat.substr(0, lpstat.find('\n'));
        lpstat.remove_prefix(std::min(lpstat.size(), line.size() + 1));
        constexpr std::string_view kStart = "device for ";
        const auto colon = line.find(": ");
        if (!line.starts_with(kStart) || colon == std::string_view::npos) continue;
        queues.push_back(
            {"queue:" + to_line(line.substr(kStart.size(), colon - kStart.size())), to_line(line.substr(colon + 2)), ""});
    }
    return queues;
}

std::vector<AttachedDevice> print_queues() {
    const ChildAnswer answer = run_child({"lpstat", "-v"}, "", {std::chrono::milliseconds{5'000}, 1u << 20}, {"LC_ALL=C"});
    return answer.end == ChildAnswer::End::done ? queues_told(answer.out) : std::vector<AttachedDevice>();
}

}  // namespace tactics
