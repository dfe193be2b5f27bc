// SPDX-License-Identifier: Apache-2.0
// eBraille 1.0 packages: the rules of the specification, checked by Python's zipfile and XML reader, and by EPUBCheck if it
// is there.
#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::ebrl_test {
namespace {

using namespace rendered;

Page page_in(const std::string& title, const std::string& table, const std::string& words = "",
             const std::string& language = "en") {
    Sheet sheet = sheet_of("a4", title);
    sheet.braille_table = table;
    sheet.description = words;
    sheet.language = language;
    return lay_out(hard_drawing(), sheet);
}

std::vector<Page> pages() {
    return {page_in("Sail boat & <sun>", "en-ueb-g2.ctb"), page_in("", ""), page_in("Haus", "de-g1.ctb", "", "de-AT"),
            page_in("Haus", "de-g1.ctb", "Ein Haus mit \"Baum\"", "de"),
            lay_out(picture_drawing(60, 40), sheet_of("a5", "Dots"))};
}

// In brackets: sections of eBraille 1.0 (14 August 2025), and of EPUB 3.3 after an E.
constexpr const char* kRules = R"py(
import re, sys, zipfile, xml.etree.ElementTree as tree
path = sys.argv[1]
book = zipfile.ZipFile(path)
assert book.testzip() is None
first = book.infolist()[0]
raw = open(path, 'rb').read()
# [E 4.3.2] mimetype comes first, is stored, and has no extra field.
assert first.filename == 'mimetype' and first.compress_type == zipfile.ZIP_STORED and raw[28:30] == b'\0\0'
assert raw[30:58] == b'mimetypeapplication/epub+zip', raw[:60]
names = book.namelist()
assert len(names) == len(set(names))
# [4.2] package.opf and index.html stand in the root; [E 4.2.6.3.1] container.xml names the package.
container = tree.fromstring(book.read('META-INF/container.xml'))
roots = [e.get('full-path') for e in container.iter('{urn:oasis:names:tc:opendocument:xmlns:container}rootfile')]
assert roots == ['package.opf'] and 'index.html' in names
opf, dc, html = '{http://www.idpf.org/2007/opf}', '{http://purl.org/dc/elements/1.1/}', '{http://www.w3.org/1999/xhtml}'
package = tree.fromstring(book.read('package.opf'))
assert package.tag == opf + 'package' and package.get('version') == '3.0'
assert [e.tag for e in package] == [opf + 'metadata', opf + 'manifest', opf + 'spine']
meta = package.find(opf + 'metadata')
texts = lambda name: [e.text for e in meta.findall(dc + name)]
props = lambda name: [e.text for e in meta.findall(opf + 'meta') if e.get('property') == name]
# [5.3.3] what must be there, how often, in which form.
assert all(e.text and e.text.strip() for e in meta)
assert props('a11y:brailleCellType')[0] in ('6', '8', '6, 8', '8, 6') and len(props('a11y:brailleCellType')) == 1
assert len(props('a11y:brailleSystem')) >= 1
assert props('a11y:completeTranscription') in (['true'], ['false'])
# What only the user knows is there as it was told, or not at all, and never made up; the files have the day of the book.
told = [texts('creator'), props('a11y:producer'), texts('date'), props('dcterms:modified'), props('dcterms:dateCopyrighted')]
if len(sys.argv) > 2:
    creator, producer, day, year = sys.argv[2:]
    assert told == [[creator], [producer], [day], [day + 'T00:00:00Z'], [year]], told
    assert re.fullmatch(r'\d{4}(-\d\d(-\d\d)?)?', year)
    assert {i.date_time for i in book.infolist()} == {tuple(map(int, day.split('-'))) + (0, 0, 0)}
else:
    assert told == [[]] * 5, told
    assert {i.date_time for i in book.infolist()} == {(1980, 1, 1, 0, 0, 0)}
assert len(texts('title')) >= 1
assert texts('format') == ['eBraille 1.0']
ids = [e for e in meta.findall(dc + 'identifier') if e.get('id') == package.get('unique-identifier')]
assert len(ids) == 1 and re.fullmatch(r'urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}', ids[0].text)
assert texts('language') and all(re.fullmatch(r'[a-z]{2,3}-Brai(-[A-Z]{2})?', tag) for tag in texts('language')), texts('language')
graphics = props('a11y:tactileGraphics')
assert len(graphics) == 1 and set(graphics[0].split(', ')) <= {'JPG', 'PNG', 'SVG', 'PDF'}
# [5.4] the manifest lists all there is, and nothing else; [3.4] no fallbacks.
items = {i.get('id'): i for i in package.find(opf + 'manifest')}
hrefs = [i.get('href') for i in items.values()]
assert sorted(hrefs + ['mimetype', 'META-INF/container.xml', 'package.opf']) == sorted(names), (hrefs, names)
assert all(i.get('fallback') is None for i in items.values())
types = {i.get('href').rsplit('.')[-1]: i.get('media-type') for i in items.values()}
assert types['svg'] == 'image/svg+xml' and types['pdf'] == 'application/pdf' and types['html'] == 'application/xhtml+xml'
for kind in graphics[0].split(', '):
    assert any(h.endswith('.' + kind.lower()) for h in hrefs)
# [5.5, 6.1] the spine has XHTML alone; [8.2] the entry page is not in it.
spine = [items[r.get('idref')] for r in package.find(opf + 'spine')]
assert spine and all(i.get('media-type') == 'application/xhtml+xml' and i.get('href') != 'index.html' for i in spine)
nav = [i for i in items.values() if i.get('properties') == 'nav']
assert [i.get('href') for i in nav] == ['index.html']
# [8.2] the entry page names the package, [8.3.1] and has one table of contents, whose links lead somewhere.
index = tree.fromstring(book.read('index.html'))
links = [(l.get('href'), l.get('type')) for l in index.iter(html + 'link') if l.get('rel') == 'publication']
assert links == [('package.opf', 'application/oebps-package+xml')]
tocs = [n for n in index.iter(html + 'nav') if n.get('{http://www.idpf.org/2007/ops}type') == 'toc']
assert len(tocs) == 1 and tocs[0].get('role') == 'doc-toc' and [e.tag for e in tocs[0]] == [html + 'ol']
assert all(a.get('href') in names for a in tocs[0].iter(html + 'a'))
# [6.2.1] text that is rendered is braille; [6.2.3] no scripts, no forms.
allowed = re.compile('[\u2800-\u28ff\t\n\r \u00a0\u00ad]*')
for name in [n for n in names if n.endswith('.html')]:
    page = tree.fromstring(book.read(name))
    assert re.fullmatch(r'[a-z]{2,3}-Brai(-[A-Z]{2})?', page.get('{http://www.w3.org/XML/1998/namespace}lang'))
    for e in page.iter():
        assert e.tag not in (html + 'script', html + 'form')
        for text in (e.text, e.tail, e.get('alt'), e.get('aria-label')):
            assert allowed.fullmatch(text or ''), (name, text)
        if e.tag == html + 'img':
            assert 'ebraille/' + e.get('src') in names and e.get('alt')
# The drawing itself, and the volume: at most 40 cells and 25 lines a page.
assert tree.fromstring(book.read('ebraille/drawing.svg')).tag == '{http://www.w3.org/2000/svg}svg'
assert book.read('ebraille/drawing.pdf').startswith(b'%PDF-')
brf = book.read('ebraille/description.brf')
assert brf.endswith(b'\f') and all(32 <= c < 96 or c in b'\r\n\f' for c in brf)
for sheet in brf[:-1].split(b'\f'):
    lines = sheet.split(b'\r\n')
    assert len(lines) <= 26 and all(len(line) <= 40 for line in lines), lines
# The volume says what the page says.
cells = lambda text: ''.join(c for c in text if '\u2801' <= c <= '\u283f')
kLetters = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)="
page = tree.fromstring(book.read('ebraille/page.html'))
body = [e for e in page.iter() if e.tag in (html + 'h1', html + 'h2', html + 'p')][:-1]
assert cells(''.join(e.text for e in body)) == cells(''.join(chr(0x2800 + kLetters.index(c)) for c in brf.decode() if c not in '\r\n\f'))
print('languages', *texts('language'), 'systems', ', '.join(props('a11y:brailleSystem')))
)py";

TEST(Ebrl, KeepsTheRulesOfTheSpecification) {
    NEED_TOOL("python3");
    const FileFolder folder;
    const std::string script = folder.save("rules.py", kRules);
    const std::vector<std::string> expected{"languages en-Brai systems UEB grade2", "languages en-Brai systems UEB grade2",
                                            "languages de-Brai-AT de-Brai systems de-g1", "languages de-Brai systems de-g1",
                                            "languages en-Brai systems UEB grade2"};
    const std::vector<Page> all = pages();
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(output_of(folder, "python3 " + script + " " + folder.save("book.ebrl", encode(all[i], "ebrl"))),
                  expected[i] + "\n");
}

TEST(Ebrl, SaysWhatItWasToldAndTheFilesHaveItsDay) {
    NEED_TOOL("python3");
    const FileFolder folder;
    const std::string book = folder.save(
        "book.ebrl",
        encode(pages()[0], "ebrl",
               {{"creator", "Käthe & <Söhne>"}, {"producer", "Library"}, {"date", "2104-02-29"}, {"copyright", "987"}}));
    EXPECT_EQ(output_of(folder,
                        "python3 " + folder.save("rules.py", kRules) + " " + book + " 'Käthe & <Söhne>' Library 2104-02-29 0987"),
              "languages en-Brai systems UEB grade2\n");
}

TEST(Ebrl, AsksForWhatItWasNotTold) {
    const Format& format = *find_format("ebrl");
    Settings settings(format.options);
    const auto asks = [&] { return format.untold(settings); };
    for (const char* option : {"creator", "producer", "date", "copyright"})
        EXPECT_NE(asks().find("ebrl." + std::string(option) + "="), std::string::npos) << asks();
    settings.set("creator", "A", "test", "ebrl");
    settings.set("date", "1980-01-01", "test", "ebrl");
    EXPECT_EQ(asks().find("creator"), std::string::npos);
    EXPECT_EQ(asks().find("date"), std::string::npos);
    EXPECT_NE(asks().find("the producer and the year of copyright, "), std::string::npos) << asks();
    settings.set("producer", "B", "test", "ebrl");
    settings.set("copyright", "2020", "test", "ebrl");
    EXPECT_EQ(asks(), "");
}

TEST(Ebrl, HoldsAllPagesOfADocument) {
    NEED_TOOL("python3");
    NEED_TOOL("unzip");
    const FileFolder folder;
    const std::vector<Page> all{page_in("Haus", "de-g1.ctb", "", "de"), page_in("Haus, zwei", "de-g1.ctb", "", "de")};
    const Format& format = *find_format("ebrl");
    const auto books = files_of(format, all, Settings(format.options));
    ASSERT_EQ(books.size(), 1u);
    const std::string book = folder.save("book.ebrl", books[0]);
    EXPECT_EQ(output_of(folder, "python3 " + folder.save("rules.py", kRules) + " " + book), "languages de-Brai systems de-g1\n");
    const auto part = [&](const std::string& name) { return output_of(folder, "unzip -p " + book + " ebraille/" + name); };
    EXPECT_EQ(part("drawing.svg"), encode(all[0], "svg"));
    EXPECT_EQ(part("drawing-2.svg"), encode(all[1], "svg"));
    EXPECT_EQ(part("description.txt"), encode(all[0], "text") + "\f" + encode(all[1], "text"));
    EXPECT_NE(part("drawing.pdf").find("/Count 2 "), std::string::npos);
    EXPECT_NE(part("page.html").find("<img src=\"drawing-2.svg\""), std::string::npos);
}

TEST(Ebrl, IsTheSameBytesForTheSamePageAndAnotherBookForAnother) {
    const std::vector<Page> all = pages();
    EXPECT_EQ(encode(all[0], "ebrl"), encode(page_in("Sail boat & <sun>", "en-ueb-g2.ctb"), "ebrl"));
    EXPECT_NE(encode(all[0], "ebrl"), encode(all[1], "ebrl"));
}

TEST(Ebrl, HoldsTheSameDrawingAsTheFormatsAlone) {
    NEED_TOOL("unzip");
    const FileFolder folder;
    const Page page = pages()[0];
    const std::string book = folder.save("book.ebrl", encode(page, "ebrl"));
    int code = 0;
    const std::string said = output_of(folder, "unzip -t " + book, &code);
    EXPECT_EQ(code, 0) << said;
    for (const auto& [name, format] : {std::pair{"drawing.svg", "svg"}, {"drawing.pdf", "pdf"}, {"description.txt", "text"}})
        EXPECT_EQ(output_of(folder, "unzip -p " + book + " ebraille/" + name), encode(page, format)) << name;
}

// EPUBCheck knows EPUB, not eBraille: the five names of metadata that eBraille adds, and the ending of its pages, are all
// that it may find. Debian's epubcheck is a Java archive that a shell cannot start.
TEST(Ebrl, EpubcheckFindsNothingElse) {
    NEED_TOOL("java");
    const std::string jar = "/usr/share/java/epubcheck.jar";
    if (!std::filesystem::exists(jar)) GTEST_SKIP() << "epubcheck is not installed";
    const FileFolder folder;
    // The page with two languages and two braille systems.
    const std::string said = output_of(folder, "java -jar " + jar + " " + folder.save("book.epub", encode(pages()[2], "ebrl")));
    EXPECT_NE(said.find("EPUBCheck completed"), std::string::npos) << said;
    for (std::size_t at = 0; at < said.size();) {
        const std::size_t end = std::min(said.find('\n', at), said.size());
        const std::string line = said.substr(at, end - at);
        at = end + 1;
        if (!line.starts_with("ERROR") && !line.starts_with("WARNING") && !line.starts_with("FATAL")) continue;
        const bool known =
            line.find("Undefined property: \"a11y:") != std::string::npos || line.find("HTM-014a") != std::string::npos;
        EXPECT_TRUE(known) << line;
    }
}

}  // namespace
}  // namespace tactics::ebrl_test
