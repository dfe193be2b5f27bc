// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/tesseract.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "tactics/error.h"
#include "tactics/lettering/strip.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/child.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr ChildLimits kLimits{std::chrono::seconds(60), 8u << 20};

// ISO 639-1 to the names of Tesseract's data, which are those of ISO 639-2/T but for Chinese.
constexpr std::pair<std::string_view, std::string_view> kLanguages[] = {
    {"ar", "ara"}, {"bg", "bul"}, {"ca", "cat"}, {"cs", "ces"}, {"cy", "cym"}, {"da", "dan"},     {"de", "deu"},
    {"el", "ell"}, {"en", "eng"}, {"es", "spa"}, {"et", "est"}, {"fi", "fin"}, {"fr", "fra"},     {"ga", "gle"},
    {"he", "heb"}, {"hi", "hin"}, {"hr", "hrv"}, {"hu", "hun"}, {"id", "ind"}, {"is", "isl"},     {"it", "ita"},
    {"ja", "jpn"}, {"ko", "kor"}, {"lt", "lit"}, {"lv", "lav"}, {"nb", "nor"}, {"nl", "nld"},     {"nn", "nor"},
    {"no", "nor"}, {"pl", "pol"}, {"pt", "por"}, {"ro", "ron"}, {"ru", "rus"}, {"sk", "slk"},     {"sl", "slv"},
    {"sv", "swe"}, {"th", "tha"}, {"tr", "tur"}, {"uk", "ukr"}, {"vi", "vie"}, {"zh", "chi_sim"},
};

std::string package_of(std::string_view language) {
    std::string name = "tesseract-ocr-" + std::string(language);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

// A line of the table, cut at its tabs.
bool cells_of(std::string_view line, std::array<std::string_view, 12>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto tab = line.find('\t');
        cells[i] = line.substr(0, tab);
        if (tab == std::string_view::npos) return i + 1 == cells.size();
        line.remove_prefix(tab + 1);
    }
    return true;
}

// Shut in, for it reads what a stranger drew. Its data may lie elsewhere.
ChildAnswer asked(std::vector<std::string> words, std::string_view input) {
    CagedChild child;
    child.words = std::move(words);
    child.input = input;
    child.limits = kLimits;
    child.settings = {"OMP_THREAD_LIMIT=1"};
    if (const char* data = std::getenv("TESSDATA_PREFIX"); data != nullptr) child.readable = {data};
    return run_caged(child);
}

// The program is there and could not read: is it the data of the language that is missing?
Phrase why_not(const std::string& program, std::string_view language, const ChildAnswer& answer) {
    using End = ChildAnswer::End;
    if (answer.end == End::too_long) return phrase("tesseract took over a minute; read it with {0} leave", spelled("words"));
    if (answer.end == End::failed) {
        const ChildAnswer list = asked({program, "--list-langs"}, "");
        const std::string known = "\n" + list.out + "\n";
        if (list.end == End::done && known.find("\n" + std::string(language) + "\n") == std::string::npos)
            return phrase("tesseract has no data to read \"{0}\"; install {1}", language, package_of(language));
    }
    return answer.fault.empty() ? phrase("tesseract failed; read it with {0} leave", spelled("words"))
                                : phrase("tesseract failed: {0}; read it with {1} leave", answer.fault, spelled("words"));
}

}  // namespace

std::string_view tesseract_language(std::string_view tag) {
    std::string language;
    for (const char c : tag.substr(0, tag.find('-'))) language += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (language == "zh" && (tag.find("Hant") != std::string_view::npos || tag.find("TW") != std::string_view::npos))
        return "chi_tra";
    for (const auto& [own, name] : kLanguages)
        if (own == language || (name == language && name.size() == 3)) return name;
    return {};
}

std::vector<Guess> parse_guesses(std::string_view table, std::size_t pages) {
    std::vector<Guess> guesses(pages);
    while (!table.empty()) {
        const auto end = table.find('\n');
        const std::string_view line = table.substr(0, end);
        table.remove_prefix(end == std::string_view::npos ? table.size() : end + 1);
        std::array<std::string_view, 12> cells;
        if (!cells_of(line, cells) || cells[0] != "5") continue;  // 5: a word
        const auto page = parse_number(cells[1]), sureness = parse_number(cells[10]);
        const std::string word = to_line(cells[11]);
        if (!page || !sureness || !(*page >= 1) || !(*page <= static_cast<double>(pages)) || word.empty()) continue;
        Guess& guess = guesses[static_cast<std::size_t>(*page) - 1];
        const double sure = std::clamp(*sureness, 0.0, 100.0);
        guess.sureness = guess.text.empty() ? sure : std::min(guess.sureness, sure);
        guess.text += (guess.text.empty() ? "" : " ") + word;
    }
    return guesses;
}

Guesses read_strips(const std::vector<Image>& strips, std::string_view tag, const std::string& program) {
    Guesses answer;
    if (strips.empty()) return answer;
    const std::string_view language = tesseract_language(tag);
    if (language.empty()) {
        answer.trouble =
            phrase("what tesseract calls the language \"{0}\" is not known; name another with {1}", tag, spelled("language"));
        return answer;
    }
    // Each strip is a page with one line (--psm 7). One thread: a batch has a picture at work on each core already.
    const ChildAnswer child =
        asked({program, "-", "-", "-l", std::string(language), "--psm", "7", "--dpi", "300", "tsv"}, tiff_of(strips));
    if (child.end == ChildAnswer::End::done) {
        answer.guesses = parse_guesses(child.out, strips.size());
    } else if (child.end == ChildAnswer::End::missing) {
        answer.trouble =
            phrase("to read it the program tesseract is needed and missing; install tesseract-ocr and {0}", package_of(language));
    } else {
        answer.trouble = why_not(program, language, child);
    }
    return answer;
}

}  // namespace tactics
