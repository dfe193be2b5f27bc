// SPDX-License-Identifier: Apache-2.0
// A head and shoulders, one set of proportions for everybody and a page of differences for each person.
//
// The unit is half a head; the middle of the head is the origin, x to the viewer's right, y up, z towards the viewer.
#pragma once

#include "samples/draw/march.h"

namespace tactics::samples {

struct Person {
    float jaw = 0.55f;    ///< half the width of the jaw
    float length = 0;     ///< how much longer the lower face is
    float nose = 0.1f;    ///< radius of its tip
    float lips = 1;       ///< fullness
    float smile = 0.02f;  ///< how much the corners of the mouth rise
    float brow = 0.045f;  ///< half the thickness of the eyebrows
    float yaw = 0;        ///< head turned, radians
    float pitch = 0;
    Vec3 skin, lip, iris, hair, cloth;
    enum class Hair { long_, short_, bun, bald } style = Hair::short_;
    float beard = 0;  ///< 0 none, 1 full
    bool glasses = false;
    Vec3 wall;  ///< behind
    Vec3 light_from{-0.55f, 0.55f, 0.7f};
    int seed = 1;
};

class Face {
public:
    explicit Face(const Person& person) : who_(person), turn_(person.yaw, person.pitch) {}
    float distance(Vec3 p) const;
    Surface surface(Vec3 p, Vec3 normal) const;
    Vec3 behind(float x, float y, Vec3 ray) const;

private:
    enum class Part { skin, eye, hair, cloth, frame };
    struct Near {
        float distance;
        Part part;
    };
    Near nearest(Vec3 p) const;
    float head(Vec3 q) const;
    float features(Vec3 q, float d) const;
    float ears(Vec3 m, float d) const;
    float beard_at(Vec3 q) const;
    float hair(Vec3 q) const;
    float body(Vec3 p) const;
    float spectacles(Vec3 q) const;
    Surface eye(Vec3 q) const;
    Surface skin(Vec3 q) const;
    Surface strands(Vec3 q) const;

    Person who_;
    Turn turn_;
};

}  // namespace tactics::samples
