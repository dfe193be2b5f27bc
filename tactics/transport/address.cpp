// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "tactics/error.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/usb_printers.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// The name in /dev of a device or a link to one; empty: no device.
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
            phrase(
                "the speed is a number, and how the machine stops the line rtscts, xonxoff or none: /dev/ttyUSB0@9600,xonxoff"));
    address.baud = static_cast<int>(*baud);
    address.flow = flow == "rtscts" ? Flow::rtscts : flow == "xonxoff" ? Flow::xonxoff : Flow::none;
}

// What stands behind "queue:"
Address queue_address(const std::string& name, const std::string& place) {
    // lp would take it for an option.
    if (name[0] == '-') throw Error(Fault::usage, place, phrase("no queue has a name that begins with -; see tactics devices"));
    Address address;
    address.kind = Address::Kind::queue;
    address.name = name;
    return address;
}

// Behind "tcp:": [::1]:9100, ::1, host, host:9100
Address tcp_address(const std::string& host, const std::string& place) {
    Address address;
    address.kind = Address::Kind::tcp;
    address.name = host;
    if (host[0] == '[') {
        const auto end = host.find(']');
        if (end == std::string::npos) throw Error(Fault::usage, place, phrase("the ] of the address is missing"));
        if (host.size() > end + 2 && host[end + 1] == ':') address.port = host.substr(end + 2);
        address.name = host.substr(1, end - 1);
    } else if (const auto colon = host.find(':'); colon != std::string::npos && host.find(':', colon + 1) == std::string::npos) {
        address.port = host.substr(colon + 1);
        address.name.resize(colon);
    }
    const auto number = parse_number(address.port);
    if (!number || *number < 1 || *number > 65535 || address.port.find_first_not_of("0123456789") != std::string::npos)
        throw Error(Fault::usage, place, phrase("a port is a number from 1 to 65535"));
    if (address.name.empty()) throw Error(Fault::usage, place, phrase("the name of the machine is missing: tcp:HOST"));
    return address;
}

// Behind "usb:"
Address usb_address(const std::string& choice, const std::string& place) {
    if (!is_usb_choice(choice))
        throw Error(Fault::usage, place,
                    phrase("a printer on USB is usb: if it is the only one, usb:VID:PID or usb:VID:PID:SERIAL (hexadecimal), or "
                           "usb:BUS-PORT such as usb:1-2.3; see tactics devices"));
    Address address;
    address.kind = Address::Kind::usb;
    address.name = choice;
    return address;
}

// /dev/usb/lp0, /dev/ttyUSB0@9600, or links to such; `device` is what they are in /dev.
Address device_address(const std::string& text, std::string_view device, const std::string& place) {
    const auto at = text.find('@');
    Address address;
    address.name = text.substr(0, at);
    if (device.starts_with("/dev/usb/lp") && at == std::string::npos) {
        address.kind = Address::Kind::usblp;
    } else if (device.starts_with("/dev/tty") || device.starts_with("/dev/pts/")) {
        address.kind = Address::Kind::serial;
        if (at != std::string::npos) take_line(address, std::string_view(text).substr(at + 1), place);
    } else {
        throw Error(Fault::usage, place,
                    phrase("{0} is no printer on USB (/dev/usb/lp0) and no serial line (/dev/ttyUSB0@9600); see tactics devices",
                           address.name));
    }
    return address;
}

Address file_address(const std::string& text, const std::string& place) {
    if (const auto colon = text.find(':'); colon != std::string::npos && text.find('/') > colon)
        throw Error(Fault::usage, place,
                    phrase("\"{0}:\" is no way to an embosser; there are queue:NAME, tcp:HOST and usb:; see tactics devices",
                           text.substr(0, colon)));
    if (text != "-" && text.find_first_of("./") == std::string::npos)
        throw Error(Fault::usage, place, phrase("say queue:{0} if that is a print queue, or ./{0} if it is a file", text));
    Address address;
    address.name = text;
    return address;
}

}  // namespace

Address parse_address(const std::string& text, const std::string& place) {
    if (text.empty() || text == "queue:" || text == "tcp:")
        throw Error(
            Fault::usage, place,
            phrase("say where to: queue:NAME, tcp:HOST, /dev/usb/lp0, usb:, /dev/ttyUSB0@9600, or a file; see tactics devices"));
    if (text.starts_with("queue:")) return queue_address(text.substr(6), place);
    if (text.starts_with("tcp:")) return tcp_address(text.substr(4), place);
    if (text.starts_with("usb:")) return usb_address(text.substr(4), place);
    const std::string device = device_of(text.substr(0, text.find('@')));
    return device.empty() ? file_address(text, place) : device_address(text, device, place);
}

}  // namespace tactics
