// SPDX-License-Identifier: Apache-2.0
// A page in JSON: what an independent reader finds in it.
#include <gtest/gtest.h>

#include "print/format.h"
#include "tests/cli/tool.h"
#include "tests/rules/pages.h"

namespace tactics::json_test {
namespace {

using namespace tests;

TEST(JsonFormat, SaysWhatIsOnEachPage) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    Page page = blank_page();
    page.title = "A \"table\"";
    page.strokes.push_back({{{20, 20}, {80, 20}, {80, 60}, {20, 60}}, true, 1});
    page.regions.push_back(
        {"Top", "Table/Top", "seen from above", {{"kept", 2}}, {{{20, 20}, {80, 20}, {80, 60}, {20, 60}}}, {50, 40}});
    page.regions.push_back({"Pin", "Pin", "too small", {}, {}, {}});
    page.remarks.emplace_back("It is a test.");
    const Format& json = *find_format("json");
    const std::string text = json.encode_pages(std::vector<Page>{page, blank_page()}, Settings(json.options));
    const Folder folder;
    write_bytes(folder / "check.py", R"py(
import json, sys
first, second = json.load(sys.stdin)['pages']
assert first['title'] == 'A "table"' and first['page_width_mm'] > 0 and first['language'] == 'en', first
top, pin = first['objects']
assert top['counts'] == {'kept': 2} and top['drawn'] and (top['x_mm'], top['y_mm']) == (50, 40), top
assert (top['left_mm'], top['top_mm'], top['width_mm'], top['height_mm']) == (20, 20, 60, 40), top
assert pin == {'name': 'Pin', 'path': 'Pin', 'description': 'too small', 'drawn': False}, pin
assert 'It is a test.' in first['lines'] and 'Not drawn, too small: Pin.' in first['lines'], first
assert len(first['things']) == 1 and 'objects' not in second, second
)py");
    const Ending python = run_tool(folder, {"python3", "check.py"}, text);
    EXPECT_EQ(python.code, 0) << python.err << text;
}

}  // namespace
}  // namespace tactics::json_test
