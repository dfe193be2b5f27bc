// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactics {

namespace {

constexpr double kEndless = 1e9;

constexpr Texture kTextures[] = {
#define TEXTURE(...) {__VA_ARGS__},
#include "tactics/layout/textures.inc"
#undef TEXTURE
};

bool is_texture(int number) { return number >= 1 && number <= static_cast<int>(std::size(kTextures)); }
const Texture& at(int number) { return kTextures[number - 1]; }

// A dot has no direction, a line has, a dash somewhat less.
double lineness(const Texture& texture) { return texture.length == 0 ? 0 : texture.endless() ? 1 : 0.7; }
double step(const Texture& texture) { return texture.between_rows + texture.width; }

}  // namespace

std::span<const Texture> textures() { return kTextures; }

Phrase name_of_texture(int texture) { return is_texture(texture) ? phrase(at(texture).name) : phrase("a texture"); }

double difference(int texture, int other) {
    constexpr double kFromBlank = 3;
    if (texture == other) return 0;
    if (!is_texture(texture) || !is_texture(other)) return kFromBlank;
    const Texture &a = at(texture), &b = at(other);
    const double turn = std::abs(std::sin((a.degrees - b.degrees) * std::numbers::pi / 180));
    return std::abs(lineness(a) - lineness(b)) + turn * std::min(lineness(a), lineness(b)) +
           0.5 * std::abs(std::log2(step(a) / step(b)));
}

double share_black(int texture) {
    if (!is_texture(texture)) return 0;
    const Texture& t = at(texture);
    if (t.endless()) return t.width / step(t);
    const double mark = t.length * t.width + std::numbers::pi / 4 * t.width * t.width;
    return mark / (step(t) * (t.length + t.width + t.along_row));
}

}  // namespace tactics
