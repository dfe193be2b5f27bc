// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/json.h"

#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace tactics::json_test {
namespace {

using namespace tests;

TEST(Json, EscapesWhatItMust) {
    EXPECT_EQ(json_text("a\"b\\c\n\x7f"), "\"a\\\"b\\\\c\\u000a\\u007f\"");
    EXPECT_EQ(json_text("\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\x88"), "\"\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\x88\"");
    EXPECT_EQ(json_text("\xc2\x9b"
                        "2J\xe2\x80\xae"),
              "\"\\u009b2J\\u202e\"");
    EXPECT_EQ(json_text("\xff"), "\"\\udcff\"");
    // Cut short, overlong, a surrogate, above U+10FFFF: none is UTF-8.
    EXPECT_EQ(json_text("\xe2\x82"), "\"\\udce2\\udc82\"");
    EXPECT_EQ(json_text("\xc0\x80"), "\"\\udcc0\\udc80\"");
    EXPECT_EQ(json_text("\xed\xa0\x80"), "\"\\udced\\udca0\\udc80\"");
    EXPECT_EQ(json_text("\xf4\x90\x80\x80"), "\"\\udcf4\\udc90\\udc80\\udc80\"");
}

TEST(Json, ObjectKeepsItsOrder) {
    JsonObject json;
    json.add("name", "x");
    json.add("size", 1.5);
    json.add_raw("all", json_array({"1", "\"a\""}));
    EXPECT_EQ(json.text(), "{\"name\":\"x\",\"size\":1.5,\"all\":[1,\"a\"]}");
}

// Every pair of bytes, as an independent reader gets it back.
TEST(Json, PythonGetsEveryNameBack) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    std::string lines;
    for (int a = 1; a < 256; ++a)
        for (int b = 1; b < 256; b += 3) lines += json_text(std::string{static_cast<char>(a), static_cast<char>(b), 'x'}) + "\n";
    const Folder folder;
    write_bytes(folder / "check.py",
                "import sys, json, os\n"
                "lines = iter(sys.stdin.buffer.read().splitlines())\n"
                "for a in range(1, 256):\n"
                "    for b in range(1, 256, 3):\n"
                "        assert json.loads(next(lines)).encode('utf-8', 'surrogateescape') == bytes([a, b, 120]), (a, b)\n");
    const Ending python = run_tool(folder, {"python3", "check.py"}, lines);
    EXPECT_EQ(python.code, 0) << python.err;
}

}  // namespace
}  // namespace tactics::json_test
