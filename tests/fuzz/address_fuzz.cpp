// SPDX-License-Identifier: Apache-2.0
// Any words as the address of a device: one that can be opened, or one line of what is wrong.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tactics/error.h"
#include "tactics/transport/channels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (text.find('\0') != std::string::npos) return 0;  // no word of a command line has one
    try {
        const Address address = parse_address(text, "--to");
        if (address.name.empty() && address.kind != Address::Kind::usb) std::abort();
        if (address.baud < 1 || address.baud > 1'000'000) std::abort();
        if (address.kind == Address::Kind::queue && address.name[0] == '-') std::abort();
        if (address.port.empty() || address.port.find_first_not_of("0123456789") != std::string::npos) std::abort();
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
