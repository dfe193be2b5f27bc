// The ways to a device, each in a file of its own. They throw Error(failed) when there is no way.
#pragma once

#include <memory>
#include <string>

#include "tactics/transport/delivery.h"

namespace tactics {

/// A USB printer by the kernel's driver: /dev/usb/lp0. Its status tells of paper.
std::unique_ptr<Channel> open_usblp(const std::string& path);

/// How a machine on a serial line says that it can take no more: by the wires RTS and CTS, by the bytes XON and XOFF, or not at all.
enum class Flow { rtscts, xonxoff, none };

/// A serial line, or a USB adapter that acts as one: /dev/ttyUSB0. 8 bits, no parity, one stop bit.
std::unique_ptr<Channel> open_serial(const std::string& path, int baud, Flow flow);

/// A machine in the network that takes raw bytes (port 9100). IPv4, IPv6 or a name.
std::unique_ptr<Channel> open_tcp(const std::string& host, const std::string& port);

/// What is written in "TO": queue:NAME, tcp:HOST or tcp:HOST:PORT, /dev/usb/lpN, /dev/tty... with @BAUD or @BAUD,FLOW behind it, or a file.
struct Address {
    enum class Kind { queue, tcp, usblp, serial, file };
    Kind kind = Kind::file;
    std::string name;  ///< of the queue, the host, the path
    std::string port = "9100";
    int baud = 9600;
    Flow flow = Flow::rtscts;
};
/// Throws Error(usage) at `place`.
Address parse_address(const std::string& text, const std::string& place);

}  // namespace tactics
