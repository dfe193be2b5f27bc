// SPDX-License-Identifier: Apache-2.0
// The program `tactics-openimageio`: OpenImageIO with the frames of protocol.h.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/caged/heif.h"
#include "tactics/readers/caged/serving.h"

namespace {

using namespace tactics::caged;

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
Facts facts_of(const OIIO::ImageSpec& spec, std::string_view format) {
    Facts facts;
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

struct Picture {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    Facts facts;
};

Picture open_picture(const std::string& format) {
    Picture picture;
    const bool heif = format == "heif";
    picture.input = heif ? heif_input() : OIIO::ImageInput::create(format);
    if (!picture.input) fail(heif ? "this program was built without libheif" : OIIO::geterror());
    picture.input->threads(1);
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // alpha is laid over white by the program, without a detour by premultiplying
    if (!picture.input->open(kFilePath, picture.spec, wish)) fail(picture.input->geterror());
    const auto& spec = picture.spec;
    if (spec.deep || spec.depth > 1 || spec.nchannels < 1) fail("it is not a flat picture");
    picture.facts = facts_of(spec, format);
    return picture;
}

void put_facts(const Picture& picture) { put(Frame::facts, &picture.facts, sizeof picture.facts); }

void put_words(const Picture& picture, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        const auto* found = picture.spec.find_attribute(key, OIIO::TypeDesc::STRING);
        const std::string text = found != nullptr ? found->get_string() : std::string();
        put(Frame::word, text.data(), text.size());
    }
}

// Radiance files may say that they were written with a gamma.
void make_linear(float* samples, std::size_t count, float gamma) {
    for (std::size_t i = 0; i < count; ++i) samples[i] = std::pow(std::max(samples[i], 0.0f), gamma);
}

void put_rows(Picture& picture) {
    const auto& spec = picture.spec;
    const Facts& facts = picture.facts;
    const int channels = facts.colours + (facts.alpha != 0 ? 1 : 0),
              batch = std::clamp(facts.batch, 1, std::max(facts.height, 1));
    const bool linear = facts.linear != 0;
    const auto type = linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    const float gamma = spec.get_float_attribute("oiio:Gamma", 1.0f);
    const std::size_t row = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels);
    std::vector<float> samples((row * static_cast<std::size_t>(batch) * (linear ? sizeof(float) : 1) + 3) / sizeof(float));
    for (int first = 0; first < facts.height; first += batch) {
        const int end = std::min(first + batch, facts.height), top = spec.y + first, bottom = spec.y + end;
        const bool good = spec.tile_width > 0
                              ? picture.input->read_tiles(0, 0, spec.x, spec.x + spec.width, top, bottom, spec.z, spec.z + 1, 0,
                                                          channels, type, samples.data())
                              : picture.input->read_scanlines(0, 0, top, bottom, spec.z, 0, channels, type, samples.data());
        if (!good) fail(picture.input->geterror());
        const std::size_t count = row * static_cast<std::size_t>(end - first);
        if (linear && gamma > 0.1f && gamma < 10.0f && gamma != 1.0f) make_linear(samples.data(), count, gamma);
        put(Frame::rows, samples.data(), count * (linear ? sizeof(float) : 1));
    }
}

void write_file(const std::string& format, const std::vector<std::string>& words) {
    struct stat about {};
    if (fstat(kFile, &about) != 0 || about.st_size < static_cast<off_t>(sizeof(WritingPlan))) fail("its samples are not there");
    const auto size = static_cast<std::size_t>(about.st_size);
    const void* mapped = mmap(nullptr, size, PROT_READ, MAP_SHARED, kFile, 0);
    if (mapped == MAP_FAILED) fail("its samples cannot be read");
    WritingPlan plan;
    std::memcpy(&plan, mapped, sizeof plan);
    const auto* samples = reinterpret_cast<const float*>(static_cast<const char*>(mapped) + sizeof plan);
    const auto width = static_cast<std::size_t>(plan.width);
    if (plan.width < 1 || plan.height < 1 || size != sizeof plan + width * static_cast<std::size_t>(plan.height) * sizeof(float))
        fail("its samples are not all there");
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) fail(OIIO::geterror());
    output->threads(1);
    OIIO::ImageSpec spec(plan.width, plan.height, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Y"};
    spec.attribute("compression", "zip");
    // By default the plugin writes the time of day, but the same heights must give the same bytes.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) spec.attribute(words[i], words[i + 1]);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    bool good = output->set_ioproxy(&memory) && output->open("memory." + format, spec);
    for (int y = 0; good && y < plan.height; ++y)
        good = output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, samples + static_cast<std::size_t>(y) * width);
    if (!good || !output->close()) fail(output->geterror());
    put(Frame::file, bytes.data(), bytes.size());
}

void answer(const std::vector<std::string>& lines) {
    const std::string &verb = lines[1], &format = lines[2];
    const std::vector<std::string> rest(lines.begin() + 3, lines.end());
    if (verb == "write") return write_file(format, rest);
    Picture picture = open_picture(format);
    put_facts(picture);
    if (verb != "read") return;
    put_words(picture, rest);
    put_rows(picture);
}

// Once, before any picture: one thread a picture, since the program runs one picture a core; and no claim of a size that the
// program would refuse.
void settle_openimageio() {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);  // the calling thread alone
    OIIO::attribute("limits:imagesize_MB", 4096);
    OIIO::attribute("limits:channels", 64);
}

}  // namespace

int main() {
    settle_openimageio();
    serve_requests(answer);
}
