// SPDX-License-Identifier: Apache-2.0
// The ways to a device, each in a file of its own. They throw Error(failed) when there is no way.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tactics/transport/delivery.h"

namespace tactics {

/// A USB printer by the kernel's driver: /dev/usb/lp0. Its status tells of paper.
std::unique_ptr<Channel> open_usblp(const std::string& path);

/// A USB printer without the kernel's driver, which is taken off and given back when the channel is closed. `choice` is what
/// stands behind "usb:". `look` is told its IEEE-1284 id (empty: it does not tell) before anything is taken or sent, and may
/// throw.
std::unique_ptr<Channel> open_usb(const std::string& choice, const std::function<void(const std::string& id)>& look);

/// How a machine on a serial line says that it can take no more: by the wires RTS and CTS, by the bytes XON and XOFF, or not at
/// all.
enum class Flow { rtscts, xonxoff, none };

/// A serial line, or a USB adapter that acts as one: /dev/ttyUSB0. 8 bits, no parity, one stop bit.
std::unique_ptr<Channel> open_serial(const std::string& path, int baud, Flow flow);

/// A machine in the network that takes raw bytes (port 9100). IPv4, IPv6 or a name.
std::unique_ptr<Channel> open_tcp(const std::string& host, const std::string& port);

/// What is written in "TO": queue:NAME, tcp:HOST or tcp:HOST:PORT, /dev/usb/lpN, usb:, usb:VID:PID[:SERIAL], usb:BUS-PORT,
/// /dev/tty... with
/// @BAUD or @BAUD,FLOW behind it, or a file.
struct Address {
    enum class Kind { queue, tcp, usblp, usb, serial, file };
    Kind kind = Kind::file;
    std::string name;  ///< of the queue, the host, the path, what stands behind usb:
    std::string port = "9100";
    int baud = 9600;
    Flow flow = Flow::rtscts;
};
/// Throws Error(usage) at `place`.
Address parse_address(const std::string& text, const std::string& place);

}  // namespace tactics
