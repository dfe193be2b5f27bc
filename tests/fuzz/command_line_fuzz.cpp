// SPDX-License-Identifier: Apache-2.0
// Any words after `tactics convert`: parsed and planned, without a disk. A plan that is accepted must hold together.
#include <cstdint>
#include <cstdlib>

#include "cli/command.h"
#include "cli/help/describe.h"
#include "cli/request.h"
#include "filters/list.h"
#include "tactics/error.h"
#include "tests/cli/fake_disk.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

void try_words(const std::vector<std::string>& words, const Disk& disk) {
    const Given given = parse_words(*find_command("convert"), words);
    const Request request = plan(given, disk);
    require(!request.items.empty());
    for (const Item& item : request.items) {
        require(!item.outputs.empty());
        for (const Output& output : item.outputs) {
            require(!output.path.empty());
            require(sheet_for(request, *output.format, item).medium != nullptr);
            request.settings_of(*output.format);
        }
    }
    if (!request.recipe) return;
    check(*request.recipe);
    const std::string text = to_text(*request.recipe);
    require(to_text(parse_recipe(text, "saved", filters())) == text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // One word a line, so that the corpus can be read and written by hand. No word holds a zero byte: none can reach main.
    std::vector<std::string> words{""};
    for (std::size_t i = 0; i < size; ++i) {
        if (data[i] == '\n' || data[i] == '\0')
            words.emplace_back();
        else
            words.back() += static_cast<char>(data[i]);
    }
    tests::FakeDisk fake;
    fake.folders = {"pages", "."};
    fake.files["own.recipe"] = words.front();
    try {
        try_words(words, fake.disk());
    } catch (const Error& error) {
        require(error.what()[0] != '\0');
    }
    try {
        describe_topic(words.front());
    } catch (const Error&) {
    }
    return 0;
}
