// SPDX-License-Identifier: Apache-2.0
// Chains of filters with random settings on tiny pictures: no crash, and the laws of artworks hold after each step.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/units.h"
#include "tests/filters/artwork_laws.h"

namespace {

using namespace tactics;

// Hands out the bytes of the input one after the other, then zeros.
struct Bytes {
    const std::uint8_t* data;
    std::size_t size;
    std::size_t at = 0;
    std::uint8_t next() { return at < size ? data[at++] : std::uint8_t{0}; }
    bool empty() const { return at >= size; }
};

Artwork picture_from(Bytes& bytes) {
    const int width = 1 + bytes.next() % 24, height = 1 + bytes.next() % 24;
    const std::uint8_t mode = bytes.next();
    Image image = make_image(width, height, (mode & 1) != 0 ? 3 : 1, 0.1 + 0.01 * bytes.next(), 0);
    // Few bytes make a whole picture: they are repeated with a shift, so that chains find texture, not only rows of zeros.
    std::vector<std::uint8_t> pattern;
    for (int i = 0; i < 16; ++i) pattern.push_back(bytes.next());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::uint8_t>(pattern[(i + i / static_cast<std::size_t>(width) * (mode >> 4)) % 16] +
                                                    ((mode & 2) != 0 ? i * 7 : 0));
    return image;
}

void randomise(Settings& settings, const Filter& filter, Bytes& bytes) {
    for (const Option& option : filter.options) {
        const std::uint8_t b = bytes.next();
        if (b < 96) continue;  // mostly the default
        if (option.type == Option::Type::choice) {
            const auto names = choice_names(option);
            settings.set(option.name, names[b % names.size()], "fuzz", filter.name);
            continue;
        }
        if (option.type == Option::Type::spots) {
            const int at = (b - 96) % 80;
            settings.set(option.name,
                         to_text(at) + "%,10%-" + to_text(at + 20) + "%,90%" + (option.choices == kBoxesOnly ? "" : ";50%,50%"),
                         "fuzz", filter.name);
            continue;
        }
        double value = option.min + (option.max - option.min) * (b - 96) / 159.0;
        if (option.type == Option::Type::whole) value = static_cast<double>(static_cast<long long>(value));
        settings.set(option.name, to_text(value), "fuzz", filter.name);
    }
}

std::size_t size_of(const Artwork& artwork) {
    if (const auto* image = std::get_if<Image>(&artwork)) return image->pixels.size();
    if (const auto* edges = std::get_if<EdgeMap>(&artwork)) return edges->strength.size();
    if (const auto* tree = std::get_if<RegionTree>(&artwork)) return tree->face.size();
    std::size_t points = 0;
    for (const auto& stroke : std::get<Drawing>(artwork).strokes) points += stroke.points.size();
    return points;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes{data, size};
    Artwork artwork = picture_from(bytes);
    std::string chain;
    for (int i = 0; i < 8 && !bytes.empty() && size_of(artwork) < 1u << 16; ++i) {
        // One of the filters that take what has come.
        std::vector<const Filter*> able;
        for (const Filter* filter : filters())
            if (contains(filter->takes, kind_of(artwork)) ||
                (kind_of(artwork) == Kind::edges && contains(filter->takes, Kind::picture)))
                able.push_back(filter);
        if (able.empty()) return 0;
        const Filter& filter = *able[bytes.next() % able.size()];
        // It makes a scene of any picture, which takes a second under sanitizers: seldom, or there is time for little else.
        if (filter.name == "nest" && bytes.next() % 8 != 0) continue;
        Recipe recipe;
        recipe.steps.push_back({&filter, Settings(filter.options), "fuzz"});
        randomise(recipe.steps[0].settings, filter, bytes);
        chain += std::string(filter.name) + " " + recipe.steps[0].settings.to_text() + "\n";
        const Kind given = contains(filter.takes, kind_of(artwork)) ? kind_of(artwork) : Kind::picture;
        try {
            artwork = run(recipe, std::move(artwork));
        } catch (const Error&) {
            return 0;  // a clear refusal
        }
        const std::string law = kind_of(artwork) == kind_after(filter, given) ? broken_law(artwork) : "not the kind it declares";
        if (!law.empty()) {
            std::fprintf(stderr, "%sgives %s\n", chain.c_str(), law.c_str());
            std::abort();
        }
    }
    return 0;
}
