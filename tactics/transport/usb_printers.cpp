// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/usb_printers.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/transport/kernel_lists.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHex = "0123456789abcdefABCDEF", kDigits = "0123456789";

// "1-2", "1-2.3.4"
bool is_place(std::string_view text) {
    const auto dash = text.find('-');
    if (dash == std::string_view::npos || dash == 0 || text.substr(0, dash).find_first_not_of(kDigits) != std::string_view::npos)
        return false;
    for (text.remove_prefix(dash + 1);;) {
        const auto dot = text.find('.');
        const auto port = text.substr(0, dot);
        if (port.empty() || port.find_first_not_of(kDigits) != std::string_view::npos) return false;
        if (dot == std::string_view::npos) return true;
        text.remove_prefix(dot + 1);
    }
}

bool are_numbers(std::string_view text) {
    return text.size() >= 9 && text[4] == ':' && (text.size() == 9 || (text[9] == ':' && text.size() > 10)) &&
           text.substr(0, 4).find_first_not_of(kHex) == std::string_view::npos &&
           text.substr(5, 4).find_first_not_of(kHex) == std::string_view::npos;
}

std::string in_small(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

bool is_meant(const UsbPrinter& printer, std::string_view choice) {
    if (choice.empty()) return true;
    if (is_place(choice)) return printer.place == choice;
    return in_small(choice.substr(0, 9)) == printer.vendor + ":" + printer.product &&
           (choice.size() == 9 || choice.substr(10) == printer.serial);
}

}  // namespace

std::string UsbPrinter::node() const {
    char text[64];
    std::snprintf(text, sizeof text, "/dev/bus/usb/%03d/%03d", bus, number);
    return text;
}

std::vector<UsbPrinter> usb_printers(const std::string& root) {
    std::vector<UsbPrinter> printers;
    for (const fs::path& entry : entries_of(root + "/sys/bus/usb/devices")) {
        // Protocol 4 is IPP over USB, which takes no raw bytes.
        if (line_of(entry / "bInterfaceClass") != "07" || line_of(entry / "bInterfaceProtocol") == "04") continue;
        std::error_code fault;
        const fs::path interface = fs::canonical(entry, fault), device = interface.parent_path();
        if (fault) continue;
        UsbPrinter printer;
        printer.place = device.filename().string();
        if (!printers.empty() && printers.back().place == printer.place) continue;
        printer.vendor = line_of(device / "idVendor");
        printer.product = line_of(device / "idProduct");
        printer.serial = line_of(device / "serial");
        printer.name = product_of(device);
        printer.bus = std::atoi(line_of(device / "busnum").c_str());
        printer.number = std::atoi(line_of(device / "devnum").c_str());
        const fs::path driver = fs::read_symlink(interface / "driver", fault);
        if (!fault) printer.driver = driver.filename().string();
        for (const fs::path& driven : entries_of(interface / "usbmisc")) printer.path = "/dev/usb/" + driven.filename().string();
        printers.push_back(printer);
    }
    return printers;
}

bool is_usb_choice(std::string_view choice) { return choice.empty() || is_place(choice) || are_numbers(choice); }

UsbPrinter usb_printer(const std::string& choice, const std::string& root) {
    const std::string place = choice.empty() ? "usb" : "usb:" + choice;  // a colon follows
    std::vector<UsbPrinter> meant = usb_printers(root);
    meant.erase(std::remove_if(meant.begin(), meant.end(), [&](const UsbPrinter& printer) { return !is_meant(printer, choice); }),
                meant.end());
    if (meant.empty())
        throw Error(Fault::failed, place,
                    phrase("there is no such printer on USB; plug it in and switch it on; see tactics devices"));
    if (meant.size() == 1) return meant.front();
    std::string all;
    for (const UsbPrinter& printer : meant)
        all += (all.empty() ? "" : ", ") + ("usb:" + printer.place) + (printer.name.empty() ? "" : " (" + printer.name + ")");
    throw Error(Fault::failed, place, phrase("several printers could be meant: {0}; name one of them", all));
}

}  // namespace tactics
