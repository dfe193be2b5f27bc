#include "tactics/transport/braille_reports.h"

#include <algorithm>
#include <optional>

namespace tactics {

namespace {

// HID Usage Tables 1.4, page 41h.
constexpr std::uint32_t kDisplay = 0x41'0001, kEightDots = 0x41'0003, kSixDots = 0x41'0004;
// HID 1.11, 6.2.2: type and tag of an item, the size left out.
enum Item : std::uint8_t {
    kInput = 0x80, kOutput = 0x90, kFeature = 0xB0, kCollection = 0xA0, kEnd = 0xC0,
    kUsagePage = 0x04, kReportSize = 0x74, kReportId = 0x84, kReportCount = 0x94, kPush = 0xA4, kPop = 0xB4,
    kUsage = 0x08, kUsageLeast = 0x18,
};
constexpr std::uint8_t kLongItem = 0xFE;
constexpr std::uint32_t kApplication = 1, kConstant = 1;
// As large as the kernel's own limits: 16 kB a report, 4 kB a descriptor. More is no display.
constexpr std::uint64_t kMostBits = 16'384 * 8;
constexpr std::size_t kMostPushed = 16, kMostItems = 4096;

struct Globals {
    std::uint32_t page = 0, size = 0, count = 0;
    int report = 0;
};

struct Field {
    BrailleReports::Line line;
    int columns = 0, dots = 0;
};

class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> descriptor) : rest_(descriptor) {}

    // False: it is broken.
    bool read() {
        for (std::size_t items = 0; !rest_.empty(); ++items) {
            const std::uint8_t prefix = rest_[0];
            if (items == kMostItems) return false;
            if (prefix == kLongItem) {
                if (rest_.size() < 2 || rest_.size() < 3u + rest_[1]) return false;
                rest_ = rest_.subspan(3u + rest_[1]);
                continue;
            }
            const std::size_t size = (prefix & 3) == 3 ? 4 : prefix & 3;
            if (rest_.size() < 1 + size) return false;
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(rest_[1 + i]) << 8 * i;
            rest_ = rest_.subspan(1 + size);
            if (!take(prefix & 0xFC, value, size)) return false;
        }
        return depth_ == 0;
    }
    std::vector<Field> fields;
    std::map<int, std::uint64_t> bits;  // of every output report
    bool numbered = false;

private:
    bool take(int item, std::uint32_t value, std::size_t size) {
        switch (item) {
            case kUsagePage: globals_.page = value; break;
            case kReportSize: globals_.size = value; break;
            case kReportCount: globals_.count = value; break;
            case kReportId:
                if (value == 0 || value > 255) return false;
                globals_.report = static_cast<int>(value);
                numbered = true;
                break;
            case kPush:
                if (pushed_.size() == kMostPushed) return false;
                pushed_.push_back(globals_);
                break;
            case kPop:
                if (pushed_.empty()) return false;
                globals_ = pushed_.back();
                pushed_.pop_back();
                break;
            // The first of several; one of four bytes names its page itself.
            case kUsage:
            case kUsageLeast:
                if (!usage_) usage_ = size == 4 ? value : globals_.page << 16 | value;
                break;
            case kCollection:
                ++depth_;
                if (display_ == 0 && value == kApplication && usage_ == kDisplay) display_ = depth_;
                usage_.reset();
                break;
            case kEnd:
                if (depth_ == 0) return false;
                if (display_ == depth_) display_ = 0;
                --depth_;
                usage_.reset();
                break;
            case kOutput: return take_output(value);
            case kInput:
            case kFeature: usage_.reset(); break;
            default: break;
        }
        return true;
    }

    bool take_output(std::uint32_t flags) {
        const std::uint64_t many = static_cast<std::uint64_t>(globals_.size) * globals_.count;
        std::uint64_t& end = bits[globals_.report];
        const std::uint64_t begin = end;
        if (many > kMostBits || begin + many > kMostBits) return false;
        end += many;
        const bool cells = display_ != 0 && (flags & kConstant) == 0 && (usage_ == kEightDots || usage_ == kSixDots);
        if (cells && globals_.size == 8 && globals_.count > 0 && begin % 8 == 0)
            fields.push_back({{globals_.report, static_cast<std::size_t>(begin / 8)}, static_cast<int>(globals_.count), usage_ == kSixDots ? 6 : 8});
        usage_.reset();
        return true;
    }

    std::span<const std::uint8_t> rest_;
    Globals globals_;
    std::vector<Globals> pushed_;
    std::optional<std::uint32_t> usage_;
    std::size_t depth_ = 0, display_ = 0;  // collections around, and which of them is the display
};

}  // namespace

BrailleReports braille_reports(std::span<const std::uint8_t> descriptor) {
    BrailleReports reports;
    Reader reader(descriptor);
    if (!reader.read()) return reports;
    std::map<std::pair<int, int>, int> cells;  // of all lines of that width and those dots
    for (const Field& field : reader.fields) cells[{field.columns, field.dots}] += field.columns;
    int most = 0;
    for (const Field& field : reader.fields) {
        if (const int all = cells[{field.columns, field.dots}]; all > most) {
            most = all;
            reports.columns = field.columns;
            reports.dots = field.dots;
        }
    }
    reports.numbered = reader.numbered;
    for (const Field& field : reader.fields) {
        if (field.columns != reports.columns || field.dots != reports.dots) continue;
        reports.lines.push_back(field.line);
        reports.sizes[field.line.report] = static_cast<std::size_t>((reader.bits[field.line.report] + 7) / 8);
    }
    return reports;
}

}  // namespace tactics
