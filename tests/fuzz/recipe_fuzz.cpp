// SPDX-License-Identifier: Apache-2.0
// Any text as a recipe file: what is accepted can be saved and read back to the same.
#include <cstdint>
#include <cstdlib>

#include "filters/list.h"
#include "tactics/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    try {
        const std::string_view bytes =
            size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
        const Recipe recipe = parse_recipe(bytes, "fuzzed.recipe", filters());
        const std::string text = to_text(recipe);
        const Recipe again = parse_recipe(text, "fuzzed.recipe", filters());
        if (to_text(again) != text || again.steps.size() != recipe.steps.size()) std::abort();
        uses_colour(recipe);
        check(recipe);
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
