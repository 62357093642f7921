#include "core/journal/journal_record.h"

#include "core/journal/byte_stream.h"
#include "core/journal/checksum.h"

#include <sstream>
#include <utility>

namespace core
{
namespace
{
constexpr std::uint32_t mark = 0x334a5446; ///< "FTJ3"

struct Head
{
    std::uint32_t mark = 0, kind = 0;
    std::uint64_t number = 0, length = 0;
};

// --- parts

constexpr std::size_t vertexBytes = 25, edgeBytes = 36, faceBytes = 20;

void put(ByteWriter& out, const VertexImage& image)
{
    out.put(image.slot), out.put(image.point.x()), out.put(image.point.y()), out.put(image.point.z());
    out.put(image.color.r), out.put(image.color.g), out.put(image.color.b), out.put(image.mask);
    out.put(image.live), out.put(image.item);
}

void put(ByteWriter& out, const EdgeImage& image)
{
    out.put((image.slot << 1) | Slot(image.live)), out.put(image.item);
}

void put(ByteWriter& out, const FaceImage& image)
{
    out.put(image.slot), out.put(image.corners), out.put(image.item);
}

void take(ByteReader& in, VertexImage& image)
{
    image.slot = in.take<Slot>(), image.stamp = 0;
    for (int i = 0; i < 3; ++i)
        image.point[i] = in.take<float>();
    image.color.r = in.take<std::uint8_t>(), image.color.g = in.take<std::uint8_t>(),
    image.color.b = in.take<std::uint8_t>();
    image.mask = in.take<std::uint8_t>(), image.live = in.take<std::uint8_t>() != 0,
    image.item = in.take<OpenMesh::ArrayItems::Vertex>();
}

void take(ByteReader& in, EdgeImage& image)
{
    const auto slot = in.take<Slot>();
    image.slot = slot >> 1, image.stamp = 0, image.live = (slot & 1) != 0,
    image.item = in.take<OpenMesh::ArrayItems::Edge>();
}

void take(ByteReader& in, FaceImage& image)
{
    image.slot = in.take<Slot>(), image.stamp = 0, image.corners = in.take<Triangle>(),
    image.item = in.take<OpenMesh::ArrayItems::Face>();
}

template <class Image> void putAll(ByteWriter& out, const std::vector<Image>& images)
{
    out.put(static_cast<std::uint32_t>(images.size()));
    for (const Image& image : images)
        put(out, image);
}

template <class Image> void takeAll(ByteReader& in, std::vector<Image>& images, std::size_t bytesEach)
{
    images.resize(in.takeCount(bytesEach));
    for (Image& image : images)
        take(in, image);
}

void put(ByteWriter& out, const MeshFrame& frame)
{
    out.put(static_cast<std::int32_t>(frame.lattice.exponent())), out.put(frame.uniformDetail);
}

void take(ByteReader& in, MeshFrame& frame)
{
    frame.lattice = Lattice(in.take<std::int32_t>()), frame.uniformDetail = in.take<double>();
}

void put(ByteWriter& out, const MeshDelta& image)
{
    putAll(out, image.vertices), putAll(out, image.edges), putAll(out, image.faces);
    out.put(image.counts), out.put(image.meshHash), put(out, image.frame);
}

void take(ByteReader& in, MeshDelta& image)
{
    takeAll(in, image.vertices, vertexBytes), takeAll(in, image.edges, edgeBytes), takeAll(in, image.faces, faceBytes);
    image.counts = in.take<SlotCounts>(), image.meshHash = in.take<std::uint64_t>(), take(in, image.frame);
}

/// A stroke file of its own.
void putEntry(ByteWriter& out, const FileEntry* entry)
{
    std::ostringstream text;
    if (entry)
        writeStrokes(text, {*entry});
    out.put(text.view());
}

/// Null: there is none, or it is another version's.
std::shared_ptr<const FileEntry> takeEntry(ByteReader& in)
{
    const std::string_view text = in.takeText();
    try {
        std::vector<FileEntry> entries = text.empty() ? std::vector<FileEntry>() : parseStrokes(text);
        if (!entries.empty())
            return std::make_shared<const FileEntry>(std::move(entries.front()));
    } catch (const StrokeFileError&) {
    }
    return nullptr;
}

void put(ByteWriter& out, const JournalStep& step)
{
    out.put(std::string_view(step.text)), out.put(std::string_view(step.icon)), out.put(step.dabs),
        out.put(step.fusions);
    putEntry(out, step.entry.get());
}

void take(ByteReader& in, JournalStep& step)
{
    step.text = in.takeText(), step.icon = in.takeText(), step.dabs = in.take<std::uint64_t>(),
    step.fusions = in.take<std::uint64_t>();
    step.entry = takeEntry(in);
}

template <class T> void putPlain(ByteWriter& out, const std::vector<T>& values)
{
    out.put(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

template <class T> void takePlain(ByteReader& in, std::vector<T>& values)
{
    const std::string_view bytes = in.takeText();
    values.resize(bytes.size() / sizeof(T));
    if (!values.empty())
        std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
}

void put(ByteWriter& out, const SavedView& view)
{
    out.put(view.target.x()), out.put(view.target.y()), out.put(view.target.z());
    out.put(view.distance), out.put(view.yaw), out.put(view.pitch), out.put(view.orthographic);
}

void take(ByteReader& in, SavedView& view)
{
    for (int i = 0; i < 3; ++i)
        view.target[i] = in.take<double>();
    view.distance = in.take<double>(), view.yaw = in.take<double>(), view.pitch = in.take<double>();
    view.orthographic = in.take<std::uint8_t>() != 0;
}

/// Bits: which of the notes there are.
constexpr std::uint8_t viewBit = 1, workBit = 2;

void put(ByteWriter& out, const DocumentMetadata& metadata)
{
    const int parts = (metadata.view ? viewBit : 0) | (metadata.work ? workBit : 0);
    putPlain(out, metadata.palette), out.put(static_cast<std::uint8_t>(parts)),
        put(out, metadata.view.value_or(SavedView()));
    const FileEntry brush = Stroke{metadata.brush.value_or(StrokeSettings()), {}, {}, {}};
    putEntry(out, metadata.brush ? &brush : nullptr);
    if (metadata.work)
        out.put(metadata.work->strokes), out.put(metadata.work->seconds);
}

void take(ByteReader& in, DocumentMetadata& metadata)
{
    takePlain(in, metadata.palette);
    const auto parts = in.take<std::uint8_t>();
    take(in, metadata.view.emplace());
    if ((parts & viewBit) == 0)
        metadata.view.reset();
    const auto brush = takeEntry(in);
    if (const auto* stroke = std::get_if<Stroke>(brush.get()))
        metadata.brush = stroke->settings;
    if ((parts & workBit) != 0)
        metadata.work = WorkDone{in.take<std::uint64_t>(), in.take<double>()};
}

// --- contents, a pair for each kind

void put(ByteWriter& out, const JournalDocument& document)
{
    out.put(std::string_view(document.name)), out.put(std::string_view(document.path)), put(out, document.metadata);
    out.put(document.changedBeyondHistory);
}

void take(ByteReader& in, JournalDocument& document)
{
    document.name = in.takeText(), document.path = in.takeText(), take(in, document.metadata);
    document.changedBeyondHistory = in.take<std::uint8_t>() != 0;
}

void put(ByteWriter& out, const StartRecord& record)
{
    put(out, record.document), put(out, record.start->frame);
    putPlain(out, record.start->surface.points), putPlain(out, record.start->surface.colors),
        putPlain(out, record.start->surface.masks);
    putPlain(out, record.start->surface.triangles);
}

void take(ByteReader& in, StartRecord& record)
{
    auto start = std::make_shared<Snapshot>();
    take(in, record.document), take(in, start->frame);
    takePlain(in, start->surface.points), takePlain(in, start->surface.colors), takePlain(in, start->surface.masks);
    takePlain(in, start->surface.triangles);
    record.start = std::move(start);
}

void put(ByteWriter& out, const ChangeRecord& record)
{
    out.put(record.index), put(out, record.step), put(out, record.image);
}

void take(ByteReader& in, ChangeRecord& record)
{
    record.index = in.take<std::uint32_t>(), take(in, record.step), take(in, record.image);
}

void put(ByteWriter& out, const SwapRecord& record)
{
    out.put(record.index), out.put(record.isDone), put(out, record.image);
}

void take(ByteReader& in, SwapRecord& record)
{
    record.index = in.take<std::uint32_t>(), record.isDone = in.take<std::uint8_t>() != 0, take(in, record.image);
}

void put(ByteWriter& out, const SavedRecord& record)
{
    out.put(record.index);
}

void take(ByteReader& in, SavedRecord& record)
{
    record.index = in.take<std::uint32_t>();
}

void put(ByteWriter&, const ForgottenRecord&) {}

void take(ByteReader&, ForgottenRecord&) {}

void put(ByteWriter& out, const PartRecord& record)
{
    put(out, record.image);
}

void take(ByteReader& in, PartRecord& record)
{
    take(in, record.image);
}

void put(ByteWriter& out, const BaseRecord& record)
{
    const JournalHistory& history = record.history;
    put(out, record.document), out.put(history.present), out.put(history.saved.has_value()),
        out.put(history.saved.value_or(0));
    out.put(history.isWhole);
    out.put(static_cast<std::uint32_t>(history.steps.size()));
    for (const JournalStep& step : history.steps)
        put(out, step);
}

void take(ByteReader& in, BaseRecord& record)
{
    JournalHistory& history = record.history;
    take(in, record.document), history.present = in.take<std::uint32_t>();
    const bool isSaved = in.take<std::uint8_t>() != 0;
    history.saved = in.take<std::uint32_t>();
    if (!isSaved)
        history.saved.reset();
    history.isWhole = in.take<std::uint8_t>() != 0;
    history.steps.resize(in.takeCount(1));
    for (JournalStep& step : history.steps)
        take(in, step);
}

template <std::size_t kind = 0> std::optional<JournalRecord> takeRecord(ByteReader& in, std::uint32_t wanted)
{
    if constexpr (kind == std::variant_size_v<JournalRecord>) {
        return std::nullopt;
    } else {
        if (wanted != kind)
            return takeRecord<kind + 1>(in, wanted);
        std::variant_alternative_t<kind, JournalRecord> record;
        take(in, record);
        return in.atEnd() ? std::optional<JournalRecord>(std::move(record)) : std::nullopt;
    }
}

struct RawRecord
{
    Head head;
    std::string_view content;
};

std::optional<RawRecord> takeRaw(std::string_view& bytes)
{
    ByteReader in(bytes);
    RawRecord raw{in.take<Head>(), {}};
    const std::size_t frame = sizeof(Head) + sizeof(std::uint32_t);
    if (!in.isGood() || raw.head.mark != mark || bytes.size() < frame || raw.head.length > bytes.size() - frame)
        return std::nullopt;
    const std::size_t end = sizeof(Head) + static_cast<std::size_t>(raw.head.length);
    if (ByteReader(bytes.substr(end)).take<std::uint32_t>() != checksum(bytes.substr(0, end)))
        return std::nullopt;
    raw.content = bytes.substr(sizeof(Head), end - sizeof(Head));
    bytes.remove_prefix(end + sizeof(std::uint32_t));
    return raw;
}
} // namespace

bool operator==(const JournalStep& a, const JournalStep& b)
{
    std::string ofA, ofB;
    ByteWriter toA(ofA), toB(ofB);
    put(toA, a), put(toB, b);
    return ofA == ofB;
}

std::string pack(const JournalRecord& record, std::uint64_t number)
{
    std::string bytes;
    ByteWriter out(bytes);
    out.put(Head{mark, static_cast<std::uint32_t>(record.index()), number, 0});
    std::visit([&](const auto& content) { put(out, content); }, record);
    const std::uint64_t length = bytes.size() - sizeof(Head);
    std::memcpy(bytes.data() + offsetof(Head, length), &length, sizeof length);
    out.put(checksum(bytes));
    return bytes;
}

std::optional<NumberedRecord> unpack(std::string_view& bytes)
{
    std::string_view rest = bytes;
    const auto raw = takeRaw(rest);
    if (!raw)
        return std::nullopt;
    ByteReader in(raw->content);
    auto record = takeRecord(in, raw->head.kind);
    if (!record)
        return std::nullopt;
    bytes = rest;
    return NumberedRecord{raw->head.number, std::move(*record)};
}

bool holdsRecord(std::string_view bytes)
{
    const std::string_view sign(reinterpret_cast<const char*>(&mark), sizeof mark);
    for (std::size_t at = bytes.find(sign); at != bytes.npos; at = bytes.find(sign, at + 1)) {
        std::string_view rest = bytes.substr(at);
        if (takeRaw(rest))
            return true;
    }
    return false;
}
} // namespace core
