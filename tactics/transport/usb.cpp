// SPDX-License-Identifier: Apache-2.0
// A printer on USB without the kernel's driver, by libusb: USB Printing Devices 1.1 (class 7). A transfer that timed out reports
// how much of it the printer has accepted; the next one begins there.
#include <fcntl.h>
#include <libusb.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>

#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/channels.h"
#include "tactics/transport/descriptor.h"
#include "tactics/transport/usb_printers.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::uint8_t kAsk = 0xA1;  // in, class, interface
constexpr std::uint8_t kGetDeviceId = 0, kGetPortStatus = 1;
constexpr unsigned char kPaperOut = 0x20;
// libusb waits while it sends: no longer than a delivery does between two looks.
constexpr milliseconds kStep{100};
constexpr unsigned kAskFor = 500;  // ms

struct CloseContext {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};
struct CloseHandle {
    void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Context = std::unique_ptr<libusb_context, CloseContext>;
using Handle = std::unique_ptr<libusb_device_handle, CloseHandle>;

// The interface that takes raw bytes.
struct Way {
    int interface = -1, setting = 0;
    bool has_settings = false;
    unsigned char endpoint = 0;
};

// Which protocol suits: both directions, one, anything but IPP.
int rank_of(int protocol) { return protocol == 2 ? 3 : protocol == 1 ? 2 : protocol == 4 ? 0 : 1; }

Way way_into(libusb_device* device) {
    Way way;
    libusb_config_descriptor* found = nullptr;
    if (libusb_get_active_config_descriptor(device, &found) != 0) return way;
    const std::unique_ptr<libusb_config_descriptor, void (*)(libusb_config_descriptor*)> configuration(
        found, &libusb_free_config_descriptor);
    int best = 0;
    for (int i = 0; i < found->bNumInterfaces; ++i) {
        const libusb_interface& one = found->interface[i];
        for (int j = 0; j < one.num_altsetting; ++j) {
            const libusb_interface_descriptor& setting = one.altsetting[j];
            const int rank = setting.bInterfaceClass == LIBUSB_CLASS_PRINTER ? rank_of(setting.bInterfaceProtocol) : 0;
            for (int k = 0; k < setting.bNumEndpoints; ++k) {
                const libusb_endpoint_descriptor& endpoint = setting.endpoint[k];
                const bool takes = (endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_BULK &&
                                   (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) == 0;
                if (!takes || rank <= best) continue;
                best = rank;
                way = {setting.bInterfaceNumber, setting.bAlternateSetting, one.num_altsetting > 1, endpoint.bEndpointAddress};
            }
        }
    }
    return way;
}

class Usb : public Channel {
public:
    Usb(Context context, Handle handle, Way way) : context_(std::move(context)), handle_(std::move(handle)), way_(way) {}
    // With it the kernel's driver comes back.
    ~Usb() override { libusb_release_interface(handle_.get(), way_.interface); }
    Usb(const Usb&) = delete;
    Usb& operator=(const Usb&) = delete;

    int choose_setting() const { return libusb_set_interface_alt_setting(handle_.get(), way_.interface, way_.setting); }

    Taken take(std::string_view bytes) override {
        const auto now = Clock::now();
        if (!counted_) counted_ = now;
        const auto behind = std::chrono::duration_cast<milliseconds>(now - *counted_);
        const auto time = std::max(kStep - behind, kStep / 10);
        int count = 0;
        const int fault =
            libusb_bulk_transfer(handle_.get(), way_.endpoint, reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data())),
                                 static_cast<int>(bytes.size()), &count, static_cast<unsigned>(time.count()));
        Taken taken{static_cast<std::size_t>(std::max(count, 0))};
        if (taken.bytes > 0) counted_.reset();
        switch (fault) {
            case 0:
            case LIBUSB_ERROR_TIMEOUT:
            case LIBUSB_ERROR_INTERRUPTED: break;
            case LIBUSB_ERROR_NO_DEVICE: taken.ending = Ending::gone; break;
            case LIBUSB_ERROR_PIPE:
                taken.ending = Ending::failed;
                taken.why = "the machine refused what it was sent (it stalled its endpoint); switch it off and on";
                break;
            default:
                // A device that was just unplugged appears as a fault on the wire until the kernel has noticed it.
                taken.ending = fault == LIBUSB_ERROR_IO && !is_there() ? Ending::gone : Ending::failed;
                taken.why = std::string("libusb says ") + libusb_error_name(fault) + "; look at cable and hub";
        }
        return taken;
    }
    // take() has waited; what is left of the time is slept, so that steps that are counted are time that has passed.
    bool wait(milliseconds time) override {
        if (!counted_) counted_ = Clock::now();
        *counted_ += time;
        std::this_thread::sleep_until(*counted_);
        return false;
    }
    Ending trouble() override {
        unsigned char status = 0;
        const int count = ask_status(status);
        if (count == LIBUSB_ERROR_NO_DEVICE) return Ending::gone;
        return count == 1 && (status & kPaperOut) != 0 ? Ending::paper_out : Ending::stalled;
    }
    // A transfer that has ended has left.
    std::size_t on_the_way() override { return 0; }

private:
    int ask_status(unsigned char& status) const {
        return libusb_control_transfer(handle_.get(), kAsk, kGetPortStatus, 0, static_cast<std::uint16_t>(way_.interface),
                                       &status, 1, kAskFor);
    }
    bool is_there() const {
        unsigned char status = 0;
        const int count = ask_status(status);
        return count >= 0 || count == LIBUSB_ERROR_PIPE;  // it refuses the question, but it answers
    }

    Context context_;
    Handle handle_;
    Way way_;
    std::optional<Clock::time_point> counted_;  // while it accepts nothing: the time up to which delivery has counted
};

// Two bytes of length, the high one first (some machines turn them round, or count wrongly), then the id. The kernel lets it be
// asked while another driver has the printer.
std::string id_of(libusb_device_handle* handle, const Way& way) {
    std::array<unsigned char, 1024> answer{};
    const auto place = static_cast<std::uint16_t>(way.interface << 8 | way.setting);
    const int count = libusb_control_transfer(handle, kAsk, kGetDeviceId, 0, place, answer.data(), answer.size(), kAskFor);
    if (count <= 2) return "";
    const int told = answer[0] << 8 | answer[1];
    const auto size = static_cast<std::size_t>(told > 2 ? std::min(told, count) : count) - 2;
    return to_line({reinterpret_cast<const char*>(answer.data()) + 2, size});
}

void refuse_if_open(const UsbPrinter& printer, const std::string& place) {
    const Descriptor device(printer.path.empty() ? -1 : open(printer.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    if (!printer.path.empty() && device.number() < 0 && errno == EBUSY)
        throw Error(Fault::failed, place,
                    phrase("is busy: another program sends to {0}; wait until it is done, or print to its queue ({1} queue:NAME)",
                           printer.path, spelled("to")));
}

[[noreturn]] void fail(const std::string& place, int fault) {
    switch (fault) {
        case LIBUSB_ERROR_NO_DEVICE:
        case LIBUSB_ERROR_NOT_FOUND:
            throw Error(Fault::failed, place, phrase("the printer is gone; plug it in and switch it on; see tactics devices"));
        case LIBUSB_ERROR_BUSY:
            throw Error(
                Fault::failed, place,
                phrase("is busy: another program has claimed it, perhaps CUPS; print to its queue instead ({0} queue:NAME)",
                       spelled("to")));
        case LIBUSB_ERROR_ACCESS:
            throw Error(
                Fault::failed, place,
                phrase("you are not permitted to use it; become a member of the group lp (sudo adduser $USER lp, then log in "
                       "again), and install lib/udev/rules.d/70-tactics.rules of this program in /etc/udev/rules.d"));
        default:
            throw Error(Fault::failed, place,
                        phrase("cannot be opened: libusb says {0}; unplug it and plug it in again", libusb_error_name(fault)));
    }
}

Handle open_at(libusb_context* context, const UsbPrinter& printer, const std::string& place, Way& way) {
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(context, &list);
    if (count < 0) fail(place, static_cast<int>(count));
    const std::unique_ptr<libusb_device*, void (*)(libusb_device**)> all(
        list, [](libusb_device** devices) { libusb_free_device_list(devices, 1); });
    for (ssize_t i = 0; i < count; ++i) {
        if (libusb_get_bus_number(list[i]) != printer.bus || libusb_get_device_address(list[i]) != printer.number) continue;
        way = way_into(list[i]);
        if (way.interface < 0)
            throw Error(Fault::failed, place, phrase("has no way in for plain bytes (bulk); use its print queue"));
        libusb_device_handle* handle = nullptr;
        if (const int fault = libusb_open(list[i], &handle); fault != 0) fail(place, fault);
        return Handle(handle);
    }
    fail(place, LIBUSB_ERROR_NO_DEVICE);
}

}  // namespace

std::unique_ptr<Channel> open_usb(const std::string& choice, const std::function<void(const std::string& id)>& look) {
    const UsbPrinter printer = usb_printer(choice, "");
    const std::string place = "usb:" + printer.place;
    libusb_context* begun = nullptr;
    if (const int fault = libusb_init(&begun); fault != 0) fail(place, fault);
    Context context(begun);
    Way way;
    Handle handle = open_at(context.get(), printer, place, way);
    look(id_of(handle.get(), way));
    refuse_if_open(printer, place);
    libusb_set_auto_detach_kernel_driver(handle.get(), 1);
    if (const int fault = libusb_claim_interface(handle.get(), way.interface); fault != 0) fail(place, fault);
    auto channel = std::make_unique<Usb>(std::move(context), std::move(handle), way);
    if (way.has_settings)
        if (const int fault = channel->choose_setting(); fault != 0) fail(place, fault);
    return channel;
}

}  // namespace tactics
