// SPDX-License-Identifier: Apache-2.0
// A library with the names of Force Dimension's, for arm_libraries_test.cpp: a device that is where it is put, and what it is
// told.
#include <atomic>

namespace {

std::atomic<double> place_x{0}, place_y{0}, place_z{0}, force_x{0}, force_y{0}, force_z{0}, most{0};
std::atomic<int> there{1}, on{0}, opened{0}, pushes{0};
std::atomic<unsigned> mask{0};

}  // namespace

extern "C" {

int dhdOpen() { return there != 0 ? (++opened, 3) : -1; }
int dhdClose(char id) { return id == 3 ? (--opened, 0) : -1; }
int dhdEnableForce(unsigned char value, char id) { return id == 3 ? (on = value, 0) : -1; }
int dhdGetPosition(double* x, double* y, double* z, char id) {
    *x = place_x, *y = place_y, *z = place_z;
    return id == 3 && there != 0 ? 0 : -1;
}
int dhdSetForce(double x, double y, double z, char id) {
    if (id != 3 || there == 0) return -1;
    force_x = x, force_y = y, force_z = z;
    ++pushes;
    for (const double one : {x, y, z})
        if (!(one <= most && one >= -most)) most = one < 0 ? -one : one;
    return 2;  // DHD_MOTOR_SATURATED
}
unsigned dhdGetButtonMask(char) { return mask; }
const char* dhdErrorGetLastStr() { return "no such device"; }

// Of the test.
void fake_put(double x, double y, double z, unsigned buttons) { place_x = x, place_y = y, place_z = z, mask = buttons; }
void fake_unplug(int unplugged) { there = unplugged == 0 ? 1 : 0; }
void fake_told(double* force) { force[0] = force_x, force[1] = force_y, force[2] = force_z, force[3] = most; }
int fake_is_on() { return on; }
int fake_opened() { return opened; }
int fake_pushes() { return pushes; }
}
