// SPDX-License-Identifier: Apache-2.0
// PDF/UA-1 (ISO 14289-1:2014) by the rules of veraPDF's profile (veraPDF-validation-profiles, PDF_UA/1, August 2025), each under
// its name there, on the objects that qpdf finds and on a reading of the contents that knows nothing of the writer.
#include "print/page_book.h"
#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::pdf_ua_test {
namespace {

using namespace rendered;

// Prints the rules that a file breaks. The third of the rules that speak of things that must not be there at all (annotations,
// forms, tables, lists, notes, other kinds of fonts ...) is one rule, "absent".
constexpr const char* kRules = R"py(
import base64, json, re, subprocess, sys, xml.etree.ElementTree as tree
path = sys.argv[1]
objects = json.loads(subprocess.check_output(['qpdf', '--json=2', '--json-stream-data=inline', '--decode-level=generalized', path]))['qpdf'][1]

broken = set()
def rule(name, holds):
    if not holds: broken.add(name)
def value(ref):
    while isinstance(ref, str) and re.fullmatch(r'\d+ \d+ R', ref): ref = objects['obj:' + ref]
    if isinstance(ref, dict) and 'value' in ref and len(ref) == 1: ref = value(ref['value'])
    return ref
def entries(ref):
    found = value(ref)
    return found['stream']['dict'] if isinstance(found, dict) and 'stream' in found else found
def data(ref): return base64.b64decode(value(ref)['stream']['data'])
head = open(path, 'rb').read(20)
rule('6-1-t01', re.match(rb'%PDF-1\.[0-7][\r\n]', head))
trailer = objects['trailer']['value']
root = entries(trailer['/Root'])
rule('7-16-t01', '/Encrypt' not in trailer)
rule('6-2-t01', root.get('/MarkInfo', {}).get('/Marked') is True)
rule('7-1-t04', root.get('/MarkInfo', {}).get('/Suspects') is not True)
rule('7-1-t10', root.get('/ViewerPreferences', {}).get('/DisplayDocTitle') is True)
rule('7-1-t08', '/Metadata' in root)
rule('7-1-t11', '/StructTreeRoot' in root)
tag = re.compile(r'[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*')
rule('7-2-t34', root.get('/Lang', '').startswith('u:'))  # and 21, 22, 23, 30 to 33
rule('7-2-t02', '/Outlines' not in root or '/Lang' in root)
everything = json.dumps(objects)
for name in ('/Annots', '/AcroForm', '/OCProperties', '/Encrypt', '/XFA', '/Type0', '/TrueType', '/Type1',
             '/RoleMap', '/Form', '/Ref', '/Table', '/TR', '/L', '/LI', '/TOC', '/TOCI', '/Note', '/Formula', '/H'):
    rule('absent ' + name, '"' + name + '"' not in everything)
for ref in objects:
    about = entries(ref) if ref.startswith('obj:') else None
    if isinstance(about, dict) and '/EF' in about: rule('7-11-t01', about.get('/F') and about.get('/UF'))
if '/Metadata' in root:
    meta = data(root['/Metadata']).decode()
    rule('7-1-t08', entries(root['/Metadata']).get('/Subtype') == '/XML' and '/Filter' not in entries(root['/Metadata']))
    description = tree.fromstring(meta[meta.index('?>') + 2:meta.rindex('<?')]).find('.//{http://www.w3.org/1999/02/22-rdf-syntax-ns#}Description')
    part = description.find('{http://www.aiim.org/pdfua/ns/id/}part')
    rule('5-t01', part is not None)
    rule('5-t02', part is not None and part.text == '1')
    rule('5-t03', 'pdfuaid:part' in meta)
    title = description.find('{http://purl.org/dc/elements/1.1/}title')
    said = ''.join(title.itertext()).strip() if title is not None else None
    rule('7-1-t09', said)
    info = entries(trailer['/Info'])
    rule('title', info.get('/Title') == 'u:' + str(said))
# The structure: every element with its page's content under it, each number once.
kStandard = {'/Document', '/H1', '/H2', '/P', '/Figure'}
owners, heading = {}, [0]
def walk(ref, parent):
    element = entries(ref)
    rule('7-1-t12', element.get('/P') == parent)
    kind = element['/S']
    rule('7-1-t05', kind in kStandard)
    if '/Lang' in element: rule('7-2-t29', tag.fullmatch(element['/Lang'][2:]))
    if kind == '/Figure':
        rule('7-3-t01', len(element.get('/Alt', '')) > 2 or '/ActualText' in element)
        rule('box', len(element.get('/A', {}).get('/BBox', [])) == 4)
    if re.fullmatch('/H[1-6]', kind):
        level = int(kind[2:])
        rule('7-4-2-t01', level <= heading[0] + 1)
        heading[0] = max(level, heading[0])
        heads.append(element)
    kids = element.get('/K', [])
    for kid in kids if isinstance(kids, list) else [kids]:
        if isinstance(kid, int):
            key = (element['/Pg'], kid)
            rule('once', key not in owners)
            owners[key] = ref
        else: walk(kid, ref)
heads = []
if '/StructTreeRoot' in root:
    top = entries(root['/StructTreeRoot'])
    walk(top['/K'], root['/StructTreeRoot'])
    rule('heading', heads)
    numbers = top['/ParentTree']['/Nums']
    rule('parents', {(i, n): r for i, rs in zip(numbers[::2], numbers[1::2]) for n, r in enumerate(rs)} ==
         {(entries(page)['/StructParents'], n): r for (page, n), r in owners.items()})
rule('7-2-t29', tag.fullmatch(root.get('/Lang', 'u:')[2:]))
# The contents: what draws is tagged or an artefact, and never both.
token = re.compile(rb'<<|>>|<[0-9A-Fa-f\s]*>|\([^)]*\)|\[|\]|/[^\s/<>\[\]()]*|[^\s/<>\[\]()]+')
kPaints = {b'f', b'F', b'f*', b'S', b's', b'B', b'B*', b'b', b'b*', b'Tj', b'TJ', b"'", b'"', b'Do', b'sh', b'EI'}
def read(page):
    content = entries(page)
    rule('7-18-3-t01', content.get('/Tabs') == '/S')
    fonts = {k.encode(): entries(f) for k, f in content['/Resources'].get('/Font', {}).items()}
    seen, open_marks, operands, font = set(), [], [], None
    for found in token.findall(data(content['/Contents'])):
        if found[:1] in b'/<([>]' or re.fullmatch(rb'[-+.\d]+', found):
            operands.append(found)
            continue
        artefact = any(kind == 'artefact' for kind, _ in open_marks)
        tagged = [number for kind, number in open_marks if kind == 'tag']
        if found == b'BDC':
            number = int(operands[operands.index(b'/MCID') + 1])
            rule('once', number not in seen)
            seen.add(number)
            rule('7-1-t02', not artefact)
            owner = owners.get((page, number))
            rule('7-1-t03', owner is not None)
            if owner: rule('same type', entries(owner)['/S'].encode() == operands[0])
            open_marks.append(('tag', number))
        elif found == b'BMC':
            rule('7-1-t01', operands[-1] != b'/Artifact' or not tagged)
            open_marks.append(('artefact' if operands[-1] == b'/Artifact' else 'other', None))
        elif found == b'EMC': open_marks.pop()
        elif found == b'Tf': font = fonts[operands[0]]
        elif found in kPaints:
            rule('7-1-t03', tagged or artefact)
            if found == b'Tj':
                codes = bytes.fromhex(operands[-1][1:-1].decode())
                rule('7-21-4-1-t01', font['/Subtype'] == '/Type3')
                names = font['/Encoding']['/Differences']
                glyphs = dict(zip(range(names[0], names[0] + len(names)), names[1:]))
                rule('7-21-8-t01', all(glyphs.get(code, '/.notdef') != '/.notdef' for code in codes))
                rule('7-21-4-1-t02', all(glyphs.get(code) in font['/CharProcs'] for code in codes))
                for code in codes:
                    width = float(data(font['/CharProcs'][glyphs[code]]).split()[0])
                    rule('7-21-5-t01', abs(width - font['/Widths'][code - font['/FirstChar']]) <= 1)
                rule('7-21-7-t01', '/ToUnicode' in font)
                if '/ToUnicode' in font:
                    unicode = {int(a, 16): b for a, b in re.findall(rb'<(\w\w)> <(\w+)>', data(font['/ToUnicode']).split(b'endcodespacerange')[1])}
                    rule('7-21-7-t01', all(code in unicode for code in codes))
                    rule('7-21-7-t02', not any(u in (b'0000', b'FEFF', b'FFFE') for u in unicode.values()))
        operands = []
    rule('balanced', not open_marks)
    rule('all there', seen == {number for owner, number in owners if owner == page})
for page in entries(root['/Pages'])['/Kids']: read(page)
print(' '.join(sorted(broken)) or 'all hold')
)py";

std::string broken_rules(const FileFolder& folder, const std::string& pdf) {
    return output_of(folder, "python3 " + folder.save("rules.py", kRules) + " " + folder.save("page.pdf", pdf));
}

Sheet german_sheet() {
    Sheet sheet = sheet_of("a5", "Größe & <mehr>");
    sheet.language = "de-AT";
    sheet.caption = "Ein Bild";
    return sheet;
}

TEST(PdfUa, PagesWithATitleKeepTheRulesThatVeraPdfChecks) {
    NEED_TOOL("qpdf");
    NEED_TOOL("python3");
    const FileFolder folder;
    Sheet sheet = german_sheet();
    EXPECT_EQ(broken_rules(folder, encode(lay_out(hard_drawing(), sheet), "pdf")), "all hold\n");
    EXPECT_EQ(broken_rules(folder, encode(lay_out(picture_drawing(60, 40), sheet), "pdf")), "all hold\n");
    sheet.print_title = false;  // told in braille, in two lines
    sheet.title = "A title that is longer than one line of braille on the sheet has room for";
    EXPECT_EQ(broken_rules(folder, encode(lay_out(hard_drawing(), sheet), "pdf")), "all hold\n");
    const Format& format = *find_format("pdf");
    const std::vector<Page> pages(3, lay_out(hard_drawing(), german_sheet()));
    EXPECT_EQ(broken_rules(folder, files_of(format, pages, Settings(format.options)).front()), "all hold\n");
    const auto book = book_of(format, Settings(format.options));
    for (const char* name : {"One", "Zwei <&>"}) book->add(pages, name);
    EXPECT_EQ(broken_rules(folder, book->finish("Alle")), "all hold\n");
}

// It claims nothing: no title is made up for it.
TEST(PdfUa, WithoutATitleNothingIsClaimed) {
    NEED_TOOL("qpdf");
    NEED_TOOL("python3");
    const FileFolder folder;
    Sheet sheet = german_sheet();
    sheet.title.clear();
    sheet.caption.clear();
    EXPECT_EQ(broken_rules(folder, encode(lay_out(hard_drawing(), sheet), "pdf")),
              "5-t01 5-t02 5-t03 7-1-t09 7-1-t10 heading title\n");
}

struct Damage {
    std::string from, to, rule;
};

// The rules can fail: each of these breaks one.
TEST(PdfUa, DamageIsSeen) {
    NEED_TOOL("qpdf");
    NEED_TOOL("fix-qdf");
    NEED_TOOL("python3");
    const FileFolder folder;
    const std::string pdf = folder.save("whole.pdf", encode(lay_out(hard_drawing(), german_sheet()), "pdf")),
                      open = folder.file("open.pdf");
    ASSERT_EQ(output_of(folder, "qpdf --qdf --object-streams=disable " + pdf + " " + open), "");
    const std::string whole = read_file(open);
    const std::vector<Damage> damages{{"/Marked true", "/Marked false", "6-2-t01"},
                                      {"/DisplayDocTitle true", "/DisplayDocTitle false", "7-1-t10"},
                                      {"<pdfuaid:part>1<", "<pdfuaid:part>2<", "5-t02"},
                                      {"/Metadata ", "/Metabata ", "7-1-t08"},
                                      {"/StructTreeRoot ", "/StructureTree ", "7-1-t11"},
                                      {"/S /H1", "/S /H2", "7-4-2-t01"},
                                      {"/S /P\n", "/S /Paragraph\n", "7-1-t05"},
                                      {"/Alt <", "/Old <", "7-3-t01"},
                                      {"/Lang (de-AT)", "/Lang (d_AT)", "7-2-t29"},
                                      {"/ToUnicode ", "/ToNothing ", "7-21-7-t01"},
                                      {"/Artifact BMC", "/Span BMC", "7-1-t03"},
                                      {"/MCID 0 ", "/MCID 7 ", "7-1-t03"},
                                      {"/Tabs /S", "/Tabs /R", "7-18-3-t01"}};
    for (const Damage& damage : damages) {
        std::string broken = whole;
        const std::size_t at = broken.find(damage.from);
        ASSERT_NE(at, std::string::npos) << damage.from;
        broken.replace(at, damage.from.size(), damage.to);
        ASSERT_EQ(std::system(("fix-qdf " + folder.save("broken.qdf", broken) + " >" + folder.file("fixed.pdf")).c_str()), 0);
        EXPECT_NE((" " + broken_rules(folder, read_file(folder.file("fixed.pdf")))).find(" " + damage.rule), std::string::npos)
            << damage.from << ": " << broken_rules(folder, read_file(folder.file("fixed.pdf")));
    }
}

}  // namespace
}  // namespace tactics::pdf_ua_test
