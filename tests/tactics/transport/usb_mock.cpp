// SPDX-License-Identifier: Apache-2.0
// A printer on USB that is not there: runs a program that finds it, by umockdev, and keeps what the printer takes.
//     umockdev-wrapper usb_mock FILE[,unplug=BYTES][,stop=BYTES][,for=TIMES][,paper][,stall=BYTES][,busy][,id=TEXT][,second]
//     PROGRAM...
// FILE has its bytes, FILE.driver a line for each time the kernel's driver was detached (-) and attached again (+). It ends as
// PROGRAM does. "stop" accepts no more from there, for that many abandoned transfers, or for ever; with "paper" it gives the
// reason.
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <string>

#include "tests/tactics/transport/mocked_child.h"

namespace {

using namespace tactics;

// Two interfaces, that the one for printing is not number 0; its endpoint 5, its second setting the one with both directions.
constexpr const char* kDescriptors =
    "12010002000000400912020000010102030109023900020100C032"
    "0904000000FF000000"
    "090401000107010100070503020002000904010102070102000705050200020007058602000200";

std::string printer_at(int port) {
    const std::string place = "/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(port),
                      number = std::to_string(port + 1);
    return "P: " + place + "\nN: bus/usb/001/00" + number + "=" + kDescriptors + "\nE: DEVNAME=/dev/bus/usb/001/00" + number +
           "\nE: MAJOR=189\nE: MINOR=" + std::to_string(port) +
           "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nE: BUSNUM=001\nE: DEVNUM=00" + number +
           "\nE: PRODUCT=1209/2/100\nA: dev=189:" + std::to_string(port) +
           "\\n\nA: idVendor=1209\\n\nA: idProduct=0002\\n\nA: manufacturer=Index Braille\\n\n"
           "A: product=Pretended\\n\nA: serial=SN" +
           std::to_string(port) + "\\n\nA: busnum=1\\n\nA: devnum=" + number +
           "\\n\nA: speed=480\\n\nA: bConfigurationValue=1\\n\nA: bNumConfigurations=1\\n\nH: descriptors=" + kDescriptors +
           "\n\n"
           "P: " +
           place + "/1-" + std::to_string(port) +
           ":1.1\nE: DEVTYPE=usb_interface\nE: DRIVER=usblp\nE: SUBSYSTEM=usb\n"
           "A: bInterfaceNumber=01\\n\nA: bInterfaceClass=07\\n\nA: bInterfaceProtocol=01\\n\n\n";
}

struct Transfer {
    UMockdevIoctlData* data = nullptr;
    bool given_up = false;
    usbdevfs_urb* urb() const { return reinterpret_cast<usbdevfs_urb*>(data->data); }
};

constexpr long kNever = 1L << 40;

class Printer {
public:
    explicit Printer(char* words) {
        char* word = std::strtok(words, ",");
        bytes_ = std::fopen(word, "wb");
        driver_ = std::fopen((std::string(word) + ".driver").c_str(), "w");
        while ((word = std::strtok(nullptr, ",")) != nullptr) {
            const std::string text = word;
            const auto number = [&](const char* name, long& to) {
                if (text.starts_with(name)) to = std::stol(text.substr(std::strlen(name)));
            };
            number("unplug=", unplugged_at_);
            number("stop=", stops_at_);
            number("for=", stops_for_);
            number("stall=", stalls_at_);
            if (text == "paper") no_paper_ = true;
            if (text == "busy") busy_ = true;
            if (text == "second") second = true;
            if (text.starts_with("id=")) id_ = text.substr(3);
        }
    }
    bool second = false;

    int answer(UMockdevIoctlClient* client, int& fault) {
        const unsigned long request = umockdev_ioctl_client_get_request(client);
        UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
        const auto failed = [&](int number) {
            fault = number;
            return -1;
        };
        if (got_ >= unplugged_at_ && request != USBDEVFS_REAPURB && request != USBDEVFS_REAPURBNDELAY) return failed(ENODEV);
        if (request == USBDEVFS_DISCARDURB) return give_up(argument) ? 0 : failed(EINVAL);
        UMockdevIoctlData* data =
            _IOC_SIZE(request) > 0 ? umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr) : nullptr;
        switch (request) {
            case USBDEVFS_GET_CAPABILITIES: {
                const unsigned capabilities = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
                std::memcpy(data->data, &capabilities, sizeof capabilities);
                return 0;
            }
            case USBDEVFS_DISCONNECT_CLAIM:
                if (busy_) return failed(EBUSY);
                std::fputs("-\n", driver_);
                std::fflush(driver_);
                return 0;
            case USBDEVFS_IOCTL:
                if (reinterpret_cast<usbdevfs_ioctl*>(data->data)->ioctl_code == static_cast<int>(USBDEVFS_CONNECT)) {
                    std::fputs("+\n", driver_);
                    std::fflush(driver_);
                }
                return 0;
            case USBDEVFS_SETINTERFACE: {
                const auto* wish = reinterpret_cast<usbdevfs_setinterface*>(data->data);
                return wish->interface == 1 && wish->altsetting == 1 ? 0 : failed(EINVAL);
            }
            case USBDEVFS_CLAIMINTERFACE: return busy_ ? failed(EBUSY) : 0;
            case USBDEVFS_RELEASEINTERFACE: return 0;
            case USBDEVFS_SUBMITURB: {
                const auto* urb = reinterpret_cast<usbdevfs_urb*>(data->data);
                umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urb->buffer_length),
                                            nullptr);
                transfers_.push_back({static_cast<UMockdevIoctlData*>(g_object_ref(data)), false});
                begin(transfers_.back());
                return 0;
            }
            case USBDEVFS_REAPURB:
            case USBDEVFS_REAPURBNDELAY: {
                const auto ended = std::find_if(transfers_.begin(), transfers_.end(), [](const Transfer& one) {
                    return one.given_up || one.urb()->status != -EINPROGRESS;
                });
                if (ended == transfers_.end()) return failed(got_ >= unplugged_at_ ? ENODEV : EAGAIN);
                umockdev_ioctl_data_set_ptr(data, 0, ended->data);
                transfers_.erase(ended);
                return 0;
            }
            default: return failed(ENOTTY);
        }
    }

private:
    bool give_up(const UMockdevIoctlData* argument) {
        unsigned long address = 0;
        std::memcpy(&address, argument->data, sizeof address);
        for (Transfer& one : transfers_) {
            if (one.data->client_addr != address || one.urb()->status != -EINPROGRESS) continue;
            one.given_up = true;
            one.urb()->status = -ENOENT;
            if (--stops_for_ == 0) stops_at_ = kNever;
            return true;
        }
        return false;
    }

    void begin(const Transfer& transfer) {
        usbdevfs_urb& urb = *transfer.urb();
        urb.status = 0;
        urb.actual_length = 0;
        if (urb.type == USBDEVFS_URB_TYPE_CONTROL) return control(urb);
        if (urb.endpoint != 5) {
            urb.status = -EPROTO;
            return;
        }
        const auto* bytes = static_cast<const char*>(urb.buffer);
        const long count =
            std::min({static_cast<long>(urb.buffer_length), unplugged_at_ - got_, stops_at_ - got_, stalls_at_ - got_});
        std::fwrite(bytes, 1, static_cast<std::size_t>(count), bytes_);
        std::fflush(bytes_);
        got_ += count;
        urb.actual_length = static_cast<int>(count);
        if (count < urb.buffer_length) urb.status = got_ >= unplugged_at_ ? -ENODEV : got_ >= stalls_at_ ? -EPIPE : -EINPROGRESS;
    }

    void control(usbdevfs_urb& urb) const {
        auto* bytes = static_cast<unsigned char*>(urb.buffer);
        const int most = bytes[6] | bytes[7] << 8, kind = bytes[0] << 8 | bytes[1];
        std::string said;
        // Of this interface, and for the id of its second setting.
        if (kind == 0xA100 && bytes[4] == 1 && bytes[5] == 1)
            said = std::string{'\0', static_cast<char>(id_.size() + 2)} + id_;
        else if (kind == 0xA101 && bytes[4] == 1 && bytes[5] == 0)
            said = no_paper_ && got_ >= stops_at_ ? "\x38" : "\x18";
        else
            urb.status = -EPIPE;
        urb.actual_length = std::min(static_cast<int>(said.size()), most);
        std::memcpy(bytes + 8, said.data(), static_cast<std::size_t>(urb.actual_length));
    }

    std::FILE* bytes_;
    std::FILE* driver_;
    std::deque<Transfer> transfers_;
    std::string id_ = "MFG:Index Braille;MDL:Pretended;CLS:PRINTER;";
    long got_ = 0, unplugged_at_ = kNever, stops_at_ = kNever, stalls_at_ = kNever, stops_for_ = kNever;
    bool no_paper_ = false, busy_ = false;
};

gboolean asked(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer printer) {
    int fault = 0;
    const int answer = static_cast<Printer*>(printer)->answer(client, fault);
    umockdev_ioctl_client_complete(client, answer, fault);
    return TRUE;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) return tests::kNoMock;
    Printer printer(words[1]);
    GError* error = nullptr;
    UMockdevTestbed* testbed = umockdev_testbed_new();
    const std::string there = printer_at(1) + (printer.second ? printer_at(2) : "");
    if (!umockdev_testbed_add_from_string(testbed, there.c_str(), &error)) return tests::no_mock(error);
    return tests::run_beside(testbed, "/dev/bus/usb/001/002", {G_CALLBACK(asked), nullptr, nullptr, &printer}, words + 2);
}
