// SPDX-License-Identifier: Apache-2.0
// The Touch, the Phantom Omni and their kin of 3D Systems, through the maker's own library libHD, if the user has it. Its
// functions and numbers are declared here from its public documentation (3D Systems, "OpenHaptics Toolkit 3.5: API Reference
// Guide" and "Programmer's Guide"). Its axes are ours: x to the right, y up, z towards the user, in mm; it takes N. The library
// has its own thread that calls back a thousand times a second; only there, between hdBeginFrame and hdEndFrame, can a device be
// read and written. This has not been tried on a real device yet.
#include <cmath>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/arm_talk.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/transport/shared_library.h"

namespace tactics {

namespace {

// Its types: HHD, HDenum and HDerror are unsigned int, HDSchedulerHandle unsigned long, HDushort unsigned short.
constexpr unsigned kButtons = 0x2000;                              // HD_CURRENT_BUTTONS
constexpr unsigned kPosition = 0x2050;                             // HD_CURRENT_POSITION
constexpr unsigned kForce = 0x2700;                                // HD_CURRENT_FORCE
constexpr unsigned kForceOutput = 0x4000;                          // HD_FORCE_OUTPUT
constexpr unsigned kSuccess = 0;                                   // HD_SUCCESS
constexpr unsigned kNoHandle = 0xFFFFFFFF;                         // HD_INVALID_HANDLE
constexpr unsigned kOver = 0, kGoOn = 1;                           // HD_CALLBACK_DONE, HD_CALLBACK_CONTINUE
constexpr unsigned short kOpenhapticsPriority = 0xFFFF / 2;        // HD_DEFAULT_SCHEDULER_PRIORITY
constexpr unsigned kFirstOfForce = 0x0200, kLastOfForce = 0x02FF;  // errors: warm motors, too much force, too fast
constexpr double kOpenhapticsMostReach = 1000;                     // mm; the largest of them reaches 420

struct HdError {
    unsigned code = 0;
    int internal = 0;
    unsigned device = 0;
};

struct Hd {
    unsigned (*init)(const char* name) = nullptr;
    void (*disable_device)(unsigned device) = nullptr;
    void (*make_current)(unsigned device) = nullptr;
    void (*enable)(unsigned what) = nullptr;
    void (*begin_frame)(unsigned device) = nullptr;
    void (*end_frame)(unsigned device) = nullptr;
    void (*get_doubles)(unsigned what, double* values) = nullptr;
    void (*get_integers)(unsigned what, int* values) = nullptr;
    void (*set_doubles)(unsigned what, const double* values) = nullptr;
    HdError (*error)() = nullptr;
    const char* (*words)(unsigned code) = nullptr;
    unsigned long (*schedule)(unsigned (*call)(void*), void* data, unsigned short priority) = nullptr;
    void (*unschedule)(unsigned long call) = nullptr;
    void (*start)() = nullptr;
    void (*stop)() = nullptr;
};

Hd hd_of(const std::string& path) {
    const std::string names[] = {path.empty() ? "libHD.so.3.4" : path, path.empty() ? "libHD.so" : path};
    const SharedLibrary file(names, "openhaptics",
                             "the library of OpenHaptics is not there; get it and the driver of the device from 3D Systems "
                             "(support.3dsystems.com, \"OpenHaptics for Linux\"), or name it: openhaptics:/usr/lib/libHD.so");
    Hd hd;
    file.find(hd.init, "hdInitDevice");
    file.find(hd.disable_device, "hdDisableDevice");
    file.find(hd.make_current, "hdMakeCurrentDevice");
    file.find(hd.enable, "hdEnable");
    file.find(hd.begin_frame, "hdBeginFrame");
    file.find(hd.end_frame, "hdEndFrame");
    file.find(hd.get_doubles, "hdGetDoublev");
    file.find(hd.get_integers, "hdGetIntegerv");
    file.find(hd.set_doubles, "hdSetDoublev");
    file.find(hd.error, "hdGetError");
    file.find(hd.words, "hdGetErrorString");
    file.find(hd.schedule, "hdScheduleAsynchronous");
    file.find(hd.unschedule, "hdUnschedule");
    file.find(hd.start, "hdStartScheduler");
    file.find(hd.stop, "hdStopScheduler");
    return hd;
}

// A device that is open, from the library's own thread.
class HdTurns {
public:
    // Throws Error(failed): there is none.
    HdTurns(const Hd& hd, ArmTalk& talk) : hd_(hd), talk_(talk), device_(hd.init(nullptr)) {
        const HdError error = hd_.error();
        if (error.code != kSuccess || device_ == kNoHandle) fail(phrase("no device is there"), error);
        hd_.make_current(device_);
        hd_.enable(kForceOutput);
        call_ = hd_.schedule([](void* turns) { return static_cast<HdTurns*>(turns)->turn(); }, this, kOpenhapticsPriority);
        hd_.start();
        if (const HdError fault = hd_.error(); fault.code != kSuccess) {
            close();
            fail(phrase("the device does not start"), fault);
        }
    }
    ~HdTurns() { close(); }
    HdTurns(const HdTurns&) = delete;
    HdTurns& operator=(const HdTurns&) = delete;

private:
    [[noreturn]] void fail(const Phrase& what, const HdError& error) const {
        const char* why = hd_.words(error.code);
        throw Error(Fault::failed, "openhaptics",
                    why != nullptr
                        ? phrase("{0} ({1}); plug it in, and look whether the maker's Touch_Diagnostic finds it", what, why)
                        : phrase("{0}; plug it in, and look whether the maker's Touch_Diagnostic finds it", what));
    }
    // There are no more callbacks after the scheduler has stopped.
    void close() {
        talk_.let_go();
        hd_.stop();
        hd_.unschedule(call_);
        hd_.disable_device(device_);
    }

    unsigned turn() noexcept {
        if (talk_.gone()) return kOver;
        double place[3] = {NAN, NAN, NAN};
        int buttons = 0;
        hd_.begin_frame(device_);
        hd_.get_doubles(kPosition, place);
        hd_.get_integers(kButtons, &buttons);
        const bool zero = talk_.lets_go();
        const Point3 force = fault_ ? Point3{} : talk_.force();
        const double pushed[3] = {force.x, force.y, force.z};
        hd_.set_doubles(kForce, pushed);
        hd_.end_frame(device_);
        const unsigned code = hd_.error().code;
        const bool of_force = code >= kFirstOfForce && code <= kLastOfForce;
        if (code != kSuccess && !of_force) {
            talk_.lose();
            return kOver;
        }
        fault_ = of_force;
        const auto can_be = [](double mm) { return std::abs(mm) <= kOpenhapticsMostReach; };
        if (can_be(place[0]) && can_be(place[1]) && can_be(place[2]))
            talk_.tell({{place[0], place[1], place[2]}, static_cast<unsigned>(buttons), fault_});
        if (zero) talk_.has_let_go();
        return kGoOn;
    }

    Hd hd_;
    ArmTalk& talk_;
    unsigned device_;
    unsigned long call_ = 0;
    bool fault_ = false;  // of the last turn
};

class OpenHapticsArm : public TalkedArm {
public:
    explicit OpenHapticsArm(const std::string& path) : hd_(hd_of(path)) { open(); }
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
    void open() {
        talk_ = std::make_unique<ArmTalk>();
        turns_ = std::make_unique<HdTurns>(hd_, *talk_);
    }

    Hd hd_;
    std::unique_ptr<HdTurns> turns_;
};

std::unique_ptr<HapticDevice> open_openhaptics(const DeviceWish& wish) { return openhaptics_arm(wish.where); }

}  // namespace

std::unique_ptr<HapticDevice> openhaptics_arm(const std::string& library) { return std::make_unique<OpenHapticsArm>(library); }

extern const DeviceKind openhaptics_device;
const DeviceKind openhaptics_device{.name = "openhaptics",
                                    .address = "LIBRARY",
                                    .example = "openhaptics:, openhaptics:/usr/lib/libHD.so",
                                    .real = true,
                                    .axes = 3,
                                    .open = open_openhaptics};

}  // namespace tactics
