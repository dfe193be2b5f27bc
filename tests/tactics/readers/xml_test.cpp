// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/xml.h"

#include <gtest/gtest.h>

namespace tactics::xml_test {
namespace {

std::string told(const Element& element) {
    std::string text = element.name + "[" + element.text + "](";
    for (const auto& [name, value] : element.attributes) text += name + "=" + value + ";";
    for (const Element& child : element.children) text += told(child);
    return text + ")";
}

// Each parser hashes names with a salt of its own, by chance; what is read must not show it. The document has what expat keeps in
// tables by name: elements, attributes and their defaults, entities, prefixes.
TEST(Xml, IsReadTheSameWhateverTheSaltOfItsHashes) {
    std::string defaults, entities, body;
    for (int i = 0; i < 200; ++i) {
        const std::string number = std::to_string(i);
        defaults += "<!ATTLIST e" + std::to_string(i % 20) + " d" + number + " CDATA 'default" + number + "'>";
        entities += "<!ENTITY n" + number + " 'entity" + number + "'>";
        body += "<e" + std::to_string(i % 20) + " z" + number + "='1' a" + number + "='2' p:x" + number + "='3'>&n" + number +
                ";</e" + std::to_string(i % 20) + ">";
    }
    const std::string document = "<!DOCTYPE svg [" + defaults + entities + "]><svg xmlns:p='urn:p'>" + body + "</svg>";
    const std::string first = told(parse_xml(document, "first.svg"));
    EXPECT_NE(first.find("entity199"), std::string::npos);
    EXPECT_NE(first.find("default199"), std::string::npos);
    for (int again = 0; again < 20; ++again) ASSERT_EQ(told(parse_xml(document, "again.svg")), first);
}

}  // namespace
}  // namespace tactics::xml_test
