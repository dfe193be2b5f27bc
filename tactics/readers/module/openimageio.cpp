// SPDX-License-Identifier: Apache-2.0
// The module's side: OpenImageIO behind the C border of openimageio.h.
#include "tactics/readers/module/openimageio.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/module/heif.h"

struct TacticsOiioPicture {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    int channels = 0;  // that are read, from the first
    OIIO::TypeDesc type;
    float gamma = 1.0f;  // of decimal numbers that are not linear
};

namespace {

void say(char* why, size_t why_size, const std::string& text) {
    std::snprintf(why, why_size, "%s", text.empty() ? "its data end too early or make no sense" : text.c_str());
}

bool is_decimal(OIIO::TypeDesc type) {
    return type.basetype == OIIO::TypeDesc::HALF || type.basetype == OIIO::TypeDesc::FLOAT ||
           type.basetype == OIIO::TypeDesc::DOUBLE;
}

// Some plugins hand out straight alpha without saying so.
bool keeps_alpha_straight(const OIIO::ImageSpec& spec, std::string_view format) {
    if (spec.get_int_attribute("oiio:UnassociatedAlpha") != 0) return true;
    constexpr std::string_view kSilent[] = {"bmp", "ico"};
    return std::find(std::begin(kSilent), std::end(kSilent), format) != std::end(kSilent);
}

// OpenImageIO puts R, G, B and A first where a file has them; anything else (depth, layers, luminance with chroma) is
// shown by its first channel.
TacticsOiioFacts facts_of(const OIIO::ImageSpec& spec, std::string_view format) {
    TacticsOiioFacts facts{};
    facts.width = spec.width;
    facts.height = spec.height;
    // GIF calls its last channel of four the fifth.
    const int alpha = spec.alpha_channel >= spec.nchannels ? spec.nchannels - 1 : spec.alpha_channel;
    const bool has_alpha = alpha == 1 || alpha == 3;
    facts.colours = (has_alpha ? alpha : spec.nchannels) >= 3 ? 3 : 1;
    if (has_alpha) facts.alpha = keeps_alpha_straight(spec, format) ? 1 : 2;
    facts.linear = is_decimal(spec.format) ? 1 : 0;
    facts.orientation = spec.get_int_attribute("Orientation", 1);
    constexpr int kRows = 16;
    facts.batch = spec.tile_height > 0 ? spec.tile_height : kRows;
    return facts;
}

TacticsOiioPicture* open(const char* format, const char* path, TacticsOiioFacts* facts, char* why, size_t why_size) {
    try {
        auto picture = std::make_unique<TacticsOiioPicture>();
        const bool heif = std::string_view(format) == "heif";
        picture->input = heif ? heif_input() : OIIO::ImageInput::create(format);
        if (!picture->input) {
            say(why, why_size, heif ? "this program was built without libheif" : OIIO::geterror());
            return nullptr;
        }
        picture->input->threads(1);
        OIIO::ImageSpec wish;
        wish.attribute("oiio:UnassociatedAlpha", 1);  // alpha is laid over white here, without a detour by premultiplying
        if (!picture->input->open(path, picture->spec, wish)) {
            say(why, why_size, picture->input->geterror());
            return nullptr;
        }
        const auto& spec = picture->spec;
        if (spec.deep || spec.depth > 1 || spec.nchannels < 1) {
            say(why, why_size, "it is not a flat picture");
            return nullptr;
        }
        *facts = facts_of(spec, format);
        picture->channels = facts->colours + (facts->alpha != 0 ? 1 : 0);
        picture->type = facts->linear != 0 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
        const float gamma = spec.get_float_attribute("oiio:Gamma", 1.0f);
        if (facts->linear != 0 && gamma > 0.1f && gamma < 10.0f) picture->gamma = gamma;
        return picture.release();
    } catch (const std::exception& error) {
        say(why, why_size, error.what());
    } catch (...) {
        say(why, why_size, {});
    }
    return nullptr;
}

// Radiance files may say that they were written with a gamma.
void make_linear(float* samples, int rows, const TacticsOiioPicture& picture) {
    const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(picture.spec.width) *
                              static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < count; ++i) samples[i] = std::pow(std::max(samples[i], 0.0f), picture.gamma);
}

int read(TacticsOiioPicture* picture, int first, int end, void* rows, char* why, size_t why_size) {
    try {
        const auto& spec = picture->spec;
        const int top = spec.y + first, bottom = spec.y + end;
        const bool good = spec.tile_width > 0 ? picture->input->read_tiles(0, 0, spec.x, spec.x + spec.width, top, bottom, spec.z,
                                                                           spec.z + 1, 0, picture->channels, picture->type, rows)
                                              : picture->input->read_scanlines(0, 0, top, bottom, spec.z, 0, picture->channels,
                                                                               picture->type, rows);
        if (good) {
            if (picture->gamma != 1.0f) make_linear(static_cast<float*>(rows), end - first, *picture);
            return 1;
        }
        say(why, why_size, picture->input->geterror());
    } catch (const std::exception& error) {
        say(why, why_size, error.what());
    } catch (...) {
        say(why, why_size, {});
    }
    return 0;
}

void close(TacticsOiioPicture* picture) {
    try {
        delete picture;
    } catch (...) {  // nothing was written, so nothing is lost
    }
}

int word(TacticsOiioPicture* picture, const char* name, char* text, size_t size) {
    try {
        const auto* found = picture->spec.find_attribute(name, OIIO::TypeDesc::STRING);
        if (found == nullptr) return 0;
        std::snprintf(text, size, "%s", found->get_string().c_str());
        return 1;
    } catch (...) {  // as if it were not there
    }
    return 0;
}

int write(const char* format, const TacticsOiioPlan* plan, char* why, size_t why_size) {
    try {
        const auto output = OIIO::ImageOutput::create(format);
        if (!output) {
            say(why, why_size, OIIO::geterror());
            return 0;
        }
        output->threads(1);
        OIIO::ImageSpec spec(plan->width, plan->height, 1, OIIO::TypeDesc::FLOAT);
        spec.channelnames = {"Y"};
        spec.attribute("compression", "zip");
        // The plugin puts in the time of day if it is told none, and the same heights are to be the same bytes.
        spec.attribute("DateTime", "1970:01:01 00:00:00");
        for (int i = 0; i < plan->word_count; ++i) spec.attribute(plan->words[i].name, plan->words[i].text);
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOVecOutput memory(bytes);
        bool good = output->set_ioproxy(&memory) && output->open("memory.exr", spec);
        for (int y = 0; good && y < plan->height; ++y)
            good = output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, plan->row(plan->user, y));
        good = good && output->close();
        if (good) plan->take(plan->user, bytes.data(), bytes.size());
        if (!good) say(why, why_size, output->geterror());
        return good ? 1 : 0;
    } catch (const std::exception& error) {
        say(why, why_size, error.what());
    } catch (...) {
        say(why, why_size, {});
    }
    return 0;
}

}  // namespace

extern "C" const TacticsOiio* tactics_oiio_2(void) {
    // Once, before any picture: one thread a picture, since the program runs one picture a core; and no claim of a size
    // that the program would refuse.
    static const bool kReady = [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);  // the calling thread alone
        OIIO::attribute("limits:imagesize_MB", 4096);
        OIIO::attribute("limits:channels", 64);
        return true;
    }();
    static const TacticsOiio kFunctions{open, read, close, word, write};
    return kReady ? &kFunctions : nullptr;
}
