// SPDX-License-Identifier: Apache-2.0
#include "tactics/relief/read_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "tactics/error.h"
#include "tactics/readers/exr.h"
#include "tactics/readers/felt_file.h"
#include "tactics/readers/model.h"
#include "tactics/relief/found_heights.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kLeastPitch = 1e-3, kMostPitch = 1e3;  // mm
constexpr double kLeastRange = 1e-3;                    // mm: words in files have six decimals
constexpr double kMostHeight = 1e5;                     // mm from zero: mountains in a scale of 1:1 are no map for a finger
// Samples of 16 bits and 32-bit numbers must tell each other's heights exactly; 24 bits do while zero is no further away than
// this.
constexpr double kMostRanges = 100;

// What a message points to: a wish, or the file.
struct Origin {
    std::string place;
    Fault fault = Fault::usage;
};

Origin wished(std::string_view name) { return {spelled(name)}; }

[[noreturn]] void refuse(const Origin& origin, const Phrase& why) { throw Error(origin.fault, origin.place, why); }

Phrase mm(double value) { return phrase("{0} mm", numeral(value)); }

struct Range {
    double low = 0, high = 0;
};

void check_range(const Range& range, const HeightWish& wish, const std::string& name) {
    const Origin place = wish.high ? wished("high") : wish.low ? wished("low") : Origin{name, Fault::failed};
    if (!(range.high - range.low >= kLeastRange))
        refuse(place, phrase("the highest place, {0}, is not over the lowest, {1}, by {2} or more; give {3} and {4} in that "
                             "order, and {5} for a mould",
                             mm(range.high), mm(range.low), mm(kLeastRange), spelled("low"), spelled("high"), spelled("invert")));
    const double most = std::max(std::abs(range.low), std::abs(range.high));
    if (most > kMostHeight)
        refuse(place, phrase("heights may be up to {0} from zero, and these go to {1}; give a smaller {2} and {3}",
                             mm(kMostHeight), mm(most), spelled("low"), spelled("high")));
    if (most > kMostRanges * (range.high - range.low))
        refuse(place, phrase("heights from {0} to {1} are too near each other for so far from zero; give {2} 0 and a {3}",
                             mm(range.low), mm(range.high), spelled("low"), spelled("high")));
}

void check_pitch(double pitch, const Origin& place) {
    if (!(pitch >= kLeastPitch && pitch <= kMostPitch))
        refuse(place, phrase("a pitch of {0} is not from {1} to {2}; give {3} or {4} in these bounds", mm(pitch), mm(kLeastPitch),
                             mm(kMostPitch), spelled("pitch"), spelled("width")));
}

double pitch_of(const HeightWish& wish, const HeightWords& words, int columns, HeightFile& file) {
    if (wish.pitch && wish.width)
        refuse(wished("width"), phrase("give this or {0}: the samples are {1} across, so one says the other", spelled("pitch"),
                                       std::to_string(columns)));
    if (wish.pitch) return *wish.pitch;
    if (wish.width) return *wish.width / columns;
    if (words.pitch) return *words.pitch;
    if (words.resolution_pitch > 0) {
        file.notes.push_back(phrase("pitch {0} from the file's resolution; change with {1} or {2}", mm(words.resolution_pitch),
                                    spelled("pitch"), spelled("width")));
        return words.resolution_pitch;
    }
    file.notes.push_back(phrase("it tells no pitch: {0}, a pixel of a screen, is taken; say what it is with {1} or {2}",
                                mm(kPixelPitch), spelled("pitch"), spelled("width")));
    return kPixelPitch;
}

void check_decimals(FoundHeights& found, const std::string& name, HeightFile& file) {
    float least = INFINITY;
    std::size_t wrong = 0;
    for (const float value : found.values) {
        if (std::isfinite(value))
            least = std::min(least, value);
        else
            ++wrong;
    }
    if (wrong == 0) return;
    if (wrong == found.values.size()) throw Error(Fault::failed, name, phrase("no sample is a number; write the map again"));
    for (float& value : found.values)
        if (!std::isfinite(value)) value = least;
    file.notes.push_back(
        phrases(wrong, "{0} sample is no number and counts as the lowest", "{0} samples are no numbers and count as the lowest"));
}

// Converts the file's heights of black and white to those that the user wants.
void set_heights(FoundHeights& found, const HeightWish& wish, const std::string& name, HeightFile& file) {
    const bool told = found.words.black && found.words.white;
    Range from{0, 1}, to;
    if (found.decimal) {
        check_decimals(found, name, file);
        const auto [least, most] = std::minmax_element(found.values.begin(), found.values.end());
        from = told ? Range{*found.words.black, *found.words.white} : Range{*least, *most};
        // Level ground has no range of its own.
        if (!told && from.high - from.low < kLeastRange) from.high = from.low + 1;
        if (told && !(from.high - from.low >= kLeastRange))
            throw Error(Fault::failed, name, phrase("says that its highest place is not over its lowest; write the map again"));
        to = {wish.low.value_or(from.low), wish.high.value_or(from.high)};
        if (!told && !wish.low && !wish.high)
            file.notes.push_back(phrase("it tells no unit: its numbers are taken as mm; say what they are with {0} and {1}",
                                        spelled("low"), spelled("high")));
    } else {
        const double low = wish.low.value_or(told ? *found.words.black : 0);
        to = {low, wish.high.value_or(told ? *found.words.white : low + kPictureHeight)};
        if (!told && !wish.high)
            file.notes.push_back(phrase("it tells no heights: black is {0} and white {1}; say what they are with {2} and {3}",
                                        mm(to.low), mm(to.high), spelled("low"), spelled("high")));
    }
    check_range(to, wish, name);
    const double scale = (to.high - to.low) / (from.high - from.low);
    for (float& value : found.values) {
        double height = from.low == to.low && from.high == to.high ? static_cast<double>(value)
                                                                   : to.low + (static_cast<double>(value) - from.low) * scale;
        height = std::clamp(height, to.low, to.high);
        value = static_cast<float>(wish.invert ? to.low + to.high - height : height);
    }
    file.low = to.low;
    file.high = to.high;
}

// Pictures of all other kinds, by their lightness.
FoundHeights picture_heights(Source& source, const HeightWords& words, HeightFile& file) {
    const PictureInfo info = inspect_picture(source);
    check_height_count(source.name, info.width, info.height);
    const Image image = to_grey(read_picture(source, {}));
    FoundHeights found{image.width, image.height, {}, false, words, info.format + " picture"};
    found.values.reserve(image.pixels.size());
    for (const std::uint8_t pixel : image.pixels) found.values.push_back(static_cast<float>(pixel) / 255);
    if (found.words.pitch && found.words.black)
        file.notes.push_back(phrase("it was a height map of 16 bits and is none any more: 256 steps of height are left"));
    return found;
}

// All metadata of the file are in its head.
FoundHeights heights_of_felt_file(Source& source) {
    const LevelMap map = read_levels(source, kMostHeights);
    FoundHeights found{map.columns, map.rows, {}, false, {map.pitch, map.low, map.high}, ".felt file"};
    found.values.reserve(map.levels.size());
    const double rise = map.rise / (map.high - map.low);
    for (const Level level : map.levels) found.values.push_back(static_cast<float>(std::min(1.0, rise * level)));
    return found;
}

// Nothing: it is a picture; `words` has its metadata on heights.
std::optional<FoundHeights> find_heights(Source& source, HeightWords& words, HeightFile& file) {
    std::array<unsigned char, 8> head{};
    std::rewind(source.file.get());
    const std::size_t got = std::fread(head.data(), 1, head.size(), source.file.get());
    std::rewind(source.file.get());
    using namespace std::string_view_literals;
    const std::string_view start(reinterpret_cast<const char*>(head.data()), got);
    if (start == "\x89PNG\r\n\x1a\n"sv) {
        if (auto found = read_png_heights(source)) return found;
        words = png_height_words(source);
        return std::nullopt;
    }
    if (start.starts_with("II*\0"sv) || start.starts_with("MM\0*"sv) || start.starts_with("II+\0"sv) ||
        start.starts_with("MM\0+"sv)) {
        if (auto found = read_tiff_heights(source)) return found;
        words = tiff_height_words(source);
        return std::nullopt;
    }
    if (!start.starts_with("\x76\x2F\x31\x01"sv)) return std::nullopt;
    constexpr std::array<std::string_view, 3> kKeys{kPitchWord, kBlackWord, kWhiteWord};
    DecimalPicture picture = read_exr(source, kKeys, kMostHeights);
    FoundHeights found{picture.width, picture.height, std::move(picture.samples), true, {}, "EXR"};
    for (const auto& [key, text] : picture.words) found.words.take(key, text);
    if (!picture.grey) file.notes.push_back(phrase("it has several channels: the first is taken for heights"));
    return found;
}

HeightFile model_heights(Source& source, std::string_view format, std::optional<UpAxis> up, const ModelWish& model_wish) {
    HeightFile file;
    file.format = format;
    const Triangles triangles = triangles_of(source, file.notes, up);
    const ModelBox box = box_of(triangles);
    const HeightWish wish = model_wish(box);
    if (!(box.size(0) > 0 && box.size(1) > 0))
        throw Error(Fault::failed, source.name,
                    phrase("stands on its edge: seen from above there is nothing of it; lay it down"));
    const double pitch = wish.pitch.value_or(kModelPitch), scale = wish.width ? *wish.width / box.size(0) : 1;
    if (!wish.pitch)
        file.notes.push_back(phrase("a model has no pitch: {0} is taken; change with {1}", mm(pitch), spelled("pitch")));
    if (!wish.width)
        file.notes.push_back(has_unit(format)
                                 ? phrase("it is {0} wide; change with {1}", mm(box.size(0)), spelled("width"))
                                 : phrase("a model has no unit: its numbers are taken as mm, so it is {0} wide; change with {1}",
                                          mm(box.size(0)), spelled("width")));
    check_pitch(pitch, wished("pitch"));
    const double columns = depth_columns(box, scale, pitch), rows = depth_rows(box, scale, pitch);
    if (!(columns * rows <= static_cast<double>(kMostHeights)))
        throw Error(Fault::failed, source.name,
                    phrase("would be {0} x {1} samples; at most {2} million are made, take a larger {3} or a smaller {4}",
                           to_text(columns), to_text(rows), std::to_string(kMostHeights / 1'000'000), spelled("pitch"),
                           spelled("width")));
    file.map = depth_of(triangles, box, scale, pitch, source.name);
    // A flat model has a single height, but the map needs a range.
    const double tall = box.size(2) * scale >= kLeastRange ? box.size(2) * scale : 1, low = wish.low.value_or(0);
    const Range to{low, wish.high.value_or(low + tall)};
    check_range(to, wish, source.name);
    for (float& height : file.map.heights) {
        const double there =
            std::clamp(wish.high ? to.low + height * ((to.high - to.low) / tall) : to.low + height, to.low, to.high);
        height = static_cast<float>(wish.invert ? to.low + to.high - there : there);
    }
    file.low = to.low;
    file.high = to.high;
    return file;
}

}  // namespace

void check_height_count(const std::string& name, long long width, long long height) {
    if (width * height > kMostHeights)
        throw Error(Fault::failed, name,
                    phrase("has {0} x {1} samples; at most {2} million are read, make it smaller first", std::to_string(width),
                           std::to_string(height), std::to_string(kMostHeights / 1'000'000)));
}

namespace {

std::optional<HeightFile> read(Source& source, const HeightWish& wish, bool any_picture) {
    if (wish.width && !(*wish.width > 0 && *wish.width <= kMostHeight))
        refuse(wished("width"), phrase("{0} is not over 0 and at most {1}; give another", mm(*wish.width), mm(kMostHeight)));
    if (source.file == nullptr) throw Error(Fault::failed, source.name, phrase("is empty; get a complete copy of it"));
    if (const std::string_view model = model_format(source); !model.empty())
        return model_heights(source, model, std::nullopt, [&wish](const ModelBox&) { return wish; });
    HeightFile file;
    HeightWords words;
    std::optional<FoundHeights> found =
        is_felt(source) ? std::optional(heights_of_felt_file(source)) : find_heights(source, words, file);
    if (!found && !any_picture && !(words.black && words.white)) return std::nullopt;
    if (!found) found = picture_heights(source, words, file);
    file.format = found->format;
    file.map.columns = found->width;
    file.map.rows = found->height;
    file.map.pitch = pitch_of(wish, found->words, found->width, file);
    check_pitch(file.map.pitch, wish.pitch ? wished("pitch") : wish.width ? wished("width") : Origin{source.name, Fault::failed});
    set_heights(*found, wish, source.name, file);
    file.map.heights = std::move(found->values);
    return file;
}

}  // namespace

Phrase format_in_words(const std::string& format) {
    const auto before = [&](std::string_view end) { return format.substr(0, format.size() - end.size()); };
    if (format.ends_with(" picture")) return phrase("picture ({0})", before(" picture"));
    if (format.ends_with(" model")) return phrase("{0} model", before(" model"));
    if (format.starts_with("16-bit ")) return phrase("16-bit {0}", format.substr(7));
    if (format == "32-bit decimal TIFF") return phrase("32-bit decimal TIFF");
    if (format == ".felt file") return phrase(".felt file");
    if (format == "surface") return phrase("surface");
    if (format == "drawing") return phrase("drawing");
    return format;
}

HeightFile read_heights(Source& source, const HeightWish& wish) { return *read(source, wish, true); }

std::optional<HeightFile> read_told_heights(Source& source, const HeightWish& wish) { return read(source, wish, false); }

HeightFile read_model_heights(Source& source, std::optional<UpAxis> up, const ModelWish& wish) {
    return model_heights(source, model_format(source), up, wish);
}

HeightFile read_heights(const std::string& path, const HeightWish& wish) {
    Source source = open_source(path);
    return read_heights(source, wish);
}

}  // namespace tactics
