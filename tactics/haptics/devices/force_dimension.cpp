// SPDX-License-Identifier: Apache-2.0
// Arms of Force Dimension (delta, omega, sigma, lambda) and the Novint Falcon, through the maker's own library, if the user has
// it. Its functions are declared here from its public documentation (Force Dimension, "DHD - Haptic SDK Documentation" 3.17:
// Standard SDK; the same names and arguments since 3.2). Its axes: x towards the user, y to the right, z up, in m; it takes N.
// Functions return a negative value on failure; dhdSetForce returns 2 if a motor is at its limit, which is no failure. This has
// not been tried on a real device yet.
#include <chrono>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/arm_talk.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/transport/shared_library.h"

namespace tactics {

namespace {

constexpr std::chrono::microseconds kForceDimensionPace{500};  // twice as often as a loop asks
constexpr unsigned char kOn = 1, kOff = 0;                     // DHD_ON, DHD_OFF
constexpr double kForceDimensionMostReach = 1;                 // m; the largest of them reaches 0.4

struct Dhd {
    int (*open)() = nullptr;
    int (*close)(char id) = nullptr;
    int (*enable_force)(unsigned char on, char id) = nullptr;
    int (*place)(double* x, double* y, double* z, char id) = nullptr;
    int (*push)(double x, double y, double z, char id) = nullptr;
    unsigned (*buttons)(char id) = nullptr;
    const char* (*why)() = nullptr;
};

Dhd dhd_of(const std::string& path) {
    const std::string names[] = {path.empty() ? "libdhd.so.3" : path, path.empty() ? "libdhd.so" : path};
    const SharedLibrary file(names, "dhd",
                             "the library of Force Dimension is not there; get their SDK at forcedimension.com/software/sdk and "
                             "install its libdhd.so, or name it: dhd:/opt/sdk/lib/libdhd.so");
    Dhd dhd;
    file.find(dhd.open, "dhdOpen");
    file.find(dhd.close, "dhdClose");
    file.find(dhd.enable_force, "dhdEnableForce");
    file.find(dhd.place, "dhdGetPosition");
    file.find(dhd.push, "dhdSetForce");
    file.find(dhd.buttons, "dhdGetButtonMask");
    file.find(dhd.why, "dhdErrorGetLastStr");
    return dhd;
}

// A separate thread, because each call waits for the USB.
class DhdTurns {
public:
    DhdTurns(const Dhd& dhd, char id, ArmTalk& talk) : dhd_(dhd), id_(id), talk_(talk), thread_([this] { run(); }) {}
    ~DhdTurns() {
        ended_ = true;
        thread_.join();
        dhd_.push(0, 0, 0, id_);
        dhd_.enable_force(kOff, id_);
        dhd_.close(id_);
    }
    DhdTurns(const DhdTurns&) = delete;
    DhdTurns& operator=(const DhdTurns&) = delete;

private:
    void run() noexcept {
        while (!ended_ && !talk_.gone()) {
            const auto begun = std::chrono::steady_clock::now();
            double x = 0, y = 0, z = 0;
            const bool told = dhd_.place(&x, &y, &z, id_) >= 0;
            const auto can_be = [](double metres) { return std::abs(metres) <= kForceDimensionMostReach; };
            if (told && can_be(x) && can_be(y) && can_be(z))
                talk_.tell({{1000 * y, 1000 * z, 1000 * x}, dhd_.buttons(id_), false});
            const bool zero = talk_.lets_go();
            const Point3 force = talk_.force();
            if (!told || dhd_.push(force.z, force.x, force.y, id_) < 0) talk_.lose();
            if (zero) talk_.has_let_go();
            std::this_thread::sleep_until(begun + kForceDimensionPace);
        }
    }

    Dhd dhd_;
    char id_;
    ArmTalk& talk_;
    std::atomic<bool> ended_{false};
    std::thread thread_;  // the last, as it needs the others
};

class ForceDimensionArm : public TalkedArm {
public:
    explicit ForceDimensionArm(const std::string& path) : dhd_(dhd_of(path)) { open(); }
    bool reopen(std::string& why) override {
        why.clear();
        turns_.reset();
        talk_.reset();
        try {
            open();
            return true;
        } catch (const Error&) {
            return false;  // not yet
        }
    }

private:
    [[noreturn]] void fail(const Phrase& what) const {
        const char* why = dhd_.why();
        throw Error(
            Fault::failed, "dhd",
            why != nullptr
                ? phrase("{0} ({1}); plug it in and switch it on, and look whether the SDK's own programs find it", what, why)
                : phrase("{0}; plug it in and switch it on, and look whether the SDK's own programs find it", what));
    }
    void open() {
        const int id = dhd_.open();
        if (id < 0) fail(phrase("no device is there"));
        if (dhd_.enable_force(kOn, static_cast<char>(id)) < 0) {
            dhd_.close(static_cast<char>(id));
            fail(phrase("the device gives no force"));
        }
        talk_ = std::make_unique<ArmTalk>();
        turns_ = std::make_unique<DhdTurns>(dhd_, static_cast<char>(id), *talk_);
    }

    Dhd dhd_;
    std::unique_ptr<DhdTurns> turns_;
};

std::unique_ptr<HapticDevice> open_dhd(const DeviceWish& wish) { return force_dimension_arm(wish.where); }

}  // namespace

std::unique_ptr<HapticDevice> force_dimension_arm(const std::string& library) {
    return std::make_unique<ForceDimensionArm>(library);
}

extern const DeviceKind dhd_device;
const DeviceKind dhd_device{.name = "dhd",
                            .address = "LIBRARY",
                            .example = "dhd:, dhd:/opt/sdk/lib/libdhd.so",
                            .real = true,
                            .axes = 3,
                            .open = open_dhd};

}  // namespace tactics
