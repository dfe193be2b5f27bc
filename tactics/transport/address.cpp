#include "tactics/error.h"
#include "tactics/transport/channels.h"
#include "tactics/units.h"

namespace tactics {

Address parse_address(const std::string& text, const std::string& place) {
    Address address;
    const auto named = [&](std::string_view start) { return std::string_view(text).starts_with(start); };
    if (text.empty() || text == "queue:" || text == "tcp:")
        throw Error(Fault::usage, place, "say where to: queue:NAME, tcp:HOST, /dev/usb/lp0, /dev/ttyUSB0@9600, or a file; see tactics devices");
    if (named("queue:")) {
        address.kind = Address::Kind::queue;
        address.name = text.substr(6);
        // lp would take it for an option.
        if (address.name[0] == '-') throw Error(Fault::usage, place, "no queue has a name that begins with -; see tactics devices");
    } else if (named("tcp:")) {
        address.kind = Address::Kind::tcp;
        address.name = text.substr(4);
        // [::1]:9100, ::1, host, host:9100
        if (address.name[0] == '[') {
            const auto end = address.name.find(']');
            if (end == std::string::npos) throw Error(Fault::usage, place, "the ] of the address is missing");
            if (address.name.size() > end + 2 && address.name[end + 1] == ':') address.port = address.name.substr(end + 2);
            address.name = address.name.substr(1, end - 1);
        } else if (const auto colon = address.name.find(':'); colon != std::string::npos && address.name.find(':', colon + 1) == std::string::npos) {
            address.port = address.name.substr(colon + 1);
            address.name.resize(colon);
        }
        const auto number = parse_number(address.port);
        if (!number || *number < 1 || *number > 65535 || address.port.find_first_not_of("0123456789") != std::string::npos)
            throw Error(Fault::usage, place, "a port is a number from 1 to 65535");
        if (address.name.empty()) throw Error(Fault::usage, place, "the name of the machine is missing: tcp:HOST");
    } else if (named("/dev/usb/lp")) {
        address.kind = Address::Kind::usblp;
        address.name = text;
    } else if (named("/dev/tty") || named("/dev/serial/") || named("/dev/pts/")) {
        address.kind = Address::Kind::serial;
        const auto at = text.find('@');
        address.name = text.substr(0, at);
        if (at != std::string::npos) {
            const auto baud = parse_number(text.substr(at + 1));
            if (!baud || *baud < 1 || *baud > 1e6) throw Error(Fault::usage, place, "the speed is a number: /dev/ttyUSB0@9600");
            address.baud = static_cast<int>(*baud);
        }
    } else {
        address.name = text;
    }
    return address;
}

}  // namespace tactics
