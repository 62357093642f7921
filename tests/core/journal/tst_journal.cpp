#include "core/analysis/mesh_check.h"
#include "core/io/stroke/stroke_file.h"
#include "core/journal/checksum.h"
#include "core/journal/compaction.h"
#include "core/journal/journal.h"
#include "core/journal/journal_files.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_hash.h"
#include "core/operations/snapshot.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <fstream>

using namespace core;
namespace fs = std::filesystem;

namespace
{
/// The state of a document that recovery must restore.
struct State
{
    std::uint64_t mesh = 0, state = 0;
    JournalHistory history;

    friend bool operator==(const State&, const State&) = default;
};

State stateOf(const RecoveredDocument& document)
{
    return {document.mesh->meshHash(), document.mesh->stateHash(), document.history};
}

/// A simulated user who sculpts, undoes and redoes, with a journal.
class Session
{
public:
    Session(const fs::path& root, const TriangleMesh& model, std::uint64_t seed, JournalLimits limits = {})
        : m_random(seed)
    {
        auto mesh = std::move(buildMesh(model).mesh);
        const auto start = snapshotOf(*mesh);
        m_sculptor = std::make_unique<Sculptor>(std::move(mesh));
        DocumentMetadata metadata;
        metadata.palette = {{1, 2, 3}};
        m_journal = Journal::begin(root, {start, {"clay", "", metadata, false}}, {}, limits);
        note();
    }
    /// Resumes from a recovered document.
    Session(std::unique_ptr<JournalFolder> folder, RecoveredDocument document, std::uint64_t seed) : m_random(seed)
    {
        m_journal = Journal::resume(std::move(folder), document, {});
        m_sculptor = std::make_unique<Sculptor>(std::move(document.mesh));
        m_deltas = document.deltas;
        m_history = document.history;
        note();
    }

    void stroke(const Stroke& stroke)
    {
        m_sculptor->beginStroke(stroke.settings);
        for (const StrokeSample& sample : stroke.samples)
            m_sculptor->addSample(sample);
        auto delta = std::make_shared<MeshDelta>(m_sculptor->endStroke());
        if (delta->empty())
            return;
        const JournalStep step{"step " + std::to_string(states.size()), "pull", stroke.samples.size(), 0,
                               std::make_shared<const FileEntry>(stroke)};
        m_journal->changed(m_sculptor->mesh(), *delta, step);
        if (m_other)
            m_other->changed(m_sculptor->mesh(), *delta, step);
        m_deltas.resize(m_history.present);
        m_deltas.push_back(delta);
        m_history.steps.resize(m_history.present++);
        m_history.steps.push_back(step);
        if (m_history.saved && *m_history.saved >= m_history.present)
            m_history.saved.reset();
        note();
    }
    void randomStroke() { stroke(m_random.stroke(m_sculptor->mesh())); }
    bool swap(bool undo)
    {
        if (undo ? m_history.present == 0 : m_history.present == m_deltas.size())
            return false;
        const std::uint32_t index = undo ? --m_history.present : m_history.present++;
        if (!m_deltas[index]) {
            m_history.present = undo ? index + 1 : index;
            return false;
        }
        m_sculptor->swap(*m_deltas[index]);
        m_journal->swapped(m_sculptor->mesh(), *m_deltas[index], index);
        if (m_other)
            m_other->swapped(m_sculptor->mesh(), *m_deltas[index], index);
        note();
        return true;
    }
    void save()
    {
        m_history.saved = m_history.present;
        m_journal->saved(m_history.present);
        if (m_other)
            m_other->saved(m_history.present);
        note();
    }
    void act()
    {
        switch (m_random.below(8)) {
        case 0:
        case 1:
            return static_cast<void>(swap(true));
        case 2:
            return static_cast<void>(swap(false));
        case 3:
            return save();
        default:
            return randomStroke();
        }
    }
    Journal& journal() { return *m_journal; }
    /// Adds a second journal that records the same changes.
    void alsoTell(std::shared_ptr<Journal> journal) { m_other = std::move(journal); }
    const Mesh& mesh() const { return m_sculptor->mesh(); }
    State now() const { return {mesh().meshHash(), mesh().stateHash(), m_history}; }

    std::vector<State> states; ///< state after each record; the first one is before any record

private:
    void note() { states.push_back(now()); }

    StrokeFuzzer m_random;
    std::unique_ptr<Sculptor> m_sculptor;
    std::shared_ptr<Journal> m_journal, m_other;
    std::vector<std::shared_ptr<MeshDelta>> m_deltas;
    JournalHistory m_history;
};

void write(const fs::path& file, std::string_view bytes)
{
    std::ofstream(file, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Returns the offset of each record's end, preceded by 0.
std::vector<std::size_t> endsIn(const std::string& segment)
{
    std::vector<std::size_t> ends{0};
    std::string_view rest = segment;
    while (unpack(rest))
        ends.push_back(segment.size() - rest.size());
    return ends;
}
} // namespace

/// Tests that a journal restores its session, whatever damage its files have.
class TestJournal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void checksum_isThatOfZip();
    void recovery_givesTheStateAndTheHistory();
    void words_areReadWithoutTheMesh();
    void recovery_goesOnAsIfNothingHadBeen();
    void truncation_atEveryByteLosesWhatFollowsOnly();
    void truncatedBeginning_givesNothing();
    void flippedBytes_neverGiveAnotherState();
    void unsyncedPages_costWhatWasNotSynced();
    void compaction_keepsTheDocumentWithinItsBound();
    void tornBase_isNoBase();
    void lostStart_isDoneWithoutIfThereIsABase();
    void damage_isToldFromATornEnd();
    void lateBeginning_holdsWhatWasAndWhatCame();
    void lateBeginning_withoutMemoryIsBroken();
    void slowDisk_isToldOnce();
    void largeChange_isNotTooMuchByItself();
    void samples_areKept();
    void folders_belongToWhoHoldsThem();
    void folders_setAsideAreBounded();

private:
    /// Returns a copy of a session's folder, which a test may damage.
    fs::path copyOf(const fs::path& folder);

    QTemporaryDir m_home;
    int m_copies = 0;
};

fs::path TestJournal::copyOf(const fs::path& folder)
{
    const fs::path copy = fs::path(m_home.path().toStdString()) / ("copy-" + std::to_string(m_copies++));
    fs::copy(folder, copy, fs::copy_options::recursive);
    return copy;
}

void TestJournal::checksum_isThatOfZip()
{
    QCOMPARE(checksum("123456789"), 0xcbf43926u); // check value of this CRC in the catalogue of CRCs
    const std::string bytes(1000, 'x');
    QCOMPARE(checksum(std::string_view(bytes).substr(300), checksum(std::string_view(bytes).substr(0, 300))),
             checksum(bytes));
}

void TestJournal::recovery_givesTheStateAndTheHistory()
{
    Session session(m_home.path().toStdString(), icosphere(3, 20), 1);
    for (int i = 0; i < 60; ++i)
        session.act();
    session.journal().drain();
    const auto found = recoverJournal(session.journal().folder());
    QVERIFY(found);
    QVERIFY(stateOf(*found) == session.now());
    QCOMPARE(found->document.name, std::string("clay"));
    QVERIFY(found->document.metadata.palette == std::vector<Rgb>({{1, 2, 3}}));
    QVERIFY(*found->start->surface.points.data() == Vec3f(snapshotOf(*meshOf(*found->start))->surface.points[0]));
    core::DocumentMetadata metadata;
    metadata.view = SavedView{{1, 2, 3}, 4, 0.5, 0.25, true};
    metadata.brush.emplace().radius = 7;
    metadata.work = core::WorkDone{12, 345.5};
    metadata.references = {{"left", "/pictures/lion.jpg", 80, 1, -2, 0.5, true},
                           {"top", "/pictures/mane.png", 90, 0, 0, 1, false}};
    session.journal().describe({"clay two", "/a/path", metadata, true});
    session.journal().drain();
    const auto later = recoverJournal(session.journal().folder());
    QVERIFY(later && stateOf(*later) == session.now() && later->isUnsaved());
    QCOMPARE(later->document.path, std::string("/a/path"));
    QVERIFY(later->document.metadata.view && later->document.metadata.view->target == Vec3(1, 2, 3) &&
            later->document.metadata.view->orthographic);
    QVERIFY(later->document.metadata.brush && later->document.metadata.brush->radius == 7);
    QVERIFY(later->document.metadata.work == metadata.work && !found->document.metadata.work);
    QVERIFY(later->document.metadata.references == metadata.references && found->document.metadata.references.empty());
}

void TestJournal::words_areReadWithoutTheMesh()
{
    Session session(m_home.path().toStdString(), icosphere(2, 20), 14);
    for (int i = 0; i < 20; ++i)
        session.act();
    session.journal().drain();
    const auto found = recoverJournal(session.journal().folder());
    QVERIFY(found);
    const auto words = recoverJournal(session.journal().folder(), {.mesh = false});
    QVERIFY(words && !words->mesh && words->history == found->history && words->isUnsaved() == found->isUnsaved());
}

/// Equal strokes on the recovered mesh must give the same bits, and every step can be undone and redone.
void TestJournal::recovery_goesOnAsIfNothingHadBeen()
{
    Session session(m_home.path().toStdString(), icosphere(3, 20), 2);
    for (int i = 0; i < 40; ++i)
        session.act();
    session.journal().drain();
    const auto copy = JournalFolder::make(m_home.path().toStdString());
    fs::copy(session.journal().folder(), copy->path(), fs::copy_options::recursive | fs::copy_options::skip_existing);
    auto document = recoverJournal(copy->path());
    QVERIFY(document);
    const fs::path folder = copy->path();
    Session later(std::make_unique<JournalFolder>(std::move(*copy)), std::move(*document), 77);
    StrokeFuzzer random(5);
    for (int i = 0; i < 10; ++i) {
        const Stroke stroke = random.stroke(session.mesh());
        session.stroke(stroke);
        later.stroke(stroke);
        QCOMPARE(later.mesh().stateHash(), session.mesh().stateHash());
    }
    while (session.swap(true)) {
        QVERIFY(later.swap(true));
        QCOMPARE(later.mesh().stateHash(), session.mesh().stateHash());
    }
    QVERIFY(!later.swap(true));
    while (session.swap(false)) {
        QVERIFY(later.swap(false));
        QCOMPARE(later.mesh().stateHash(), session.mesh().stateHash());
    }
    later.journal().drain();
    const auto again = recoverJournal(folder);
    QVERIFY(again && stateOf(*again).state == session.mesh().stateHash());
    QCOMPARE(again->history.present, session.now().history.present);
}

void TestJournal::truncation_atEveryByteLosesWhatFollowsOnly()
{
    std::optional<Session> brief; // a short session, because each byte costs a replay
    std::string whole;
    for (std::uint64_t seed = 1; !brief || whole.size() > 40'000; ++seed) {
        brief.emplace(m_home.path().toStdString(), icosphere(0, 20), seed);
        while (brief->states.size() < 9)
            brief->act();
        brief->journal().drain();
        whole = contentOf(segmentFile(brief->journal().folder(), 0));
    }
    Session& session = *brief;
    const std::vector<std::size_t> ends = endsIn(whole);
    QCOMPARE(ends.back(), whole.size());
    QCOMPARE(ends.size(), session.states.size());
    const fs::path folder = copyOf(session.journal().folder());
    std::size_t record = ends.size() - 1;
    const auto isNearAnEnd = [&](std::size_t bytes) {
        return std::ranges::any_of(ends, [&](std::size_t end) { return bytes + 2 >= end && bytes <= end + 2; });
    };
    for (std::size_t bytes = whole.size(); bytes <= whole.size(); --bytes) {
        record -= bytes < ends[record];
        if (bytes % byEffort(31u, 1u) != 0 && !isNearAnEnd(bytes))
            continue;
        fs::resize_file(segmentFile(folder, 0), bytes);
        const auto found = recoverJournal(folder);
        QVERIFY2(found && stateOf(*found) == session.states[record], qPrintable(QString::number(bytes)));
        QVERIFY(!found->isDamaged); // a truncated end is normal after a power cut, not damage
    }
    qInfo("%zu bytes, %zu states", whole.size(), session.states.size());
}

void TestJournal::truncatedBeginning_givesNothing()
{
    Session session(m_home.path().toStdString(), icosphere(0, 20), 4);
    session.act();
    session.journal().drain();
    const std::string whole = contentOf(startFile(session.journal().folder()));
    const fs::path folder = copyOf(session.journal().folder());
    for (std::size_t bytes = whole.size(); bytes-- > 0;) {
        fs::resize_file(startFile(folder), bytes);
        QVERIFY(!recoverJournal(folder));
    }
    fs::remove(startFile(folder));
    QVERIFY(!recoverJournal(folder));
    QVERIFY(!recoverJournal(folder / "nowhere"));
}

void TestJournal::flippedBytes_neverGiveAnotherState()
{
    Session session(m_home.path().toStdString(), icosphere(1, 20), 5);
    while (session.states.size() < 12)
        session.act();
    session.journal().drain();
    const std::string whole = contentOf(segmentFile(session.journal().folder(), 0));
    const std::vector<std::size_t> ends = endsIn(whole);
    const fs::path folder = copyOf(session.journal().folder());
    StrokeFuzzer random(6);
    for (int i = 0; i < 1000; ++i) {
        std::string spoilt = whole;
        std::size_t first = whole.size();
        for (std::uint64_t flips = 1 + random.below(4); flips > 0; --flips) {
            const std::size_t at = random.below(whole.size());
            spoilt[at] = static_cast<char>(spoilt[at] ^ (1 + random.below(255)));
            first = std::min(first, spoilt[at] == whole[at] ? first : at);
        }
        write(segmentFile(folder, 0), spoilt);
        const auto found = recoverJournal(folder);
        const auto record =
            static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), first) - ends.begin()) - 1;
        const bool isWhole = first == whole.size();
        QVERIFY(found && stateOf(*found) == session.states[isWhole ? ends.size() - 1 : record]);
    }
}

/// Simulates a power cut: of the pages that were not synced, some are on the disk, in any order.
void TestJournal::unsyncedPages_costWhatWasNotSynced()
{
    constexpr std::size_t page = 4096;
    Session session(m_home.path().toStdString(), icosphere(2, 20), 7);
    StrokeFuzzer random(8);
    const fs::path folder = session.journal().folder();
    for (int round = 0; round < 30; ++round) {
        for (std::uint64_t i = random.below(3); i > 0; --i)
            session.act();
        session.journal().flush();
        const std::string synced = contentOf(segmentFile(folder, 0));
        const std::size_t states = session.states.size();
        for (std::uint64_t i = 1 + random.below(3); i > 0; --i)
            session.act();
        session.journal().drain();
        std::string bytes = contentOf(segmentFile(folder, 0));
        if (random.below(2) == 0)
            bytes.resize(synced.size() + random.below(bytes.size() - synced.size() + 1));
        for (std::size_t at = synced.size(); at < bytes.size(); at = (at / page + 1) * page)
            if (random.below(2) == 0)
                std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                            std::min(bytes.size() - at, page - at % page), '\0');
        const fs::path copy = copyOf(folder);
        write(segmentFile(copy, 0), bytes);
        const auto found = recoverJournal(copy);
        QVERIFY(found);
        const auto match = std::find(session.states.begin() + static_cast<std::ptrdiff_t>(states) - 1,
                                     session.states.end(), stateOf(*found));
        QVERIFY2(match != session.states.end(), "older than what was synced, or a state that never was");
        fs::remove_all(copy);
    }
}

void TestJournal::compaction_keepsTheDocumentWithinItsBound()
{
    constexpr JournalLimits limits{.segmentBytes = 32 << 10, .logBytes = 256 << 10};
    Session session(m_home.path().toStdString(), icosphere(3, 20), 9, limits);
    const fs::path folder = session.journal().folder();
    std::uintmax_t most = 0;
    int reached = 0;
    for (int round = 0; round < 30; ++round) {
        for (int i = 0; i < 8; ++i)
            session.act();
        session.journal().flush();
        while (session.journal().stats().isCompacting)
            std::this_thread::yield();
        const auto found = recoverJournal(folder);
        QVERIFY(found && stateOf(*found) == session.now());
        for (std::size_t i = found->history.present; i > 0 && found->deltas[i - 1]; --i)
            found->mesh->swap(*found->deltas[i - 1]), ++reached;
        QCOMPARE(found->mesh->meshHash(), wholeHash(*found->mesh));
        std::uintmax_t bytes = 0;
        for (const auto& segment : filesIn(folder).segments)
            bytes += segment.second;
        most = std::max(most, bytes);
    }
    QVERIFY(session.journal().stats().compactions > 3);
    QVERIFY(reached > 30);
    qInfo("%.0f KiB recorded, at most %.0f KiB kept, %llu compactions", double(session.journal().stats().bytes) / 1024,
          double(most) / 1024, static_cast<unsigned long long>(session.journal().stats().compactions));
    QVERIFY(most < session.journal().stats().bytes / 2);
}

void TestJournal::tornBase_isNoBase()
{
    constexpr JournalLimits limits{.segmentBytes = 4 << 10};
    Session session(m_home.path().toStdString(), icosphere(1, 20), 10, limits);
    for (int i = 0; i < 30; ++i)
        session.act();
    session.journal().drain();
    const fs::path complete = copyOf(session.journal().folder()), compacted = copyOf(complete);
    const unsigned last = filesIn(complete).segments.rbegin()->first;
    QVERIFY(last > 2 && compactJournal(compacted, last / 2));
    QCOMPARE(filesIn(compacted).segments.begin()->first, last / 2);
    const auto found = recoverJournal(compacted);
    QVERIFY(found && stateOf(*found) == session.now());
    const std::string base = contentOf(baseFile(compacted, last / 2));
    StrokeFuzzer random(11);
    for (int i = 0; i < 300; ++i) { // a truncated base beside the segments that it would replace is ignored
        write(baseFile(complete, last / 2), std::string_view(base).substr(0, random.below(base.size())));
        const auto without = recoverJournal(complete);
        QVERIFY(without && stateOf(*without) == session.now());
    }
    QVERIFY(!compactJournal(complete, last + 5)); // the segment does not exist
}

/// A base replaces a start file that is lost.
void TestJournal::lostStart_isDoneWithoutIfThereIsABase()
{
    constexpr JournalLimits limits{.segmentBytes = 4 << 10};
    Session session(m_home.path().toStdString(), icosphere(1, 20), 15, limits);
    for (int i = 0; i < 30; ++i)
        session.act();
    session.journal().drain();
    const fs::path folder = copyOf(session.journal().folder());
    const unsigned middle = filesIn(folder).segments.rbegin()->first / 2;
    QVERIFY(middle > 0 && compactJournal(folder, middle));
    QVERIFY(!recoverJournal(folder)->isDamaged);
    fs::resize_file(startFile(folder), fs::file_size(startFile(folder)) / 2);
    const State before = session.now();
    for (const bool mesh : {true, false}) {
        auto found = recoverJournal(folder, {.mesh = mesh});
        QVERIFY(found && found->isDamaged && found->history == before.history);
        if (!mesh)
            continue;
        QVERIFY(stateOf(*found) == before);
        QVERIFY(checkMesh(extractMesh(*meshOf(*found->start))).printReady());
        Sculptor sculptor(std::move(found->mesh)); // the recovered mesh can be sculpted
        StrokeFuzzer random(16);
        const Stroke stroke = random.stroke(sculptor.mesh());
        session.stroke(stroke);
        sculptor.beginStroke(stroke.settings);
        for (const StrokeSample& sample : stroke.samples)
            sculptor.addSample(sample);
        sculptor.endStroke();
        QCOMPARE(sculptor.mesh().stateHash(), session.mesh().stateHash());
    }
    fs::resize_file(baseFile(folder, middle), 1000);
    QVERIFY(!recoverJournal(folder));
}

void TestJournal::damage_isToldFromATornEnd()
{
    constexpr JournalLimits limits{.segmentBytes = 4 << 10};
    Session session(m_home.path().toStdString(), icosphere(1, 20), 17, limits);
    std::vector histories = {session.now().history};
    for (int i = 0; i < 30; ++i) {
        session.act();
        histories.push_back(session.now().history);
    }
    session.journal().drain();
    const fs::path complete = copyOf(session.journal().folder());
    const unsigned last = filesIn(complete).segments.rbegin()->first;
    QVERIFY(last > 4 && !recoverJournal(complete)->isDamaged);
    // damage in any segment except the last one loses the segments after it
    for (unsigned number = 0; number < last; ++number) {
        const fs::path folder = copyOf(complete);
        std::string bytes = contentOf(segmentFile(folder, number));
        bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
        write(segmentFile(folder, number), bytes);
        const auto found = recoverJournal(folder);
        QVERIFY(found && found->isDamaged && std::ranges::find(histories, found->history) != histories.end());
        fs::remove(segmentFile(folder, number));
        QVERIFY(recoverJournal(folder)->isDamaged);
    }
    QVERIFY(compactJournal(complete, last / 2));
    fs::resize_file(baseFile(complete, last / 2), 1000); // damages the base, which the removed segments cannot replace
    const auto found = recoverJournal(complete);
    QVERIFY(found && found->isDamaged && found->history.steps.empty() && stateOf(*found) == session.states.front());
}

/// Tests a journal that begins with an existing document while the user keeps sculpting.
void TestJournal::lateBeginning_holdsWhatWasAndWhatCame()
{
    const QTemporaryDir home;
    const fs::path root = home.path().toStdString();
    Session session(root / "first", icosphere(3, 20), 18);
    for (int i = 0; i < 20; ++i)
        session.act();
    std::atomic<bool> hasBegun = false;
    JournalCallbacks callbacks;
    callbacks.begun = [&] { hasBegun = true; };
    const std::shared_ptr<JournalFolder> folder = JournalFolder::makeHidden(root / "second");
    const State before = session.now();
    const auto mesh = std::make_shared<Mesh>(session.mesh());
    const auto journal = Journal::beginDeferred(folder, before.history.present, callbacks);
    session.alsoTell(journal);
    for (int i = 0; i < 10; ++i)
        session.act();
    bool isTold = false;
    journal->after([&] { isTold = true; }); // called at once, because a journal that has not begun delays nothing
    QVERIFY(isTold && !hasBegun);
    journal->drain();
    QVERIFY(JournalFolder::abandoned(root / "second").empty() && !fs::exists(journal->folder()));
    journal->beginWith(mesh, {snapshotOf(*buildMesh(icosphere(3, 20)).mesh), {"clay", "", {}, false}},
                       {{"clay", "", {}, false}, before.history});
    for (int i = 0; i < 10; ++i)
        session.act();
    journal->flush();
    QVERIFY(hasBegun);
    const auto found = recoverJournal(journal->folder());
    QVERIFY(found && !found->isDamaged && stateOf(*found) == session.now());
    const Session later(JournalFolder::make(root / "third"), std::move(*recoverJournal(journal->folder())),
                        1); // a recovered session can be resumed
    QVERIFY(later.now() == session.now());
}

void TestJournal::lateBeginning_withoutMemoryIsBroken()
{
    const QTemporaryDir home;
    const fs::path root = home.path().toStdString();
    int broken = 0;
    {
        JournalCallbacks callbacks;
        callbacks.broken = [&](const FileError&) { ++broken; };
        callbacks.begun = [&] { broken += 100; };
        const auto journal = Journal::beginDeferred(JournalFolder::makeHidden(root), 0, callbacks);
        journal->saved(0);
        journal->beginWith(nullptr, {}, {});
        journal->flush();
        QVERIFY(journal->isBroken());
        // destroyed before it begins
        const auto unused = Journal::beginDeferred(JournalFolder::makeHidden(root), 0, callbacks);
        unused->saved(0);
    }
    QCOMPARE(broken, 1);
    QVERIFY(fs::is_empty(root));
}

void TestJournal::slowDisk_isToldOnce()
{
    for (const double promised : {0.0, 1e9}) {
        std::atomic<int> told = 0;
        JournalCallbacks callbacks;
        callbacks.late = [&](double ms) { told += ms > 0 ? 1 : 100; };
        JournalLimits limits;
        limits.promisedMs = promised;
        const fs::path root = m_home.path().toStdString();
        const auto mesh = buildMesh(icosphere(1, 20)).mesh;
        const auto journal = Journal::begin(root, {snapshotOf(*mesh), {}}, callbacks, limits);
        for (int i = 0; i < 10; ++i) {
            journal->saved(0);
            journal->flush();
        }
        QCOMPARE(told.load(), promised > 0 ? 0 : 1);
        QVERIFY(promised > 0 ? journal->stats().late == 0 : journal->stats().late > 3);
        journal->remove();
    }
}

void TestJournal::largeChange_isNotTooMuchByItself()
{
    JournalLimits limits;
    limits.waitingBytes = 1;
    Session session(m_home.path().toStdString(), icosphere(2, 20), 19, limits);
    for (int i = 0; i < 10; ++i) {
        session.act();
        session.journal().drain();
    }
    QVERIFY(!session.journal().isBroken());
    const auto found = recoverJournal(session.journal().folder());
    QVERIFY(found && stateOf(*found) == session.now());
}

void TestJournal::samples_areKept()
{
    Session session(m_home.path().toStdString(), icosphere(3, 20), 12);
    StrokeFuzzer random(13);
    std::vector<Stroke> strokes;
    while (session.states.size() < 8) {
        const Stroke stroke = random.stroke(session.mesh());
        const std::size_t before = session.states.size();
        session.stroke(stroke);
        if (session.states.size() > before)
            strokes.push_back(stroke);
    }
    session.journal().drain();
    const auto found = recoverJournal(session.journal().folder(), {.mesh = false});
    QVERIFY(found && found->history.isWhole);
    const std::vector<JournalStep>& kept = found->history.steps;
    QCOMPARE(kept.size(), strokes.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const auto& stroke = std::get<Stroke>(*kept[i].entry);
        QCOMPARE(stroke.samples.size(), strokes[i].samples.size());
        QCOMPARE(stroke.settings.radius, strokes[i].settings.radius);
        QVERIFY(stroke.samples.back().position == strokes[i].samples.back().position);
    }
}

void TestJournal::folders_belongToWhoHoldsThem()
{
    const QTemporaryDir home;
    const fs::path root = fs::path(home.path().toStdString()) / "state" / "journals";
    QVERIFY(JournalFolder::abandoned(root).empty());
    auto first = JournalFolder::make(root), second = JournalFolder::make(root);
    QVERIFY(first->path() != second->path());
    QVERIFY(JournalFolder::abandoned(root).empty());
    const fs::path path = first->path();
    first.reset(); // releases the folder, as the end of its program does
    {
        const auto found = JournalFolder::abandoned(root);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0]->path(), path);
        QVERIFY(JournalFolder::abandoned(root).empty()); // the folder is locked again
        found[0]->remove();
    }
    QVERIFY(!fs::exists(path) && fs::exists(second->path()));
    second->remove();
    QVERIFY(fs::is_empty(root));
}

void TestJournal::folders_setAsideAreBounded()
{
    const QTemporaryDir home;
    const fs::path root = fs::path(home.path().toStdString()) / "journals",
                   aside = fs::path(home.path().toStdString()) / "aside";
    fs::path last;
    for (int i = 0; i < 5; ++i) {
        const auto folder = JournalFolder::make(root);
        write(folder->path() / "start", "x");
        last = folder->setAside(aside, 3);
        QCOMPARE(last, folder->path());
        QVERIFY(fs::exists(last / "start"));
        QCOMPARE(std::distance(fs::directory_iterator(aside), {}), std::min(i + 1, 3));
        std::this_thread::sleep_for(std::chrono::milliseconds(20)); // time stamps of files are coarse
    }
    QVERIFY(fs::is_empty(root) && fs::exists(last));
    fs::remove_all(aside);
    write(aside, "no folder");
    const auto folder = JournalFolder::make(root);
    QVERIFY(folder->setAside(aside, 3).empty() && fs::exists(folder->path()));
}

FETTLE_TEST(TestJournal)
#include "tst_journal.moc"
