// SPDX-License-Identifier: Apache-2.0
// The first and only program of a virtual machine with a real kernel: a printer gadget on a pretended USB bus, on the other side
// the kernel's printer driver or libusb, and our delivery between them; then a gadget that is a braille display, and the kernel's
// hidraw. Prints a row for each trial; tests/bench/usb starts it.
#include <linux/usb/g_printer.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/reboot.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/channels.h"
#include "tests/bench/guest/guest.h"

namespace {

using namespace tactics;
using namespace tests;
using std::chrono::milliseconds;

const std::string kGadget = "/config/usb_gadget/g1", kDots = "/config/usb_gadget/g2";
constexpr const char* kId = "MFG:Index Braille;MDL:Pretended;CLS:PRINTER;";

void set_up() {
    set_up_guest();
    for (const std::string folder : {"", "/strings/0x409", "/configs/c.1", "/functions/printer.0"})
        mkdir((kGadget + folder).c_str(), 0755);
    put(kGadget + "/idVendor", "0x1209");
    put(kGadget + "/idProduct", "0x0002");
    put(kGadget + "/functions/printer.0/pnp_string", kId);
    put(kGadget + "/functions/printer.0/q_len", "8");
    if (symlink((kGadget + "/functions/printer.0").c_str(), (kGadget + "/configs/c.1/printer.0").c_str()) != 0)
        std::printf("no gadget\n");
}

void plug(bool in) {
    if ((access("/dev/usb/lp0", F_OK) == 0) == in) return;
    put(kGadget + "/UDC", in ? "dummy_udc.0" : "\n");
    is_there("/dev/usb/lp0", in);
    rest(100);
}

// What the machine does: reads until it has `stops_at` bytes, says then that it has no paper or nothing, and perhaps goes on.
struct Machine {
    std::size_t stops_at = ~std::size_t{0};  // and what it has in its buffers, 64 kB
    bool no_paper = false;
    int goes_on_after = 0;  // ms; 0: never
    std::size_t unplugged_at = ~std::size_t{0};
};

constexpr const char* kGot = "/got";

// A process of its own, ended by a signal. It reads as it can wait: the gadget of this kernel does not bear to be asked without
// waiting.
[[noreturn]] void run_machine(const Machine& machine) {
    const int device = open("/dev/g_printer0", O_RDWR), out = open(kGot, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ioctl(device, GADGET_SET_PRINTER_STATUS, static_cast<unsigned char>(0x18));
    char block[8192];  // as large as the gadget's own buffers
    std::size_t size = 0;
    for (bool stopped = false;;) {
        if (!stopped && size >= machine.stops_at) {
            stopped = true;
            if (machine.no_paper) ioctl(device, GADGET_SET_PRINTER_STATUS, static_cast<unsigned char>(0x38));
            if (machine.goes_on_after == 0)
                for (;;) pause();
            rest(machine.goes_on_after);
            ioctl(device, GADGET_SET_PRINTER_STATUS, static_cast<unsigned char>(0x18));
        }
        if (size >= machine.unplugged_at) {
            close(device);
            put(kGadget + "/UDC", "\n");
            for (;;) pause();
        }
        const ssize_t count = read(device, block, sizeof block);
        if (count <= 0)
            rest(5);
        else if (write(out, block, static_cast<std::size_t>(count)) == count)
            size += static_cast<std::size_t>(count);
    }
}

std::string bytes_got() {
    std::string bytes;
    const int file = open(kGot, O_RDONLY);
    char block[65536];
    for (ssize_t count; (count = read(file, block, sizeof block)) > 0;) bytes.append(block, static_cast<std::size_t>(count));
    close(file);
    return bytes;
}

std::string many_bytes(std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i * 7 + i / 256);
    return bytes;
}

const char* name_of(Ending ending) {
    switch (ending) {
        case Ending::done: return "done";
        case Ending::paper_out: return "paper-out";
        case Ending::stalled: return "stalled";
        case Ending::gone: return "gone";
        case Ending::cancelled: return "cancelled";
        case Ending::failed: break;
    }
    return "failed";
}

enum class Way { usblp, libusb };

std::unique_ptr<Channel> open_by(Way way) {
    return way == Way::usblp ? open_usblp("/dev/usb/lp0") : open_usb("", [](const std::string&) {});
}

struct Told {
    Ending ending = Ending::done;
    int troubles = 0;  // that the machine says while it is sent to
};

// Between what is accepted and what the machine has read are at most the buffers of the gadget, 8 of 8 kB, and one of usblp's.
constexpr std::size_t kBetween = 9 * 8192;

// What is not as it has to be; empty: nothing.
std::string wrong_with(const Delivery& delivery, int troubles, const std::string& got, bool has_driver, const std::string& sent,
                       const Machine& machine, const Told& expected) {
    const bool gone = expected.ending == Ending::gone, done = expected.ending == Ending::done;
    if (delivery.ending != expected.ending) return "another ending";
    if (troubles != expected.troubles) return "troubles told";
    if (has_driver == gone) return gone ? "usblp is still there" : "usblp is not given back";
    if (got.size() > delivery.accepted) return "more is read than was accepted";
    if (got != sent.substr(0, got.size())) return "other bytes";
    if (done && (delivery.accepted != sent.size() || got.size() != sent.size())) return "bytes are lost";
    if (!done && delivery.accepted - got.size() > kBetween) return "more is between than fits there";
    if (!done && got.size() < std::min(machine.stops_at, machine.unplugged_at)) return "it read less than it was to read";
    if (!done && delivery.accepted >= sent.size()) return "all is said to be accepted";
    return "";
}

void trial(Way way, const char* name, const Machine& machine, std::size_t count, Told expected) {
    plug(true);
    const std::string bytes = many_bytes(count);
    std::fflush(stdout);
    const pid_t reader = fork();
    if (reader == 0) run_machine(machine);
    rest(100);
    Delivery delivery;
    int told = 0;
    try {
        const auto channel = open_by(way);
        DeliveryWish wish;
        wish.patience = milliseconds(1500);
        wish.tell = [&](std::size_t, std::optional<Ending> trouble) { told += trouble ? 1 : 0; };
        delivery = deliver(*channel, bytes, wish);
    } catch (const Error& error) {
        delivery = {Ending::failed, 0, error.what()};
    }
    rest(400);
    const bool has_driver = access("/dev/usb/lp0", F_OK) == 0;  // it is given back; an unplugged one is not there
    kill(reader, SIGKILL);
    waitpid(reader, nullptr, 0);
    const std::string got = bytes_got();
    const std::string wrong = wrong_with(delivery, told, got, has_driver, bytes, machine, expected);
    std::printf("| %s: %s | %zu | %s | %zu | %zu | %d | %s |\n", way == Way::usblp ? "usblp" : "libusb", name, count,
                name_of(delivery.ending), delivery.accepted, got.size(), told,
                wrong.empty() ? "good" : (wrong + ": BAD").c_str());
    plug(false);
}

void trials_by(Way way) {
    trial(way, "all of it", {}, 1'000'000, {});
    trial(way, "a few bytes", {}, 5'000, {});
    trial(way, "out of paper, for good", {.stops_at = 60'000, .no_paper = true}, 200'000, {Ending::paper_out, 1});
    trial(way, "out of paper for a second", {.stops_at = 60'000, .no_paper = true, .goes_on_after = 1000}, 200'000,
          {Ending::done, 1});
    trial(way, "takes nothing more", {.stops_at = 60'000}, 200'000, {Ending::stalled});
    std::size_t at = 1'000;
    for (int i = 0; i < 10; ++i) {
        at = at * 7919 % 190'000 + 100;
        trial(way, "unplugged", {.unplugged_at = at}, 200'000, {Ending::gone});
    }
}

std::string refusal_of(Way way) {
    try {
        open_by(way);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// The driver that has the printer, and the one that gets it back.
void trials_of_drivers() {
    plug(true);
    std::string id;
    try {
        open_usb("", [&](const std::string& said) {
            id = said;
            throw Error(Fault::failed, "usb", "not this one");
        });
    } catch (const Error&) {
    }
    // This kernel's gadget forgets the two bytes of length when it counts what it sends.
    row("the id is told while usblp has the printer", id.size() > 20 && std::string_view(kId).starts_with(id));
    row("a printer that is refused by its id stays with usblp", access("/dev/usb/lp0", F_OK) == 0);
    {
        const auto other = open_by(Way::usblp);
        row("not taken from a program that sends by usblp",
            refusal_of(Way::libusb).find("another program sends to /dev/usb/lp0") != std::string::npos);
    }
    {
        const auto other = open_by(Way::libusb);
        row("usblp is taken off", !is_there("/dev/usb/lp0", false));
        row("not taken from a program that has claimed it", refusal_of(Way::libusb).find("is busy") != std::string::npos);
    }
    row("usblp is given back", is_there("/dev/usb/lp0"));
    plug(false);
}

using Bytes = std::vector<std::uint8_t>;

// Reports as the display gets them, a line of hexadecimal each. A key is pressed once it is in use: before, the kernel throws
// keys away.
[[noreturn]] void run_dots(std::size_t key_size) {
    const int device = open("/dev/hidg0", O_RDWR), out = open(kGot, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    Bytes key(key_size, 3);  // the number of its report, where they have one
    unsigned char block[4096];
    for (;;) {
        const ssize_t count = read(device, block, sizeof block);
        if (count <= 0)
            rest(5);
        else if (!key.empty() && write(device, key.data(), key.size()) > 0)
            key.clear();
        for (ssize_t i = 0; i < count; ++i) dprintf(out, "%02x%s", block[i], i + 1 == count ? "\n" : "");
    }
}

std::string hex_of(const Bytes& bytes) {
    std::string text;
    char two[3];
    for (const std::uint8_t byte : bytes) {
        std::snprintf(two, sizeof two, "%02x", byte);
        text += two;
    }
    return text + "\n";
}

// The cells that are expected are counted up from 1 at each showing.
void trial_of_dots(const char* name, const Bytes& descriptor, std::size_t report, std::size_t key, CellDisplaySize expected,
                   const std::function<std::string(const Bytes& cells)>& wire) {
    std::printf("| %s: | |\n", name);
    const std::string function = kDots + "/functions/hid.0";
    make_hid_gadget(kDots, "0x0003", "Dots", report, {reinterpret_cast<const char*>(descriptor.data()), descriptor.size()});
    put(kDots + "/UDC", "dummy_udc.0");
    row("is there", is_there("/dev/hidraw0") && is_there("/dev/hidg0"));
    rest(200);
    std::fflush(stdout);
    const pid_t dots = fork();
    if (dots == 0) run_dots(key);
    try {
        const auto display = open_hid_display("");
        const CellDisplaySize size = display->size();
        row("its size", size.columns == expected.columns && size.lines == expected.lines && size.dots == expected.dots);
        Bytes cells(static_cast<std::size_t>(size.columns * size.lines));
        std::string sent;
        for (int time = 0; time < 20; ++time) {
            for (std::size_t i = 0; i < cells.size(); ++i)
                cells[i] = static_cast<std::uint8_t>(i + 1 + static_cast<std::size_t>(time) * 13);
            display->show(cells);
            sent += wire(cells);
        }
        row("a key is felt", display->key_within(milliseconds(2000)));
        row("and no other", !display->key_within(milliseconds(100)));
        rest(300);
        row("twenty times all cells arrive as they were shown", bytes_got() == sent);
        put(kDots + "/UDC", "\n");
        rest(300);
        std::string said;
        try {
            display->show(cells);
        } catch (const Error& error) {
            said = error.what();
        }
        row("unplugged, it is gone", said.find("the braille display is gone") != std::string::npos);
        said.clear();
        try {
            display->key_within(milliseconds(100));
        } catch (const Error& error) {
            said = error.what();
        }
        row("and so are its keys", said.find("the braille display is gone") != std::string::npos);
    } catch (const Error& error) {
        row(error.what(), false);
    }
    kill(dots, SIGKILL);
    waitpid(dots, nullptr, 0);
    if (is_there("/dev/hidraw0", false)) put(kDots + "/UDC", "\n");
    unlink((kDots + "/configs/c.1/hid.0").c_str());
    rmdir(function.c_str());
}

void trials_of_dots() {
    const Bytes start{0x05, 0x41, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08};
    const Bytes keys{0x75, 0x01, 0x95, 0x10, 0x0A, 0x01, 0x02, 0x81, 0x02};  // a bit each
    const auto joined = [](std::initializer_list<Bytes> parts) {
        Bytes all;
        for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
        return all;
    };
    const auto row_of = [](std::uint8_t cells) {
        return Bytes{0x95, cells, 0x09, 0x02, 0xA1, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0};
    };
    const auto report = [](std::uint8_t id) { return Bytes{0x85, id}; };
    trial_of_dots("two rows of 20 cells in one report without an id", joined({start, row_of(20), row_of(20), keys, {0xC0}}), 40,
                  2, {20, 2, 8}, hex_of);
    trial_of_dots("four rows of 24 cells in reports 1 and 2",
                  joined({start, report(1), row_of(24), row_of(24), report(2), row_of(24), row_of(24), report(3), keys, {0xC0}}),
                  49, 3, {24, 4, 8}, [&](const Bytes& cells) {
                      return hex_of(joined({{1}, {cells.begin(), cells.begin() + 48}})) +
                             hex_of(joined({{2}, {cells.begin() + 48, cells.end()}}));
                  });
}

}  // namespace

int main() {
    set_up();
    std::printf("| trial | bytes | told | accepted | the machine read | troubles told | |\n|---|---|---|---|---|---|---|\n");
    trials_by(Way::usblp);
    trials_by(Way::libusb);
    std::printf("\n| trial | |\n|---|---|\n");
    trials_of_drivers();
    trials_of_dots();
    std::printf("END\n");
    std::fflush(stdout);
    reboot(RB_POWER_OFF);
}
