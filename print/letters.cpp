// SPDX-License-Identifier: Apache-2.0
#include "print/letters.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TACTICS_LEAKS_ARE_SOUGHT
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define TACTICS_LEAKS_ARE_SOUGHT
#endif
#ifdef TACTICS_LEAKS_ARE_SOUGHT
// Fontconfig keeps its configuration for the life of the program and links it by offsets, which the leak checker of
// sanitized builds does not recognise as pointers.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace tactics {

namespace {

constexpr const char* kFamily = "DejaVu Sans";
constexpr long kEm = 1000;

template <auto destroy>
struct Closer {
    template <typename T>
    void operator()(T* thing) const {
        destroy(thing);
    }
};
using Pattern = std::unique_ptr<FcPattern, Closer<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Closer<FcCharSetDestroy>>;
using Library = std::unique_ptr<FT_LibraryRec_, Closer<FT_Done_FreeType>>;
using Face = std::unique_ptr<FT_FaceRec_, Closer<FT_Done_Face>>;

// fontconfig reads its configuration and its lists of fonts when it is first asked, whichever thread that is.
std::mutex fontconfig_lock;

// Fontconfig reads the file that it is pointed at to its end, which a device may not have. One that is empty is a way to ask for
// no configuration.
void check_configuration() {
    const char* named = std::getenv("FONTCONFIG_FILE");
    struct stat facts {
    }, empty{};
    if (named == nullptr || stat(named, &facts) != 0 || S_ISREG(facts.st_mode) || S_ISDIR(facts.st_mode)) return;
    if (stat("/dev/null", &empty) == 0 && facts.st_rdev == empty.st_rdev) return;
    throw Error(Fault::failed, "FONTCONFIG_FILE", phrase("is a device, not a file of fontconfig; unset it"));
}

// The font nearest to kFamily that has `letters`, or nothing if there is no font at all.
Face open_face(FT_Library library, const std::vector<char32_t>& letters) {
    const std::lock_guard lock(fontconfig_lock);
    const Pattern wanted(FcPatternCreate());
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(kFamily));
    FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
    // A language is always set, or fontconfig takes it from the environment and the page would depend on it.
    FcPatternAddString(wanted.get(), FC_LANG, reinterpret_cast<const FcChar8*>("en"));
    if (!letters.empty()) {
        const CharSet set(FcCharSetCreate());
        for (const char32_t letter : letters) FcCharSetAddChar(set.get(), letter);
        FcPatternAddCharSet(wanted.get(), FC_CHARSET, set.get());
        FcPatternDel(wanted.get(), FC_FAMILY);
    }
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
    FcChar8* path = nullptr;
    int index = 0;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &path) != FcResultMatch) return {};
    FcPatternGetInteger(found.get(), FC_INDEX, 0, &index);
    FT_Face face = nullptr;
    if (FT_New_Face(library, reinterpret_cast<const char*>(path), index, &face) != 0) return {};
    Face opened(face);
    return FT_IS_SCALABLE(face) && face->units_per_EM > 0 ? std::move(opened) : Face();
}

// FreeType hands an outline over step by step, in font units.
class Tracer {
public:
    /// So many units are one em.
    explicit Tracer(long units) : units_(units) {}

    std::vector<OutlineStep> trace(FT_Outline& outline) {
        FT_Outline_Funcs steps{};
        steps.move_to = [](const FT_Vector* to, void* self) { return at(self).add(OutlineStep::Kind::move, {*to}); };
        steps.line_to = [](const FT_Vector* to, void* self) { return at(self).add(OutlineStep::Kind::line, {*to}); };
        steps.conic_to = [](const FT_Vector* middle, const FT_Vector* to, void* self) {
            // The cubic that is the same curve (degree elevation): its controls lie two thirds of the way to the middle.
            const auto third = [&](const FT_Vector& end) {
                return FT_Vector{(end.x + 2 * middle->x) / 3, (end.y + 2 * middle->y) / 3};
            };
            return at(self).add(OutlineStep::Kind::curve, {third(at(self).last_), third(*to), *to});
        };
        steps.cubic_to = [](const FT_Vector* one, const FT_Vector* two, const FT_Vector* to, void* self) {
            return at(self).add(OutlineStep::Kind::curve, {*one, *two, *to});
        };
        FT_Outline_Decompose(&outline, &steps, this);
        return std::move(steps_);
    }

    int scaled(FT_Pos value) const {
        const long twice = 2 * kEm * value;
        return static_cast<int>((twice + (value < 0 ? -units_ : units_)) / (2 * units_));
    }

private:
    static Tracer& at(void* self) { return *static_cast<Tracer*>(self); }

    int add(OutlineStep::Kind kind, std::initializer_list<FT_Vector> corners) {
        OutlineStep& step = steps_.emplace_back();
        step.kind = kind;
        LetterCorner* to = step.corners;
        for (const FT_Vector& corner : corners) *to++ = {scaled(corner.x), scaled(corner.y)};
        last_ = *(corners.end() - 1);
        return 0;
    }

    long units_;
    FT_Vector last_{};
    std::vector<OutlineStep> steps_;
};

void load(FT_Face face, char32_t code, Letter& letter) {
    // In font units and without hinting, which would bend shapes to one resolution's pixels.
    if (FT_Load_Char(face, code, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) return;
    Tracer tracer(face->units_per_EM);
    letter.advance = tracer.scaled(face->glyph->metrics.horiAdvance);
    letter.outline = tracer.trace(face->glyph->outline);
}

// As it stands on a screen; `units` are 64ths of a pixel.
void load_bent(FT_Face face, char32_t code, bool light, long units, Letter& letter) {
    if (FT_Load_Char(face, code, FT_LOAD_NO_BITMAP | (light ? FT_LOAD_TARGET_LIGHT : FT_LOAD_TARGET_NORMAL)) != 0) return;
    Tracer tracer(units);
    letter.advance = tracer.scaled(face->glyph->metrics.horiAdvance);
    letter.outline = tracer.trace(face->glyph->outline);
}

}  // namespace

std::map<char32_t, Letter> letters_of(const Page& page) {
    std::map<char32_t, Letter> letters;
    for (const PrintLine& line : page.print)
        for (std::string_view rest = line.text; !rest.empty();) {
            const char32_t code = take_letter(rest);
            if (code != kNoLetter) letters[code].advance = kEm / 2;
        }
    if (letters.empty()) return letters;
    check_configuration();
    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened) != 0) return letters;
    const Library library(opened);
    const Face face = open_face(library.get(), {});
    std::vector<char32_t> missing;
    for (auto& [code, letter] : letters) {
        if (face) load(face.get(), code, letter);
        if (!face || FT_Get_Char_Index(face.get(), code) == 0) missing.push_back(code);
    }
    const Face second = missing.empty() ? Face() : open_face(library.get(), missing);
    for (const char32_t code : missing)
        if (second && FT_Get_Char_Index(second.get(), code) != 0) load(second.get(), code, letters[code]);
    return letters;
}

namespace {

using FontSet = std::unique_ptr<FcFontSet, Closer<FcFontSetDestroy>>;
using ObjectSet = std::unique_ptr<FcObjectSet, Closer<FcObjectSetDestroy>>;

struct FontFile {
    std::string path;
    int index = 0;
    auto operator<=>(const FontFile&) const = default;
};

FontFile file_of(FcPattern* pattern) {
    FcChar8* path = nullptr;
    FontFile file;
    if (FcPatternGetString(pattern, FC_FILE, 0, &path) != FcResultMatch) return {};
    FcPatternGetInteger(pattern, FC_INDEX, 0, &file.index);
    file.path = reinterpret_cast<const char*>(path);
    return file;
}

// A font, and the one that formulas in it take their letters from; that is empty where it is not known.
struct FontPair {
    FontFile font, formulas;
};

FontFile file_for(const std::string& name) {
    const Pattern wanted(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
    if (!wanted) return {};
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
    return found ? file_of(found.get()) : FontFile();
}

// The names that drawing programs and TeX write, plain, bold and slanted, each with that of its formulas or none.
std::vector<std::pair<std::string, std::string>> likely_names() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const std::string style : {"", ":bold", ":italic", ":bold:italic"}) {
        for (const std::string family :
             {"DejaVu Sans", "Helvetica", "Times", "sans-serif", "serif", "monospace", "Arial", "Times New Roman", "Courier",
              "DejaVu Serif", "DejaVu Sans Mono", "Latin Modern Sans", "Palatino"})
            names.emplace_back(family + style, style.empty() ? family + ":italic" : "");
        names.emplace_back("Latin Modern Roman" + style, style.empty() ? "Latin Modern Math" : "");
        if (style != ":italic") continue;
        // TeX has fonts of their own for small print, such as exponents and indices.
        for (const char* name : {"Latin Modern Math", "LM Roman 7", "LM Roman 8", "LM Roman 12"})
            names.emplace_back(name, "Latin Modern Math");
    }
    return names;
}

// The fonts that are found for likely names; then all others, by their paths. Each is looked for when it is first asked for: one
// of the first is mostly the right one, and a search goes through all fonts there are. A batch asks for each picture; fonts do
// not come and go meanwhile.
class LikelyFonts {
public:
    // Nothing: there are no more.
    const FontPair* at(std::size_t number) {
        const std::lock_guard lock(fontconfig_lock);
        for (; found_.size() <= number && asked_ < names_.size(); ++asked_)
            add({file_for(names_[asked_].first), names_[asked_].second.empty() ? FontFile() : file_for(names_[asked_].second)});
        if (found_.size() <= number && !others_) {
            others_ = true;
            for (FontFile& file : all_files()) add({std::move(file), {}});
        }
        return number < found_.size() ? &found_[number] : nullptr;
    }

private:
    static std::vector<FontFile> all_files() {
        const Pattern outlines(FcPatternCreate());
        FcPatternAddBool(outlines.get(), FC_OUTLINE, FcTrue);
        const ObjectSet facts(FcObjectSetBuild(FC_FILE, FC_INDEX, nullptr));
        std::vector<FontFile> files;
        if (const FontSet all(FcFontList(nullptr, outlines.get(), facts.get())); all)
            for (int i = 0; i < all->nfont; ++i) files.push_back(file_of(all->fonts[i]));
        std::sort(files.begin(), files.end());
        return files;
    }

    void add(FontPair pair) {
        if (!pair.font.path.empty() && seen_.insert(pair.font).second) found_.push_back(std::move(pair));
    }

    const std::vector<std::pair<std::string, std::string>> names_ = likely_names();
    std::size_t asked_ = 0;  // of them
    bool others_ = false;    // have been listed
    std::deque<FontPair> found_;
    std::set<FontFile> seen_;
};

Face open_file(FT_Library library, const FontFile& file) {
    FT_Face loaded = nullptr;
    if (file.path.empty() || FT_New_Face(library, file.path.c_str(), file.index, &loaded) != 0) return {};
    Face face(loaded);
    return FT_IS_SCALABLE(loaded) && loaded->units_per_EM > 0 ? std::move(face) : Face();
}

using Codes = std::vector<char32_t>;

// Opened when its letters are first asked for.
class OpenFont {
public:
    explicit OpenFont(FontPair files) : files_(std::move(files)) {}

    // `formula`: those that formulas slant come from the font for formulas.
    std::map<char32_t, Letter> letters(const Codes& codes, Hinting hinting, double pixels, bool formula) {
        open();
        std::map<char32_t, Letter> letters;
        const long units = std::lround(64 * pixels);
        const bool coded = formulas_ && FT_Get_Char_Index(formulas_.get(), slanted('x')) != 0;
        for (const Face* face : {&font_, &formulas_})
            if (*face && hinting != Hinting::none && FT_Set_Char_Size(face->get(), 0, units, 72, 72) != 0) return letters;
        for (const char32_t code : codes) {
            const bool slants = formula && formulas_ && slanted(code) != code;
            const char32_t drawn = slants && coded ? slanted(code) : code;
            FT_Face face = slants ? formulas_.get() : font_.get();
            if (!face || FT_Get_Char_Index(face, drawn) == 0) continue;
            if (hinting == Hinting::none)
                load(face, drawn, letters[code]);
            else
                load_bent(face, drawn, hinting == Hinting::light, units, letters[code]);
        }
        return letters;
    }

private:
    void open() {
        if (library_) return;
        FT_Library opened = nullptr;
        if (FT_Init_FreeType(&opened) != 0) return;
        library_.reset(opened);
        font_ = open_file(opened, files_.font);
        formulas_ = open_file(opened, files_.formulas);
    }

    FontPair files_;
    Library library_;
    Face font_, formulas_;  // closed before it
};

}  // namespace

void each_font(const std::function<bool(const FontLetters& font)>& goes_on) {
    constexpr std::size_t kMostFonts = 300;
    check_configuration();
    static LikelyFonts fonts;
    for (std::size_t number = 0; number < kMostFonts; ++number) {
        const FontPair* const pair = fonts.at(number);
        if (pair == nullptr) return;
        const auto open = std::make_shared<OpenFont>(*pair);
        FontLetters font;
        font.plain = [open](const Codes& codes, Hinting hinting, double pixels) {
            return open->letters(codes, hinting, pixels, false);
        };
        if (!pair->formulas.path.empty())
            font.formula = [open](const Codes& codes, Hinting hinting, double pixels) {
                return open->letters(codes, hinting, pixels, true);
            };
        if (!goes_on(font)) return;
    }
}

std::function<std::optional<double>(char32_t code)> letter_widths_of(std::string file) {
    // The face reads from the bytes until it is closed, before the library.
    struct Opened {
        std::string bytes;
        Library library;
        Face face;
    };
    const auto font = std::make_shared<Opened>();
    font->bytes = std::move(file);
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return {};
    font->library.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(font->bytes.data()),
                           static_cast<FT_Long>(font->bytes.size()), 0, &face) != 0)
        return {};
    font->face.reset(face);
    if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0) return {};
    return [font](char32_t code) -> std::optional<double> {
        const FT_UInt glyph = FT_Get_Char_Index(font->face.get(), code);
        if (glyph == 0 || FT_Load_Glyph(font->face.get(), glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) return std::nullopt;
        return static_cast<double>(font->face->glyph->metrics.horiAdvance) / font->face->units_per_EM;
    };
}

}  // namespace tactics
