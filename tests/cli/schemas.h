// SPDX-License-Identifier: Apache-2.0
// Answers of --json beside the files in cli/schemas/, by Debian's python3-jsonschema.
#pragma once

#include <string>
#include <string_view>

#include "tests/cli/tool.h"

namespace tactics::tests {

/// Is there a Python that can do it? For GTEST_SKIP.
inline bool has_json_schema() {
    const Folder folder;
    return run_tool(folder, {"python3", "-W", "ignore", "-c", "import jsonschema; jsonschema.Draft202012Validator"}).code == 0;
}

/// What is wrong with these lines, a line each; empty: they are what the file of that command says, and have no member that it
/// does not name. Whoever reads them must bear more, so the files allow it.
inline std::string schema_faults(std::string_view command, const std::string& lines) {
    const Folder folder;
    write_bytes(folder / "check.py", R"py(
import json, pathlib, sys
import jsonschema

def close(schema):
    if isinstance(schema, list):
        for each in schema: close(each)
    elif isinstance(schema, dict):
        if schema.get("type") == "object" and "properties" in schema: schema["additionalProperties"] = False
        for each in schema.values(): close(each)

def read(path):
    schema = json.load(open(path))
    jsonschema.Draft202012Validator.check_schema(schema)
    close(schema)
    return schema

folder = pathlib.Path(sys.argv[1]).parent
all_files = {file.as_uri(): read(file) for file in folder.glob("*.schema.json")}
schema = all_files[pathlib.Path(sys.argv[1]).as_uri()]
resolver = jsonschema.RefResolver(pathlib.Path(sys.argv[1]).as_uri(), schema, store=all_files)
validator = jsonschema.Draft202012Validator(schema, resolver=resolver)
for number, line in enumerate(sys.stdin, 1):
    value = json.loads(line, parse_constant=lambda name: sys.exit(f"line {number}: {name} is no JSON"))
    for fault in validator.iter_errors(value):
        print(f"line {number}: {fault.json_path}: {fault.message[:300]}")
)py");
    const std::string file = TACTICS_SOURCE_DIR "/cli/schemas/" + std::string(command) + ".schema.json";
    const Ending end = run_tool(folder, {"python3", "-W", "ignore", "check.py", file}, lines);
    return end.code == 0 ? end.out : end.out + end.err + "it could not be checked\n";
}

}  // namespace tactics::tests
