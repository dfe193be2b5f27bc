// The first and only program of a virtual machine with a real kernel: a printer gadget on a pretended USB bus, the kernel's printer
// driver on the other side, and our delivery between them. Prints a row for each trial; tests/bench/usb starts it.
#include <fcntl.h>
#include <linux/usb/g_printer.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/channels.h"

namespace {

using namespace tactics;
using std::chrono::milliseconds;

const std::string kGadget = "/config/usb_gadget/g1";

void put(const std::string& path, std::string_view text) {
    const int file = open(path.c_str(), O_WRONLY);
    if (file < 0 || write(file, text.data(), text.size()) < 0) std::printf("cannot write %s: %s\n", path.c_str(), std::strerror(errno));
    if (file >= 0) close(file);
}

void rest(int ms) { std::this_thread::sleep_for(milliseconds(ms)); }

void load(const std::string& module) {
    const int file = open(("/modules/" + module + ".ko").c_str(), O_RDONLY);
    if (file < 0 || syscall(SYS_finit_module, file, "", 0) != 0) std::printf("cannot load %s: %s\n", module.c_str(), std::strerror(errno));
    if (file >= 0) close(file);
}

void set_up() {
    for (const char* folder : {"/proc", "/sys", "/dev", "/config"}) mkdir(folder, 0755);
    mount("proc", "/proc", "proc", 0, nullptr);
    mount("sysfs", "/sys", "sysfs", 0, nullptr);
    mount("devtmpfs", "/dev", "devtmpfs", 0, nullptr);
    for (const char* module : {"usb-common", "usbcore", "udc-core", "dummy_hcd", "configfs", "libcomposite", "usb_f_printer", "usblp"}) load(module);
    mount("configfs", "/config", "configfs", 0, nullptr);
    for (const std::string folder : {"", "/strings/0x409", "/configs/c.1", "/functions/printer.0"}) mkdir((kGadget + folder).c_str(), 0755);
    put(kGadget + "/idVendor", "0x1209");
    put(kGadget + "/idProduct", "0x0002");
    put(kGadget + "/functions/printer.0/pnp_string", "MFG:Index Braille;MDL:Pretended;CLS:PRINTER;");
    put(kGadget + "/functions/printer.0/q_len", "8");
    if (symlink((kGadget + "/functions/printer.0").c_str(), (kGadget + "/configs/c.1/printer.0").c_str()) != 0) std::printf("no gadget\n");
}

void plug(bool in) {
    if ((access("/dev/usb/lp0", F_OK) == 0) == in) return;
    put(kGadget + "/UDC", in ? "dummy_udc.0" : "\n");
    for (int i = 0; i < 50 && (access("/dev/usb/lp0", F_OK) == 0) != in; ++i) rest(20);
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

// A process of its own, ended by a signal. It reads as it can wait: the gadget of this kernel does not bear to be asked without waiting.
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
        if (count <= 0) rest(5);
        else if (write(out, block, static_cast<std::size_t>(count)) == count) size += static_cast<std::size_t>(count);
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

void trial(const char* name, const Machine& machine, std::size_t count, Ending expected) {
    plug(true);
    const std::string bytes = many_bytes(count);
    std::fflush(stdout);
    const pid_t reader = fork();
    if (reader == 0) run_machine(machine);
    rest(100);
    Delivery delivery;
    int told = 0;
    try {
        const auto channel = open_usblp("/dev/usb/lp0");
        DeliveryWish wish;
        wish.patience = milliseconds(1500);
        wish.tell = [&](std::size_t, std::optional<Ending> trouble) { told += trouble ? 1 : 0; };
        delivery = deliver(*channel, bytes, wish);
    } catch (const Error& error) {
        delivery = {Ending::failed, 0, error.what()};
    }
    rest(400);
    kill(reader, SIGKILL);
    waitpid(reader, nullptr, 0);
    const std::string got = bytes_got();
    const bool prefix = got == bytes.substr(0, got.size());
    std::printf("| %s | %zu | %s | %zu | %zu | %s | %d | %s |\n", name, count, name_of(delivery.ending), delivery.accepted, got.size(),
                prefix ? "as sent" : "OTHERS", told, delivery.ending == expected ? "good" : "BAD");
    plug(false);
}

}  // namespace

int main() {
    set_up();
    std::printf("| trial | bytes | told | accepted | the machine read | which are | troubles told | |\n|---|---|---|---|---|---|---|---|\n");
    trial("all of it", {}, 1'000'000, Ending::done);
    trial("a few bytes", {}, 5'000, Ending::done);
    trial("out of paper, for good", {.stops_at = 60'000, .no_paper = true}, 200'000, Ending::paper_out);
    trial("out of paper for a second", {.stops_at = 60'000, .no_paper = true, .goes_on_after = 1000}, 200'000, Ending::done);
    trial("takes nothing more", {.stops_at = 60'000}, 200'000, Ending::stalled);
    std::size_t at = 1'000;
    for (int i = 0; i < 10; ++i) {
        at = at * 7919 % 190'000 + 100;
        trial("unplugged", {.unplugged_at = at}, 200'000, Ending::gone);
    }
    std::printf("END\n");
    std::fflush(stdout);
    reboot(RB_POWER_OFF);
}
