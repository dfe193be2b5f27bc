// SPDX-License-Identifier: Apache-2.0
// Any options of a print job, the first line, on a queue of any PPD file, the rest (ours if there is none): in every case, a job
// uses only parts of the program and of liblouis, and no file.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "cli/verbs/ppd.h"
#include "cli/verbs/print_options.h"
#include "filters/list.h"
#include "tactics/braille/braille.h"
#include "tactics/braille/tables.h"
#include "tactics/error.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

void check_queue(const Queue& queue, const PpdWords& ppd) {
    static const std::vector<std::string> kTables = braille_tables();
    const std::string& table = queue.wishes.sheet.braille_table;
    const bool told = ppd.choices.contains("TacticsBraille") && ppd.choices.at("TacticsBraille").contains(table);
    static const std::vector<BrailleTable> kDescribed = described_tables();
    const std::string& language = queue.wishes.sheet.language;
    const bool of_language = ppd.choices.contains("TacticsLanguage") && ppd.choices.at("TacticsLanguage").contains(language) &&
                             table == table_for_tag(language, kDescribed);
    require(table.empty() || table == Sheet{}.braille_table || of_language ||
            (told && std::find(kTables.begin(), kTables.end(), table) != kTables.end()));
    if (queue.wishes.chain.base) {
        const std::string text = to_text(*queue.wishes.chain.base);
        const auto recipes = named_recipes();
        require(std::any_of(recipes.begin(), recipes.end(), [&](const NamedRecipe& recipe) {
            return text == to_text(find_recipe(recipe.name, "fuzz")) &&
                   ppd.choices.at("TacticsRecipe").contains(std::string(recipe.name));
        }));
    }
    if (queue.wishes.paper) require(queue.wishes.paper->width >= 10 && queue.wishes.paper->height >= 10);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const PpdWords kOurs = parse_ppd(ppd_of(*find_format("index-v4"), "filter"));
    const std::string_view bytes = size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
    const auto end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view rest = bytes.substr(std::min(end + 1, bytes.size()));
    const PpdWords ppd = rest.empty() ? kOurs : parse_ppd(rest);
    try {
        check_queue(queue_of(ppd, "fuzz.ppd", parse_cups_options(bytes.substr(0, end))), ppd);
    } catch (const Error& error) {
        require(error.what()[0] != '\0');
    }
    return 0;
}
