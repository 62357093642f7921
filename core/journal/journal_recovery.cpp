// Recovers a document from a journal's folder:
//   1. begin      with the newest complete base, or else the start
//   2. read on    the following segments, record by record, while numbers and checksums are right
//   3. apply      each image, if it fits the mesh and the resulting mesh hash is the recorded one

#include "core/journal/journal_recovery.h"

#include "core/journal/delta_images.h"
#include "core/journal/journal_files.h"

#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_hash.h"
#include "core/operations/snapshot.h"

#include <algorithm>

namespace core
{
namespace
{
class Recovery
{
public:
    explicit Recovery(bool withMesh) : m_withMesh(withMesh) {}

    bool beginWithStart(std::string_view bytes);
    bool beginWithBase(std::string_view bytes, std::string_view startBytes);
    /// Applies the segment's records and removes them from `bytes`, up to the first record that does not have the next
    /// number or cannot be applied. Returns false if it was stopped.
    bool readOn(std::string_view& bytes, const std::stop_token& stop);
    void noteDamage() { m_found.isDamaged = true; }
    RecoveredDocument take() { return std::move(m_found); }

private:
    bool swapIn(MeshDelta& image);
    void comeTo(std::uint32_t index, bool follows);
    std::shared_ptr<MeshDelta> kept(MeshDelta& image) const
    {
        return m_withMesh ? std::make_shared<MeshDelta>(std::move(image)) : nullptr;
    }
    bool apply(StartRecord&) { return false; } // records of these three kinds occur only at the beginning
    bool apply(PartRecord&) { return false; }
    bool apply(BaseRecord&) { return false; }
    bool apply(ChangeRecord& record);
    bool apply(SwapRecord& record);
    bool apply(SavedRecord& record);
    bool apply(JournalDocument& record);
    bool apply(ForgottenRecord&);

    bool m_withMesh;
    RecoveredDocument m_found;
};

template <class Record> Record* takeAs(std::optional<NumberedRecord>& found)
{
    return found ? std::get_if<Record>(&found->record) : nullptr;
}

bool Recovery::beginWithStart(std::string_view bytes)
{
    auto found = unpack(bytes);
    auto* record = takeAs<StartRecord>(found);
    if (!record)
        return false;
    m_found.start = record->start;
    m_found.document = std::move(record->document);
    m_found.nextRecord = 1;
    if (m_withMesh)
        m_found.mesh = meshOf(*m_found.start);
    return true;
}

/// Reads a base. Its parts replace the whole mesh of the start. Without a readable start the base alone is used, and
/// the document is marked as damaged.
bool Recovery::beginWithBase(std::string_view bytes, std::string_view startBytes)
{
    if (!beginWithStart(startBytes)) {
        noteDamage();
        if (m_withMesh)
            m_found.mesh = std::make_unique<Mesh>(TriangleMesh(), Lattice());
    }
    auto found = unpack(bytes);
    for (; auto* part = takeAs<PartRecord>(found); found = unpack(bytes)) {
        if (!m_withMesh)
            continue;
        if (!canSwap(*m_found.mesh, part->image))
            return false;
        m_found.mesh->swap(part->image);
    }
    auto* base = takeAs<BaseRecord>(found);
    if (!base || (m_withMesh && wholeHash(*m_found.mesh) != m_found.mesh->meshHash()))
        return false;
    m_found.nextRecord = found->number + 1;
    m_found.document = std::move(base->document);
    m_found.history = std::move(base->history);
    m_found.deltas.resize(m_found.history.steps.size());
    if (m_withMesh && !m_found.start)
        m_found.start = std::make_shared<Snapshot>(Snapshot{extractMesh(*m_found.mesh), m_found.mesh->frame()});
    return true;
}

bool Recovery::readOn(std::string_view& bytes, const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        std::string_view rest = bytes;
        auto found = unpack(rest);
        if (!found || found->number != m_found.nextRecord ||
            !std::visit([this](auto& record) { return apply(record); }, found->record))
            return true;
        bytes = rest;
        ++m_found.nextRecord;
    }
    return false;
}

/// Swaps the image into the mesh. Returns false, and leaves the mesh unchanged, if the resulting mesh hash is not the
/// recorded one.
bool Recovery::swapIn(MeshDelta& image)
{
    if (!m_withMesh)
        return true;
    Mesh& mesh = *m_found.mesh;
    if (!canSwap(mesh, image))
        return false;
    const std::uint64_t before = mesh.meshHash();
    mesh.swap(image);
    if (before + hashChange(mesh, image) == mesh.meshHash())
        return true;
    mesh.swap(image);
    return false;
}

/// Makes the history long enough for the step at `index`. If the record does not follow from the recovered history, all
/// deltas are dropped, because earlier states cannot be reached any more.
void Recovery::comeTo(std::uint32_t index, bool follows)
{
    if (!follows)
        m_found.deltas.assign(m_found.deltas.size(), nullptr);
    if (m_found.history.steps.size() <= index) {
        m_found.history.steps.resize(index + 1);
        m_found.deltas.resize(index + 1);
    }
}

bool Recovery::apply(ChangeRecord& record)
{
    JournalHistory& history = m_found.history;
    if (!swapIn(record.image))
        return false;
    comeTo(record.index, record.index == history.present);
    history.steps.resize(record.index + 1);
    history.steps.back() = std::move(record.step);
    history.present = record.index + 1;
    if (history.saved && *history.saved > record.index)
        history.saved.reset();
    m_found.deltas.resize(record.index + 1);
    m_found.deltas.back() = kept(record.image);
    return true;
}

bool Recovery::apply(SwapRecord& record)
{
    JournalHistory& history = m_found.history;
    if (!swapIn(record.image))
        return false;
    const bool isUndo = record.index + 1 == history.present, isRedo = record.index == history.present;
    comeTo(record.index, isUndo || isRedo);
    history.present = record.isDone ? record.index + 1 : record.index;
    m_found.deltas[record.index] = isUndo || isRedo ? kept(record.image) : nullptr;
    return true;
}

bool Recovery::apply(SavedRecord& record)
{
    m_found.history.saved = record.index;
    m_found.document.changedBeyondHistory = false;
    return true;
}

bool Recovery::apply(JournalDocument& record)
{
    m_found.document = std::move(record);
    return true;
}

bool Recovery::apply(ForgottenRecord&)
{
    m_found.history = {};
    m_found.history.isWhole = false;
    m_found.deltas.clear();
    return true;
}

/// Reads the newest complete base, or else the start. Returns the number of the segment that follows it; nothing if no
/// beginning is complete.
std::optional<unsigned> begin(Recovery& replay, const std::filesystem::path& folder, const JournalFiles& files,
                              const RecoveryOptions& options)
{
    const std::string startBytes = contentOf(startFile(folder));
    bool isDamaged = false;
    for (auto base = files.bases.rbegin(); base != files.bases.rend(); ++base) {
        if (base->first > options.endSegment)
            continue;
        if (replay.beginWithBase(contentOf(baseFile(folder, base->first)), startBytes)) {
            if (isDamaged)
                replay.noteDamage();
            return base->first;
        }
        replay = Recovery(options.mesh);
        isDamaged = true;
    }
    if (!replay.beginWithStart(startBytes))
        return std::nullopt;
    if (isDamaged)
        replay.noteDamage();
    return 0;
}
} // namespace

std::optional<RecoveredDocument> recoverJournal(const std::filesystem::path& folder, const RecoveryOptions& options)
{
    const JournalFiles files = filesIn(folder);
    Recovery replay(options.mesh);
    const auto first = begin(replay, folder, files, options);
    if (!first)
        return std::nullopt;
    for (auto segment = files.segments.lower_bound(*first);
         segment != files.segments.end() && segment->first < options.endSegment; ++segment) {
        const std::string bytes = contentOf(segmentFile(folder, segment->first));
        std::string_view rest = bytes;
        if (!replay.readOn(rest, options.stop))
            return std::nullopt;
        if (holdsRecord(rest))
            replay.noteDamage();
    }
    RecoveredDocument found = replay.take();
    found.nextSegment = files.segments.empty() ? *first : std::max(*first, files.segments.rbegin()->first + 1);
    return found;
}
} // namespace core
