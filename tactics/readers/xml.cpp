// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/xml.h"

#include <expat.h>

#include <cstring>
#include <memory>

#include "tactics/error.h"

namespace tactics {

namespace {

std::string without_prefix(std::string_view name) {
    const auto colon = name.rfind(':');
    return std::string(colon == std::string_view::npos ? name : name.substr(colon + 1));
}

struct Builder {
    XML_Parser parser = nullptr;
    std::vector<Element> open;  // from the document, which holds the root, to the innermost
    std::size_t elements = 0;
    std::size_t bytes = 0;  // of text and attributes, entities written out
    Phrase fault;           // an exception must not pass through C

    void refuse(const Phrase& why) {
        if (fault.empty()) fault = why;
        XML_StopParser(parser, XML_FALSE);
    }
    bool takes(std::size_t more) {
        bytes += more;
        if (bytes > kMostXmlBytes) refuse(phrase("its entities grow beyond 64 MB; save it without entities"));
        return bytes <= kMostXmlBytes;
    }
};

void begin(void* user, const XML_Char* name, const XML_Char** attributes) {
    auto& builder = *static_cast<Builder*>(user);
    if (++builder.elements > kMostElements)
        return builder.refuse(phrase("there are more than a million elements; divide the file"));
    if (builder.open.size() > kMostDepth) return builder.refuse(phrase("its groups are nested too deeply; ungroup some"));
    Element element;
    element.name = without_prefix(name);
    element.after = builder.open.back().text.size();
    element.line = static_cast<long>(XML_GetCurrentLineNumber(builder.parser));
    for (; attributes[0] != nullptr; attributes += 2) {
        if (!builder.takes(std::strlen(attributes[1]))) return;
        element.attributes.emplace_back(without_prefix(attributes[0]), attributes[1]);
    }
    builder.open.push_back(std::move(element));
}

void end(void* user, const XML_Char*) {
    auto& builder = *static_cast<Builder*>(user);
    if (builder.open.size() < 2) return;
    Element done = std::move(builder.open.back());
    builder.open.pop_back();
    builder.open.back().children.push_back(std::move(done));
}

void text(void* user, const XML_Char* bytes, int count) {
    auto& builder = *static_cast<Builder*>(user);
    if (builder.takes(static_cast<std::size_t>(count))) builder.open.back().text.append(bytes, static_cast<std::size_t>(count));
}

void comment(void* user, const XML_Char* bytes) {
    auto& builder = *static_cast<Builder*>(user);
    if (!builder.takes(std::strlen(bytes))) return;
    std::string& all = builder.open.back().comment;
    all += (all.empty() ? "" : "\n") + std::string(bytes);
}

}  // namespace

std::string_view Element::attribute(std::string_view attribute_name) const {
    for (const auto& [own, value] : attributes)
        if (own == attribute_name) return value;
    return {};
}

Element parse_xml(std::string_view bytes, const std::string& file) {
    if (bytes.size() > kMostXmlBytes) throw Error(Fault::failed, file, phrase("this file is over 64 MB; simplify what is in it"));
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
    if (parser == nullptr) throw std::bad_alloc();
    Builder builder;
    builder.parser = parser.get();
    builder.open.emplace_back();
    XML_SetUserData(parser.get(), &builder);
    XML_SetElementHandler(parser.get(), begin, end);
    XML_SetCharacterDataHandler(parser.get(), text);
    XML_SetCommentHandler(parser.get(), comment);
    // Names are hashed with a salt that expat takes from the system by chance: under a known one a file could have thousands that
    // collide. Nothing that is read depends on it, as attributes and elements come in the order of the file.
    if (XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) != XML_STATUS_OK) {
        const std::string place = file + ":" + std::to_string(XML_GetCurrentLineNumber(parser.get()));
        if (!builder.fault.empty()) throw Error(Fault::failed, place, builder.fault);
        throw Error(Fault::failed, place,
                    phrase("this is not well-formed XML ({0}, column {1}); save the file again",
                           XML_ErrorString(XML_GetErrorCode(parser.get())),
                           std::to_string(XML_GetCurrentColumnNumber(parser.get()) + 1)));
    }
    return std::move(builder.open.front().children.front());
}

}  // namespace tactics
