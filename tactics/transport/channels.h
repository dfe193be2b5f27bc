// SPDX-License-Identifier: Apache-2.0
// The connections to a device, each in its own file. They throw Error(failed) if the device cannot be reached.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tactics/transport/delivery.h"

namespace tactics {

/// A USB printer through the kernel's driver: /dev/usb/lp0. Its status reports the paper.
std::unique_ptr<Channel> open_usblp(const std::string& path);

/// A USB printer without the kernel's driver, which is detached, and attached again when the channel closes. `choice` is the part
/// after "usb:". `look` receives its IEEE-1284 id (empty: none) before anything is detached or sent, and may throw.
std::unique_ptr<Channel> open_usb(const std::string& choice, const std::function<void(const std::string& id)>& look);

/// Flow control on a serial line: by the wires RTS and CTS, by the bytes XON and XOFF, or none.
enum class Flow { rtscts, xonxoff, none };

/// A serial line, or a USB adapter that acts as one: /dev/ttyUSB0. 8 bits, no parity, one stop bit.
std::unique_ptr<Channel> open_serial(const std::string& path, int baud, Flow flow);

/// A machine in the network that takes raw bytes (port 9100). IPv4, IPv6 or a name.
std::unique_ptr<Channel> open_tcp(const std::string& host, const std::string& port);

/// The address in --to: queue:NAME, tcp:HOST or tcp:HOST:PORT, /dev/usb/lpN, usb:, usb:VID:PID[:SERIAL], usb:BUS-PORT,
/// /dev/tty... optionally followed by @BAUD or @BAUD,FLOW, or a file.
struct Address {
    enum class Kind { queue, tcp, usblp, usb, serial, file };
    Kind kind = Kind::file;
    std::string name;  ///< of the queue, the host or the path, or the part after usb:
    std::string port = "9100";
    int baud = 9600;
    Flow flow = Flow::rtscts;
};
/// Throws Error(usage) at `place`.
Address parse_address(const std::string& text, const std::string& place);

}  // namespace tactics
