#include "core/journal/journal_record.h"

#include "core/journal/byte_stream.h"
#include "core/journal/checksum.h"

#include <sstream>
#include <utility>

namespace core
{
namespace
{
constexpr std::uint32_t mark = 0x364a5446; ///< "FTJ6"

struct Head
{
    std::uint32_t mark = 0, kind = 0;
    std::uint64_t number = 0, length = 0;
};

/// A reference parameter for a value that is written or read: const with ByteWriter, mutable with ByteReader.
template <class T, class Stream> using Passed = std::conditional_t<std::is_same_v<Stream, ByteWriter>, const T, T>;
template <class Stream> constexpr bool isReading = std::is_same_v<Stream, ByteReader>;

// --- values inside records

constexpr std::size_t vertexBytes = 27, edgeBytes = 36, faceBytes = 20, partBytes = 44;

template <class Stream> void pass(Stream& stream, Passed<VertexImage, Stream>& image)
{
    stream.pass(image.slot, image.point.x(), image.point.y(), image.point.z());
    stream.pass(image.color.r, image.color.g, image.color.b, image.mask, image.live, image.part, image.item);
}

template <class Stream> void pass(Stream& stream, Passed<EdgeImage, Stream>& image)
{
    Slot slot = (image.slot << 1) | Slot(image.live);
    stream.pass(slot, image.item);
    if constexpr (isReading<Stream>)
        image.slot = slot >> 1, image.live = (slot & 1) != 0;
}

template <class Stream> void pass(Stream& stream, Passed<FaceImage, Stream>& image)
{
    stream.pass(image.slot, image.corners, image.item);
}

/// Writes the entry as the text of a stroke file; no entry as an empty text.
void putEntry(ByteWriter& out, const FileEntry* entry)
{
    std::ostringstream text;
    if (entry)
        writeStrokes(text, {*entry});
    out.put(text.view());
}

/// Reads an entry. Returns null if there is none, or if another version wrote it in a form that cannot be read.
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

template <class Stream> void pass(Stream& stream, Passed<JournalStep, Stream>& step)
{
    stream.pass(step.text, step.icon, step.dabs, step.fusions);
    if constexpr (isReading<Stream>)
        step.entry = takeEntry(stream);
    else
        putEntry(stream, step.entry.get());
}

template <class Stream> void pass(Stream& stream, Passed<Part, Stream>& part)
{
    bool hasTag = part.tag.has_value();
    Rgb tag = part.tag.value_or(Rgb());
    stream.pass(part.id, part.name, part.isVisible, part.isLocked, hasTag, tag.r, tag.g, tag.b);
    stream.pass(part.axes.x(), part.axes.y(), part.axes.z(), part.axes.w());
    if constexpr (isReading<Stream>)
        part.tag = hasTag ? std::optional(tag) : std::nullopt;
}

template <class Value> void passAll(ByteWriter& out, const std::vector<Value>& values, std::size_t)
{
    out.put(static_cast<std::uint32_t>(values.size()));
    for (const Value& value : values)
        pass(out, value);
}

/// `bytesEach`: least size of one value in bytes.
template <class Value> void passAll(ByteReader& in, std::vector<Value>& values, std::size_t bytesEach)
{
    values.resize(in.takeCount(bytesEach));
    for (Value& value : values)
        pass(in, value);
}

template <class Stream> void pass(Stream& stream, Passed<MeshFrame, Stream>& frame)
{
    std::int32_t exponent = frame.lattice.exponent();
    stream.pass(exponent, frame.uniformDetail, frame.place.x(), frame.place.y(), frame.place.z());
    std::vector<Part> parts = frame.parts.all();
    passAll(stream, parts, partBytes);
    if constexpr (isReading<Stream>) {
        frame.lattice = Lattice(exponent);
        frame.parts = PartList::isUsable(parts) ? PartList(std::move(parts)) : PartList();
    }
}

template <class Stream> void pass(Stream& stream, Passed<MeshDelta, Stream>& image)
{
    passAll(stream, image.vertices, vertexBytes);
    passAll(stream, image.edges, edgeBytes);
    passAll(stream, image.faces, faceBytes);
    stream.pass(image.counts, image.meshHash);
    pass(stream, image.frame);
}

template <class T> void passPlain(ByteWriter& out, const std::vector<T>& values)
{
    out.put(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

template <class T> void passPlain(ByteReader& in, std::vector<T>& values)
{
    const std::string_view bytes = in.takeText();
    values.resize(bytes.size() / sizeof(T));
    if (!values.empty())
        std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
}

template <class Stream> void pass(Stream& stream, Passed<SavedView, Stream>& view)
{
    stream.pass(view.target.x(), view.target.y(), view.target.z());
    stream.pass(view.distance, view.yaw, view.pitch, view.orthographic);
}

/// Flags for the optional parts of DocumentMetadata that are present.
constexpr std::uint8_t viewBit = 1, workBit = 2, referencesBit = 4;

void pass(ByteWriter& out, const SavedReference& reference)
{
    const std::u8string path = reference.path.generic_u8string();
    out.pass(reference.side, std::string(path.begin(), path.end()), reference.width, reference.x, reference.y,
             reference.opacity, reference.inFront);
}

void pass(ByteReader& in, SavedReference& reference)
{
    std::string path;
    in.pass(reference.side, path, reference.width, reference.x, reference.y, reference.opacity, reference.inFront);
    reference.path = std::u8string(path.begin(), path.end());
}

void pass(ByteWriter& out, const DocumentMetadata& metadata)
{
    const int parts = (metadata.view ? viewBit : 0) | (metadata.work ? workBit : 0) |
                      (metadata.references.empty() ? 0 : referencesBit);
    passPlain(out, metadata.palette);
    out.put(static_cast<std::uint8_t>(parts));
    pass(out, metadata.view.value_or(SavedView()));
    const FileEntry brush = Stroke{metadata.brush.value_or(StrokeSettings()), {}, {}, {}};
    putEntry(out, metadata.brush ? &brush : nullptr);
    if (metadata.work)
        out.pass(metadata.work->strokes, metadata.work->seconds);
    if (!metadata.references.empty())
        out.put(static_cast<std::uint8_t>(metadata.references.size()));
    for (const SavedReference& reference : metadata.references)
        pass(out, reference);
}

void pass(ByteReader& in, DocumentMetadata& metadata)
{
    passPlain(in, metadata.palette);
    const auto parts = in.take<std::uint8_t>();
    pass(in, metadata.view.emplace());
    if ((parts & viewBit) == 0)
        metadata.view.reset();
    const auto brush = takeEntry(in);
    if (const auto* stroke = std::get_if<Stroke>(brush.get()))
        metadata.brush = stroke->settings;
    if ((parts & workBit) != 0)
        metadata.work = WorkDone{in.take<std::uint64_t>(), in.take<double>()};
    metadata.references.resize((parts & referencesBit) != 0 ? in.take<std::uint8_t>() : 0);
    for (SavedReference& reference : metadata.references)
        pass(in, reference);
}

template <class Stream> void pass(Stream& stream, Passed<Snapshot, Stream>& snapshot)
{
    pass(stream, snapshot.frame);
    passPlain(stream, snapshot.surface.points);
    passPlain(stream, snapshot.surface.colors);
    passPlain(stream, snapshot.surface.masks);
    passPlain(stream, snapshot.surface.parts);
    passPlain(stream, snapshot.surface.triangles);
}

// --- content of each kind of record

template <class Stream> void pass(Stream& stream, Passed<JournalDocument, Stream>& document)
{
    stream.pass(document.name, document.path);
    pass(stream, document.metadata);
    stream.pass(document.changedBeyondHistory);
}

template <class Stream> void pass(Stream& stream, Passed<StartRecord, Stream>& record)
{
    pass(stream, record.document);
    if constexpr (isReading<Stream>) {
        auto start = std::make_shared<Snapshot>();
        pass(stream, *start);
        record.start = std::move(start);
    } else {
        pass(stream, *record.start);
    }
}

template <class Stream> void pass(Stream& stream, Passed<ChangeRecord, Stream>& record)
{
    stream.pass(record.index);
    pass(stream, record.step);
    pass(stream, record.image);
}

template <class Stream> void pass(Stream& stream, Passed<SwapRecord, Stream>& record)
{
    stream.pass(record.index, record.isDone);
    pass(stream, record.image);
}

template <class Stream> void pass(Stream& stream, Passed<SavedRecord, Stream>& record)
{
    stream.pass(record.index);
}

template <class Stream> void pass(Stream&, Passed<ForgottenRecord, Stream>&) {}

template <class Stream> void pass(Stream& stream, Passed<PartRecord, Stream>& record)
{
    pass(stream, record.image);
}

template <class Stream> void pass(Stream& stream, Passed<BaseRecord, Stream>& record)
{
    auto& history = record.history;
    bool isSaved = history.saved.has_value();
    std::uint32_t saved = history.saved.value_or(0);
    pass(stream, record.document);
    stream.pass(history.present, isSaved, saved, history.isWhole);
    if constexpr (isReading<Stream>)
        history.saved = isSaved ? std::optional(saved) : std::nullopt;
    passAll(stream, history.steps, 1);
}

template <std::size_t kind = 0> std::optional<JournalRecord> takeRecord(ByteReader& in, std::uint32_t wanted)
{
    if constexpr (kind == std::variant_size_v<JournalRecord>) {
        return std::nullopt;
    } else {
        if (wanted != kind)
            return takeRecord<kind + 1>(in, wanted);
        std::variant_alternative_t<kind, JournalRecord> record;
        pass(in, record);
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
    pass(toA, a), pass(toB, b);
    return ofA == ofB;
}

std::string pack(const JournalRecord& record, std::uint64_t number)
{
    std::string bytes;
    ByteWriter out(bytes);
    out.put(Head{mark, static_cast<std::uint32_t>(record.index()), number, 0});
    std::visit([&](const auto& content) { pass(out, content); }, record);
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
