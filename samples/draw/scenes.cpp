// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/scenes.h"

#include <stdexcept>
#include <string>

namespace tactics::samples {

#define SCENE(function, name, title, photograph) Image function(int size);
#include "samples/draw/list.inc"
#undef SCENE

std::span<const Scene> scenes() {
    static constexpr Scene kScenes[] = {
#define SCENE(function, name, title, photograph) {name, title, photograph, function},
#include "samples/draw/list.inc"
#undef SCENE
    };
    return kScenes;
}

Image draw_scene(std::string_view name, int size) {
    for (const Scene& scene : scenes())
        if (scene.name == name) return scene.draw(size < 16 ? 16 : size);
    throw std::logic_error("no scene " + std::string(name));
}

}  // namespace tactics::samples
