// SPDX-License-Identifier: Apache-2.0
// The four people of the set: as different as faces are, all of them oval.
#include "samples/draw/face.h"
#include "samples/draw/scenes.h"

namespace tactics::samples {

namespace {

Image portrait(const Person& who, int size) {
    const Face face(who);
    Lamps lamps;
    lamps.key_from = who.light_from;
    lamps.key = {1.42f, 1.36f, 1.28f};
    lamps.sky = {0.44f, 0.47f, 0.52f};
    lamps.ground = {0.28f, 0.25f, 0.23f};
    lamps.rim = {0.30f, 0.32f, 0.36f};
    lamps.shadow = 5;
    lamps.reach = 1.6f;
    const Camera camera{{0, -0.16f, 9.5f}, {0, -0.18f, 0}, 5.2f};
    const March march(face, camera, lamps, 14);
    return develop(march.take(size * 4 / 5, size), {.gain = 0.9f, .vignette = 0.3f, .seed = who.seed});
}

}  // namespace

Image draw_face_anna(int size) {
    Person who;
    who.jaw = 0.50f;
    who.nose = 0.088f;
    who.lips = 1.15f;
    who.smile = 0.05f;
    who.brow = 0.044f;
    who.yaw = 0.16f;
    who.skin = paint(228, 192, 172);
    who.lip = paint(172, 88, 86);
    who.iris = paint(96, 112, 124);
    who.hair = paint(74, 44, 28);
    who.cloth = paint(70, 92, 114);
    who.style = Person::Hair::long_;
    who.wall = paint(178, 184, 176);
    who.seed = 11;
    return portrait(who, size);
}

Image draw_face_ben(int size) {
    Person who;
    who.jaw = 0.57f;
    who.length = 0.05f;
    who.nose = 0.115f;
    who.lips = 0.9f;
    who.smile = 0.01f;
    who.brow = 0.05f;
    who.yaw = -0.22f;
    who.skin = paint(210, 170, 148);
    who.lip = paint(166, 108, 100);
    who.iris = paint(92, 66, 40);
    who.hair = paint(48, 34, 26);
    who.cloth = paint(206, 204, 198);
    who.beard = 1;
    who.wall = paint(122, 142, 150);
    who.light_from = {0.6f, 0.5f, 0.65f};
    who.seed = 23;
    return portrait(who, size);
}

Image draw_face_clara(int size) {
    Person who;
    who.jaw = 0.53f;
    who.nose = 0.1f;
    who.lips = 0.95f;
    who.smile = 0.07f;
    who.brow = 0.044f;
    who.yaw = 0.05f;
    who.pitch = 0.03f;
    who.skin = paint(222, 188, 172);
    who.lip = paint(170, 94, 92);
    who.iris = paint(84, 96, 80);
    who.hair = paint(112, 108, 106);
    who.cloth = paint(112, 50, 58);
    who.style = Person::Hair::bun;
    who.glasses = true;
    who.wall = paint(186, 190, 188);
    who.light_from = {-0.35f, 0.6f, 0.8f};
    who.seed = 31;
    return portrait(who, size);
}

Image draw_face_david(int size) {
    Person who;
    who.jaw = 0.60f;
    who.length = 0.02f;
    who.nose = 0.125f;
    who.lips = 1.25f;
    who.smile = 0.03f;
    who.brow = 0.05f;
    who.yaw = -0.08f;
    who.skin = paint(132, 92, 72);
    who.lip = paint(120, 72, 66);
    who.iris = paint(54, 34, 22);
    who.hair = paint(30, 24, 22);
    who.cloth = paint(178, 156, 104);
    who.style = Person::Hair::bald;
    who.wall = paint(204, 200, 190);
    who.light_from = {-0.6f, 0.45f, 0.65f};
    who.seed = 47;
    return portrait(who, size);
}

}  // namespace tactics::samples
