// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "tactics/error.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/usb_printers.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Of a device or a link to one, what it is in /dev; empty: it is none.
std::string device_of(const std::string& path) {
    std::error_code fault;
    const std::string real = std::filesystem::weakly_canonical(path, fault).string();
    return !fault && real.starts_with("/dev/") ? real : "";
}

// "9600", "9600,xonxoff"
void take_line(Address& address, std::string_view text, const std::string& place) {
    const auto comma = text.find(',');
    const auto baud = parse_number(text.substr(0, comma));
    const std::string_view flow = comma == std::string_view::npos ? "rtscts" : text.substr(comma + 1);
    if (!baud || *baud < 1 || *baud > 1e6 || (flow != "rtscts" && flow != "xonxoff" && flow != "none"))
        throw Error(
            Fault::usage, place,
            "the speed is a number, and how the machine stops the line rtscts, xonxoff or none: /dev/ttyUSB0@9600,xonxoff");
    address.baud = static_cast<int>(*baud);
    address.flow = flow == "rtscts" ? Flow::rtscts : flow == "xonxoff" ? Flow::xonxoff : Flow::none;
}

}  // namespace

Address parse_address(const std::string& text, const std::string& place) {
    Address address;
    const auto at = text.find('@');
    const std::string device = device_of(text.substr(0, at));
    const auto named = [&](std::string_view start) { return std::string_view(text).starts_with(start); };
    if (text.empty() || text == "queue:" || text == "tcp:")
        throw Error(Fault::usage, place,
                    "say where to: queue:NAME, tcp:HOST, /dev/usb/lp0, usb:, /dev/ttyUSB0@9600, or a file; see tactics devices");
    if (named("queue:")) {
        address.kind = Address::Kind::queue;
        address.name = text.substr(6);
        // lp would take it for an option.
        if (address.name[0] == '-')
            throw Error(Fault::usage, place, "no queue has a name that begins with -; see tactics devices");
    } else if (named("tcp:")) {
        address.kind = Address::Kind::tcp;
        address.name = text.substr(4);
        // [::1]:9100, ::1, host, host:9100
        if (address.name[0] == '[') {
            const auto end = address.name.find(']');
            if (end == std::string::npos) throw Error(Fault::usage, place, "the ] of the address is missing");
            if (address.name.size() > end + 2 && address.name[end + 1] == ':') address.port = address.name.substr(end + 2);
            address.name = address.name.substr(1, end - 1);
        } else if (const auto colon = address.name.find(':');
                   colon != std::string::npos && address.name.find(':', colon + 1) == std::string::npos) {
            address.port = address.name.substr(colon + 1);
            address.name.resize(colon);
        }
        const auto number = parse_number(address.port);
        if (!number || *number < 1 || *number > 65535 || address.port.find_first_not_of("0123456789") != std::string::npos)
            throw Error(Fault::usage, place, "a port is a number from 1 to 65535");
        if (address.name.empty()) throw Error(Fault::usage, place, "the name of the machine is missing: tcp:HOST");
    } else if (named("usb:")) {
        address.kind = Address::Kind::usb;
        address.name = text.substr(4);
        if (!is_usb_choice(address.name))
            throw Error(Fault::usage, place,
                        "a printer on USB is usb: if it is the only one, usb:VID:PID or usb:VID:PID:SERIAL (hexadecimal), or "
                        "usb:BUS-PORT such as usb:1-2.3; see tactics devices");
    } else if (!device.empty()) {
        address.name = text.substr(0, at);
        const std::string_view path = device;
        if (path.starts_with("/dev/usb/lp") && at == std::string::npos) {
            address.kind = Address::Kind::usblp;
        } else if (path.starts_with("/dev/tty") || path.starts_with("/dev/pts/")) {
            address.kind = Address::Kind::serial;
            if (at != std::string::npos) take_line(address, std::string_view(text).substr(at + 1), place);
        } else {
            throw Error(Fault::usage, place,
                        address.name +
                            " is no printer on USB (/dev/usb/lp0) and no serial line (/dev/ttyUSB0@9600); see tactics devices");
        }
    } else if (const auto colon = text.find(':'); colon != std::string::npos && text.find('/') > colon) {
        throw Error(Fault::usage, place,
                    "\"" + text.substr(0, colon) +
                        ":\" is no way to an embosser; there are queue:NAME, tcp:HOST and usb:; see tactics devices");
    } else if (text != "-" && text.find_first_of("./") == std::string::npos) {
        throw Error(Fault::usage, place, "say queue:" + text + " if that is a print queue, or ./" + text + " if it is a file");
    } else {
        address.name = text;
    }
    return address;
}

}  // namespace tactics
