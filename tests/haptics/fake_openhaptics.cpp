// SPDX-License-Identifier: Apache-2.0
// A library with the names of 3D Systems' libHD, for arm_libraries_test.cpp. As theirs it has a thread that calls back a thousand
// times a second; what is asked or told outside of a frame is a fault.
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace {

struct HdErrorInfo {
    unsigned code;
    int internal;
    unsigned device;
};

std::atomic<double> place_x{0}, place_y{0}, place_z{0}, force_x{0}, force_y{0}, force_z{0}, most{0};
std::atomic<int> there{1}, hot{0}, on{0}, opened{0}, pushes{0}, misuses{0};
std::atomic<unsigned> mask{0};
std::atomic<bool> running{false};
bool in_frame = false;  // of the thread of the scheduler
unsigned (*call)(void*) = nullptr;
void* call_data = nullptr;
std::thread* scheduler = nullptr;

constexpr unsigned kDevice = 7;

}  // namespace

extern "C" {

unsigned hdInitDevice(const char*) { return there != 0 ? (++opened, kDevice) : 0xFFFFFFFFu; }
void hdDisableDevice(unsigned device) { device == kDevice ? --opened : ++misuses; }
void hdMakeCurrentDevice(unsigned device) { misuses += device != kDevice; }
void hdEnable(unsigned what) { what == 0x4000 ? on = 1 : ++misuses; }
void hdBeginFrame(unsigned device) {
    misuses += device != kDevice || in_frame;
    in_frame = true;
}
void hdEndFrame(unsigned device) {
    misuses += device != kDevice || !in_frame;
    in_frame = false;
}
void hdGetDoublev(unsigned what, double* values) {
    misuses += what != 0x2050 || !in_frame;
    values[0] = place_x, values[1] = place_y, values[2] = place_z;
}
void hdGetIntegerv(unsigned what, int* values) {
    misuses += what != 0x2000 || !in_frame;
    *values = static_cast<int>(mask);
}
void hdSetDoublev(unsigned what, const double* values) {
    misuses += what != 0x2700 || !in_frame;
    force_x = values[0], force_y = values[1], force_z = values[2];
    ++pushes;
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(values[i]) <= most)) most = std::abs(values[i]);
}
HdErrorInfo hdGetError() { return {there == 0 ? 0x0302u : hot != 0 ? 0x0200u : 0u, 0, kDevice}; }
const char* hdGetErrorString(unsigned code) { return code == 0x0302 ? "HD_COMM_ERROR" : "HD_WARM_MOTORS"; }
unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* data, unsigned short) {
    call = callback;
    call_data = data;
    return 11;
}
void hdUnschedule(unsigned long handle) { misuses += handle != 11; }
void hdStartScheduler() {
    running = true;
    scheduler = new std::thread([] {
        bool goes_on = true;
        while (running) {
            if (goes_on) goes_on = call(call_data) == 1;
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
    });
}
void hdStopScheduler() {
    running = false;
    if (scheduler != nullptr) scheduler->join();
    delete scheduler;
    scheduler = nullptr;
}

// Of the test.
void fake_put(double x, double y, double z, unsigned buttons) { place_x = x, place_y = y, place_z = z, mask = buttons; }
void fake_unplug(int unplugged) { there = unplugged == 0 ? 1 : 0; }
void fake_heat(int warm) { hot = warm; }
void fake_told(double* force) { force[0] = force_x, force[1] = force_y, force[2] = force_z, force[3] = most; }
int fake_is_on() { return on; }
int fake_opened() { return opened; }
int fake_pushes() { return pushes; }
int fake_misuses() { return misuses; }
}
