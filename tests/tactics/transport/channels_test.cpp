// SPDX-License-Identifier: Apache-2.0
// Ways to devices: a machine in the network on loopback, a serial line as a terminal without a person, addresses.
#include "tactics/transport/channels.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tactics/error.h"
#include "tactics/transport/descriptor.h"
#include "tactics/transport/devices.h"
#include "tests/cli/tool.h"

namespace tactics::channels_test {
namespace {

std::string many_bytes(std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i * 7 + i / 256);
    return bytes;
}

// Takes one connection at a port of its own choice and reads `most` bytes.
class Listener {
public:
    explicit Listener(std::size_t most = ~std::size_t{0}) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
        EXPECT_EQ(listen(socket_, 1), 0);
        getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
        port = std::to_string(ntohs(address.sin_port));
        thread_ = std::thread([this, most] {
            const int client = accept(socket_, nullptr, nullptr);
            char block[4096];
            for (ssize_t count = 1; count > 0 && got.size() < most;) {
                count = read(client, block, std::min(sizeof block, most - got.size()));
                if (count > 0) got.append(block, static_cast<std::size_t>(count));
            }
            close(client);
        });
    }
    ~Listener() {
        finish();
        close(socket_);
    }
    void finish() {
        if (thread_.joinable()) thread_.join();
    }
    std::string port, got;

private:
    int socket_;
    std::thread thread_;
};

TEST(Channels, TcpGetsEveryByte) {
    Listener machine;
    const std::string bytes = many_bytes(1'000'000);
    {
        const auto channel = open_tcp("127.0.0.1", machine.port);
        const Delivery delivery = deliver(*channel, bytes, {});
        EXPECT_EQ(delivery.ending, Ending::done);
        EXPECT_EQ(delivery.accepted, bytes.size());
    }
    machine.finish();
    EXPECT_TRUE(machine.got == bytes);
}

// What had not left when the job ended must not come out later: the user goes on behind what was accepted.
TEST(Channels, TcpSendsNothingMoreOnceItsJobHasEnded) {
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    const int small = 2048;
    setsockopt(listener, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    ASSERT_EQ(listen(listener, 1), 0);
    getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
    const std::string bytes = many_bytes(60'000);
    Delivery delivery;
    int machine = -1;
    {
        const auto channel = open_tcp("127.0.0.1", std::to_string(ntohs(address.sin_port)));
        machine = accept(listener, nullptr, nullptr);
        DeliveryWish wish;
        wish.patience = std::chrono::milliseconds(300);
        delivery = deliver(*channel, bytes, wish);
    }
    EXPECT_EQ(delivery.ending, Ending::stalled);
    EXPECT_LT(delivery.accepted, bytes.size());
    std::string got;
    char block[4096];
    for (ssize_t count; (count = read(machine, block, sizeof block)) > 0;) got.append(block, static_cast<std::size_t>(count));
    EXPECT_LE(got.size(), delivery.accepted);
    EXPECT_EQ(got, bytes.substr(0, got.size()));
    close(machine);
    close(listener);
}

TEST(Channels, TcpTellsWhenTheMachineIsGone) {
    Listener machine(100'000);
    const auto channel = open_tcp("127.0.0.1", machine.port);
    const Delivery delivery = deliver(*channel, many_bytes(40'000'000), {});
    EXPECT_EQ(delivery.ending, Ending::gone);
    EXPECT_LT(delivery.accepted, 40'000'000u);
    machine.finish();
    EXPECT_EQ(machine.got, many_bytes(100'000));
}

TEST(Channels, WhereNobodyListensIsSaid) {
    std::string port;
    {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        ASSERT_EQ(bind(socket, reinterpret_cast<sockaddr*>(&address), size), 0);
        getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
        port = std::to_string(ntohs(address.sin_port));
        close(socket);
    }
    try {
        open_tcp("127.0.0.1", port);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_TRUE(tests::holds(error.what(), "no connection: ")) << error.what();
    }
    EXPECT_THROW(open_tcp("no.such.host.invalid", "9100"), Error);
}

TEST(Channels, SerialLineGetsEveryByteAsItIs) {
    const int machine = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(machine, 0);
    ASSERT_EQ(grantpt(machine), 0);
    ASSERT_EQ(unlockpt(machine), 0);
    const std::string path = ptsname(machine), bytes = many_bytes(20'000);
    std::string got;
    const auto channel = open_serial(path, 9600, Flow::rtscts);
    std::thread reader([&] {
        char block[512];
        while (got.size() < bytes.size()) {
            const ssize_t count = read(machine, block, sizeof block);
            if (count <= 0) break;
            got.append(block, static_cast<std::size_t>(count));
        }
    });
    const Delivery delivery = deliver(*channel, bytes, {});
    reader.join();
    EXPECT_EQ(delivery.ending, Ending::done);
    EXPECT_TRUE(got == bytes);
    EXPECT_THROW(open_serial(path, 12345, Flow::none), Error);
    close(machine);
}

TEST(Channels, SayWhatIsWrongWithADevice) {
    const auto message = [](const auto& open) -> std::string {
        try {
            open();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_TRUE(tests::holds(message([] { open_usblp("/dev/usb/lp99"); }), "there is no such device"));
    EXPECT_TRUE(tests::holds(message([] { open_serial("/dev/ttyUSB99", 9600, Flow::none); }), "there is no such device"));
    const tests::Folder folder;
    std::ofstream(folder / "file") << "x";
    EXPECT_TRUE(tests::holds(message([&] { open_usblp((folder / "file").string()); }), "is no device"));
    EXPECT_TRUE(tests::holds(message([] { open_serial("/dev/null", 9600, Flow::xonxoff); }), "is no serial line"));
}

// Whether a line is serial is told by what a name leads to.
TEST(Channels, ABusyLineIsNoQueue) {
    const tests::Folder folder;
    tests::write_bytes(folder / "ttyUSB0", "");
    tests::write_bytes(folder / "lp0", "");
    std::filesystem::create_symlink("ttyUSB0", folder / "usb-FTDI-if00-port0");
    std::filesystem::create_symlink("lp0", folder / "my-tty-embosser");
    const auto told = [&](const std::string& name, int fault) {
        return std::string(refusal_of((folder / name).string(), fault).what());
    };
    for (const char* serial : {"ttyUSB0", "usb-FTDI-if00-port0"}) {
        EXPECT_TRUE(tests::holds(told(serial, EBUSY),
                                 "another program has it open, perhaps BRLTTY or a second one of this; end that one first"));
        EXPECT_TRUE(tests::holds(told(serial, EACCES), "group dialout (sudo adduser $USER dialout, then log in again)"));
    }
    for (const char* printer : {"lp0", "my-tty-embosser"}) {
        EXPECT_TRUE(tests::holds(told(printer, EBUSY), "perhaps a print queue; print to the queue instead (--to queue:NAME)"));
        EXPECT_TRUE(
            tests::holds(told(printer, EPERM),
                         "group lp (sudo adduser $USER lp, then log in again), or install lib/udev/rules.d/70-tactics.rules"));
    }
    EXPECT_TRUE(tests::holds(told("ttyUSB9", ENOENT), "there is no such device"));
    EXPECT_TRUE(tests::holds(told("lp0", EINVAL), "cannot be opened: "));
}

TEST(Addresses, AreRead) {
    const auto read = [](const std::string& text) { return parse_address(text, "--to"); };
    EXPECT_EQ(read("queue:Everest").kind, Address::Kind::queue);
    EXPECT_EQ(read("queue:Everest").name, "Everest");
    EXPECT_EQ(read("tcp:embosser").port, "9100");
    EXPECT_EQ(read("tcp:embosser:9101").port, "9101");
    EXPECT_EQ(read("tcp:embosser:9101").name, "embosser");
    EXPECT_EQ(read("tcp:[::1]:9102").name, "::1");
    EXPECT_EQ(read("tcp:[::1]:9102").port, "9102");
    EXPECT_EQ(read("tcp:fe80::1").name, "fe80::1");
    EXPECT_EQ(read("/dev/usb/lp1").kind, Address::Kind::usblp);
    for (const char* choice : {"", "1209:0002", "12AB:cdef", "1209:0002:SN:1 2", "1-2", "3-1.4.2", "12-10"}) {
        EXPECT_EQ(read(std::string("usb:") + choice).kind, Address::Kind::usb) << choice;
        EXPECT_EQ(read(std::string("usb:") + choice).name, choice);
    }
    EXPECT_EQ(read("/dev/ttyUSB0").baud, 9600);
    EXPECT_EQ(read("/dev/ttyUSB0@19200").baud, 19200);
    EXPECT_EQ(read("/dev/ttyUSB0@19200").name, "/dev/ttyUSB0");
    EXPECT_EQ(read("/dev/ttyUSB0@19200").flow, Flow::rtscts);
    EXPECT_EQ(read("/dev/ttyUSB0@19200,xonxoff").flow, Flow::xonxoff);
    EXPECT_EQ(read("out/page.prn").kind, Address::Kind::file);
    EXPECT_EQ(read("./Everest").kind, Address::Kind::file);
    const tests::Folder folder;
    std::filesystem::create_symlink("/dev/tty", folder / "embosser");
    EXPECT_EQ(read((folder / "embosser").string()).kind, Address::Kind::serial);
    for (const char* wrong : {"",
                              "queue:",
                              "queue:-x",
                              "tcp:",
                              "tcp::9100",
                              "tcp:a:0",
                              "tcp:a:x",
                              "tcp:a:70000",
                              "tcp:[::1",
                              "/dev/ttyUSB0@fast",
                              "/dev/ttyUSB0@9600,what",
                              "tpc:host",
                              "usb:1",
                              "usb:1-",
                              "usb:-2",
                              "usb:1-2.",
                              "usb:1-2..3",
                              "usb:1209",
                              "usb:1209:2",
                              "usb:1209:0002:",
                              "usb:1209:00021",
                              "usb:120g:0002",
                              "usb:lp0",
                              "Everest",
                              "/dev/lp0",
                              "/dev/null"})
        EXPECT_THROW(read(wrong), Error) << wrong;
}

TEST(Devices, AreReadFromWhatTheKernelLists) {
    const tests::Folder folder;
    namespace fs = std::filesystem;
    const fs::path root = folder.path(), usb = root / "sys/devices/usb1/1-2";
    const auto put = [](const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text << "\n";
    };
    put(usb / "product", "Everest-D V5");
    put(usb / "manufacturer", "Index Braille");
    put(usb / "1-2:1.0/bInterfaceClass", "07");
    put(usb / "1-2:1.0/ieee1284_id", "MFG:Index Braille;MDL:Everest-D V5;CLS:PRINTER;");
    put(root / "sys/devices/usb1/1-3/product", "Some Printer");
    put(root / "sys/devices/usb1/1-3/1-3:1.0/bInterfaceClass", "07");
    put(root / "sys/devices/usb1/1-3/busnum", "1");
    put(root / "sys/devices/usb1/1-3/devnum", "7");
    put(root / "dev/bus/usb/001/007", "");
    put(root / "sys/devices/usb1/1-4/product", "Serial Adapter");
    fs::create_directories(root / "sys/devices/usb1/1-4/1-4:1.0/ttyUSB0");
    fs::create_directories(root / "sys/class/usbmisc/lp0");
    fs::create_directories(root / "sys/class/tty/ttyUSB0");
    fs::create_directories(root / "sys/class/tty/tty1");
    fs::create_directories(root / "sys/bus/usb/devices");
    fs::create_directory_symlink(usb / "1-2:1.0", root / "sys/class/usbmisc/lp0/device");
    fs::create_directory_symlink(usb / "1-2:1.0", usb / "1-2:1.0/driver");
    fs::create_directory_symlink(usb / "1-2:1.0", root / "sys/bus/usb/devices/1-2:1.0");
    fs::create_directory_symlink(root / "sys/devices/usb1/1-3/1-3:1.0", root / "sys/bus/usb/devices/1-3:1.0");
    fs::create_directory_symlink(root / "sys/devices/usb1/1-4/1-4:1.0/ttyUSB0", root / "sys/class/tty/ttyUSB0/device");
    put(root / "dev/usb/lp0", "");
    const auto devices = attached_devices(root.string());
    ASSERT_EQ(devices.size(), 3u);
    EXPECT_EQ(devices[0].address, "/dev/usb/lp0");
    EXPECT_EQ(devices[0].id, "MFG:Index Braille;MDL:Everest-D V5;CLS:PRINTER;");
    EXPECT_EQ(devices[0].note.english(), "");
    EXPECT_EQ(devices[1].address, "usb:1-3");
    EXPECT_EQ(devices[1].id, "Some Printer");
    EXPECT_EQ(devices[1].note.english(), "the kernel has no driver for it, it is used directly");
    EXPECT_EQ(devices[2].address, "/dev/ttyUSB0");
    EXPECT_EQ(devices[2].id, "Serial Adapter");
    EXPECT_TRUE(tests::holds(devices[2].note.english(), "there is no /dev/ttyUSB0"));
    EXPECT_TRUE(attached_devices((folder / "nothing").string()).empty());
}

}  // namespace
}  // namespace tactics::channels_test
