#include "tests/support/effort.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"
#include "app/recovery/recovery_store.h"
#include "app/worker/sculpt_worker.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/io/numbered_backup.h"
#include "core/journal/journal_files.h"
#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "core/stroke/stroke_edit.h"
#include "ui/settings/settings.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidget>

#include <fstream>
#include <iostream>
#include <unistd.h>

using namespace app;
namespace fs = std::filesystem;

namespace
{
constexpr core::Rgb red{250, 10, 20};
/// small limits (bytes), so that the journal writes bases, too
constexpr core::JournalLimits smallLimits{.segmentBytes = 256 << 10, .logBytes = 2 << 20};

/// State after a change. The killed process prints it for each change, and recovery must restore it.
struct State
{
    std::uint64_t mesh = 0, state = 0;
    int present = 0, count = 0;

    friend bool operator==(const State&, const State&) = default;
};

std::string lineOf(const State& s)
{
    return "state " + std::to_string(s.mesh) + ' ' + std::to_string(s.state) + ' ' + std::to_string(s.present) + ' ' +
           std::to_string(s.count);
}

State stateIn(const QByteArray& line)
{
    const QList<QByteArray> words = line.trimmed().split(' ');
    return words.size() >= 5 && words[0] == "state"
               ? State{words[1].toULongLong(), words[2].toULongLong(), words[3].toInt(), words[4].toInt()}
               : State();
}

/// Processes events until the condition holds. Posted tasks wake the event loop, so the wait is short.
template <class Condition> void until(Condition isSo)
{
    QTimer tick; // wakes the loop even if tasks were posted before this call
    tick.start(20);
    QElapsedTimer clock;
    clock.start();
    while (!isSo() && clock.elapsed() < longestWait)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (!isSo())
        qFatal("waited too long");
}

/// A document whose changes are recorded in a journal.
struct Session
{
    explicit Session(const fs::path& root) : home(root.parent_path()), store(root, smallLimits), document(&worker)
    {
        document.journaling().setRecoveryStore(&store);
    }

    void openBall()
    {
        document.opener().openBall();
        wait();
    }
    void wait()
    {
        until([this] {
            return !document.job().isBusy() && document.queue().isSettled() && document.modelInfo().faces > 0;
        });
    }
    /// Returns the current state. `recorded`: whether to wait until the state would survive a crash of the program.
    State state(bool recorded = true)
    {
        std::optional<State> answer;
        const auto journal = document.journaling().journal();
        worker.post([&](core::Sculptor& sculptor) {
            const State now{sculptor.mesh().meshHash(), sculptor.mesh().stateHash(), 0, 0};
            const auto tell = [&answer, &mail = mail, now] { mail.post([&answer, now] { answer = now; }); };
            if (recorded && journal)
                journal->after(tell);
            else
                tell();
        });
        until([&] { return answer.has_value(); });
        State now = answer.value_or(State());
        now.present = document.history().stack().index();
        now.count = document.history().stack().count();
        return now;
    }
    void stroke(const core::Stroke& stroke)
    {
        document.strokes().beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples)
            document.strokes().addSample(sample);
        document.strokes().endStroke();
        wait();
    }
    void randomStroke(StrokeFuzzer& random)
    {
        core::Stroke made;
        ui::ThreadMailbox fromMesh;
        bool isMade = false;
        worker.post([&](core::Sculptor& sculptor) {
            made = random.stroke(sculptor.mesh());
            fromMesh.post([&isMade] { isMade = true; });
        });
        until([&] { return isMade; });
        stroke(made);
    }
    void apply(const core::ModelCommand& command)
    {
        document.changer().apply(command);
        wait();
    }
    /// Makes one random change and waits for its end. Returns whether it is a stroke, which is then already recorded;
    /// for other changes, recording must be awaited.
    bool act(StrokeFuzzer& random)
    {
        const auto steps = static_cast<std::uint64_t>(document.history().stack().count());
        switch (random.below(16)) {
        case 0:
        case 1:
        case 2:
            return document.history().undo(), wait(), false;
        case 3:
        case 4:
            return document.history().redo(), wait(), false;
        case 5:
            return document.history().goTo(static_cast<int>(random.below(steps + 1))), wait(), false;
        case 6:
            return wholeModel(random), false;
        case 7:
            return editLast(random.uniform(0.7, 1.4)), false;
        default:
            return randomStroke(random), true;
        }
    }
    /// Changes the radius of the last stroke by `factor`. Does nothing if the last step is not a stroke.
    void editLast(double factor)
    {
        const auto last = document.lastStroke().step();
        if (!last)
            return;
        core::BrushChange brush = core::brushOf(last->report.stroke()->settings);
        brush.radius *= factor;
        document.lastStroke().replace(
            *last, std::make_shared<const core::Stroke>(core::changed(*last->report.stroke(), brush)), {},
            [](const auto&) {});
        wait();
    }
    void wholeModel(StrokeFuzzer& random)
    {
        const double height = document.modelInfo().size.y();
        switch (random.below(12)) {
        case 0:
            return apply(core::Fill{{static_cast<std::uint8_t>(random.below(256)), 10, 20}});
        case 1:
            return apply(core::Scale{random.uniform(0.7, 1.4)});
        case 2:
            return apply(core::Mirror{static_cast<int>(random.below(3))});
        case 3:
            return apply(core::Symmetrize{});
        case 4:
            return apply(core::Reset{});
        case 5:
            return apply(core::PlaceOnBed{});
        case 6:
            return apply(core::FlattenBase{height * random.uniform(0.02, 0.2)});
        case 7:
            return apply(core::Move{{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)}});
        case 8:
            return apply(
                core::Rotate{Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-3, 3), core::Vec3::UnitY()))});
        case 9:
            return apply(core::RemeshUniformly{height * random.uniform(0.05, 0.1)});
        case 10:
            return insert();
        default:
            return apply(core::Recentre{});
        }
    }

    /// Returns the path of a file beside the root.
    QString file(const char* name) const { return QString::fromStdString((home / name).string()); }
    /// Inserts a small ball beside the model.
    void insert()
    {
        document.changer().insert({file("ball.stl")});
        wait();
    }

    fs::path home;
    ui::ThreadMailbox mail;
    RecoveryStore store;
    SculptWorker worker;
    Document document;
};

/// Main function of the process that a test kills: makes random changes and prints the state after each.
int runVictim(const fs::path& root, std::uint64_t seed, int changes)
{
    Session session(root);
    session.openBall();
    StrokeFuzzer random(seed);
    std::cout << lineOf(session.state()) << std::endl;
    for (int i = 0; i < changes; ++i) {
        const bool isStroke = session.act(random);
        std::cout << lineOf(session.state(!isStroke)) << std::endl;
    }
    std::cout << "done" << std::endl;
    std::quick_exit(0); // ends like a kill, so that the journal remains
}

struct Kind
{
    const char* name;
    void (*run)(Session& session, StrokeFuzzer& random);
};

void strokes(Session& session, StrokeFuzzer& random)
{
    for (const int count = session.document.history().stack().count();
         session.document.history().stack().count() < count + 2;)
        session.randomStroke(random);
}

template <class Command> void whole(Session& session, StrokeFuzzer&)
{
    session.apply(Command{});
}

/// Every kind of change that a document can make. Each of them changes something.
constexpr Kind kinds[] = {
    {"strokes", strokes},
    {"edit the last stroke", [](Session& s, StrokeFuzzer&) { s.editLast(1.2); }},
    {"undo", [](Session& s, StrokeFuzzer&) { s.document.history().undo(), s.wait(); }},
    {"redo", [](Session& s, StrokeFuzzer&) { s.document.history().redo(), s.wait(); }},
    {"jump", [](Session& s, StrokeFuzzer&) { s.document.history().goTo(0), s.wait(); }},
    {"jump back", [](Session& s, StrokeFuzzer&) { s.document.history().goTo(2), s.wait(); }},
    {"add ball",
     [](Session& s, StrokeFuzzer&) {
         core::StrokeSettings settings;
         settings.radius = 5;
         settings.add = true;
         core::StrokeSample sample;
         sample.position = {0, 90, 0};
         s.document.strokes().addSphere(settings, sample), s.wait();
     }},
    {"fill", [](Session& s, StrokeFuzzer&) { s.apply(core::Fill{red}); }},
    {"mask", [](Session& s, StrokeFuzzer&) { s.apply(core::MaskOperation{core::MaskOperation::Kind::Invert}); }},
    {"clear the mask",
     [](Session& s, StrokeFuzzer&) { s.apply(core::MaskOperation{core::MaskOperation::Kind::Clear}); }},
    {"resize", [](Session& s, StrokeFuzzer&) { s.apply(core::Scale{1.3}); }},
    {"move",
     [](Session& s, StrokeFuzzer&) {
         s.apply(core::Move{{1, 2, 3}});
     }},
    {"recentre", whole<core::Recentre>},
    {"rotate", [](Session& s, StrokeFuzzer&) { s.apply(core::Rotate{Eigen::Quaterniond(0.8, 0.6, 0, 0)}); }},
    {"mirror", whole<core::Mirror>},
    {"symmetrise", whole<core::Symmetrize>},
    {"insert", [](Session& s, StrokeFuzzer&) { s.insert(); }},
    {"remesh", [](Session& s, StrokeFuzzer&) { s.apply(core::RemeshUniformly{6}); }},
    {"place on bed", whole<core::PlaceOnBed>},
    {"flatten base", [](Session& s, StrokeFuzzer&) { s.apply(core::FlattenBase{10}); }},
    {"reset", whole<core::Reset>},
    {"import",
     [](Session& s, StrokeFuzzer& random) {
         s.document.opener().open(s.file("ball.stl")), s.wait(), strokes(s, random);
     }},
    {"legalise", [](Session& s, StrokeFuzzer&) { s.document.opener().openRepaired(s.file("bad.stl"), {}), s.wait(); }},
    {"save", [](Session& s, StrokeFuzzer&) { s.document.saver().save(s.file("saved.glb")), s.wait(); }},
    {"lose the file", [](Session& s, StrokeFuzzer&) { s.document.savedState().onFileDeleted(), s.wait(); }},
};

/// Makes the changes up to index `last`, prints the state after each, and waits to be killed.
int runKinds(const fs::path& root, int last)
{
    Session session(root);
    session.openBall();
    StrokeFuzzer random(1);
    for (int i = 0; i <= last; ++i) {
        kinds[i].run(session, random);
        std::cout << lineOf(session.state()) << ' ' << session.document.savedState().isModified() << std::endl;
    }
    for (;;)
        ::pause();
}

/// Main function of a process on a separate display, with an unsaved change or without.
int runOnDisplay(const fs::path& root, bool changes)
{
    RecoveryStore store(root);
    SculptWorker worker;
    Document document(&worker);
    document.journaling().setRecoveryStore(&store);
    QWidget window;
    window.show();
    const auto ready = [] { std::cout << "ready" << std::endl; };
    QObject::connect(&document, &Document::opened, &document, [&, ready] {
        if (changes)
            document.changer().apply(core::Fill{red});
        else
            ready();
    });
    QObject::connect(&document.savedState(), &SavedState::modifiedChanged, &document, ready);
    document.opener().openStarter(core::Starter::Head);
    return QApplication::exec();
}

State stateOf(const core::RecoveredDocument& document)
{
    return {document.mesh->meshHash(), document.mesh->stateHash(), static_cast<int>(document.history.present),
            static_cast<int>(document.history.steps.size())};
}

/// Returns whether the document was in a jump between two states, step by step. Its remaining deltas must lead back to
/// `from`, unless a base has dropped them.
bool isJumping(core::RecoveredDocument& found, const State& from, const State& to)
{
    const int present = static_cast<int>(found.history.present), count = static_cast<int>(found.history.steps.size());
    if (count != from.count || count != to.count || present <= std::min(from.present, to.present) ||
        present >= std::max(from.present, to.present))
        return false;
    const int way = from.present < present ? -1 : 1;
    for (int at = present; at != from.present; at += way) {
        const auto& delta = found.deltas[static_cast<std::size_t>(way < 0 ? at - 1 : at)];
        if (!delta)
            return true;
        found.mesh->swap(*delta);
    }
    return found.mesh->stateHash() == from.state;
}

/// Returns whether the last stroke was undone to be edited. Its delta must redo it.
bool isEditing(core::RecoveredDocument& found, const State& from, const State& to)
{
    const std::size_t present = found.history.present;
    if (from.present != to.present || from.count != to.count || static_cast<int>(present) + 1 != from.present ||
        from.count != from.present)
        return false;
    if (!found.deltas.at(present))
        return true;
    found.mesh->swap(*found.deltas[present]);
    return found.mesh->stateHash() == from.state;
}

fs::path onlyFolderIn(const fs::path& root)
{
    for (const auto& entry : fs::directory_iterator(root))
        return entry.path();
    return {};
}

/// A display server for one test.
class XServer
{
public:
    XServer()
    {
        m_server.start(QStringLiteral("Xvfb"),
                       {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                        QStringLiteral("0"), QStringLiteral("640x480x24")});
        m_server.waitForReadyRead(longestWait);
        m_name = ":" + m_server.readLine().trimmed();
    }
    ~XServer() { die(); }
    const QByteArray& name() const { return m_name; }
    void die()
    {
        m_server.kill();
        m_server.waitForFinished(longestWait);
    }

private:
    QProcess m_server;
    QByteArray m_name;
};
} // namespace

/// Tests programs that end abnormally and the recovery of their documents.
class TestRecovery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void kill_losesNothingThatWasFinished_data();
    void kill_losesNothingThatWasFinished();
    void kill_afterEachKindOfChange_data();
    void kill_afterEachKindOfChange();
    void recovered_goesOnWithItsHistory();
    void recovered_itsLastStrokeCanBeEdited();
    void recovered_thatWasSavedIsNotOffered();
    void discarded_isNeverOfferedAgain();
    void closed_leavesNothing();
    void earlierVersions_areKeptIfAskedFor();
    void another_program_isLeftAlone();
    void damagedBeyondUse_isPutAsideAndSaid();
    void damagedInPart_comesBackAndIsKept();
    void fullDisk_isSaidOnceAndLosesNoWork();
    void fullDisk_recordsAgainWhenThereIsRoom();
    void closedFolder_isSaidOnceAndAgainWhenItIsOpen();
    void lostDisplay_keepsTheChanges();
    void lostDisplay_withoutChangesKeepsNothing();

private:
    fs::path newRoot() { return fs::path(m_home.path().toStdString()) / std::to_string(m_roots++); }
    void startVictim(QProcess& victim, const fs::path& root, std::uint64_t seed, int changes);
    /// Leaves the journal of a program that was killed after some changes. Returns the last state.
    State leaveJournal(const fs::path& root, std::uint64_t seed, int changes);
    /// Returns the output of a program that made the changes up to `last` and was then killed.
    QList<QByteArray> killAfter(const fs::path& root, int last);
    QByteArray killDisplayOf(const fs::path& root, const QString& changes);

    QTemporaryDir m_home;
    int m_roots = 0;
};

std::unique_ptr<places::SmallDisk> smallDisk, largerDisk;

void TestRecovery::startVictim(QProcess& victim, const fs::path& root, std::uint64_t seed, int changes)
{
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(test::programPath(),
                 {test::runningClass(), QStringLiteral("--victim"), QString::fromStdString(root.string()),
                  QString::number(seed), QString::number(changes)});
    QVERIFY(victim.waitForStarted());
}

State TestRecovery::leaveJournal(const fs::path& root, std::uint64_t seed, int changes)
{
    QProcess victim;
    startVictim(victim, root, seed, changes);
    victim.waitForFinished(longestWait);
    const QList<QByteArray> lines = victim.readAllStandardOutput().trimmed().split('\n');
    return lines.size() < 2 ? State() : stateIn(lines[lines.size() - 2]);
}

void TestRecovery::initTestCase()
{
    const fs::path home = m_home.path().toStdString();
    core::writeMesh(home / "ball.stl", core::icosphere(2, 5));
    core::TriangleMesh bad = core::icosphere(2, 30);
    bad.triangles.pop_back();
    core::writeMesh(home / "bad.stl", bad);
}

void TestRecovery::kill_losesNothingThatWasFinished_data()
{
    QTest::addColumn<quint64>("seed");
    for (const quint64 seed : {1, 2, 3})
        QTest::addRow("%llu", seed) << seed;
}

/// Kills a process at random moments of the same changes.
/// Recovery must give the last reported state, or the next one, or one inside a jump between them, or the one before a
/// stroke that is being edited.
void TestRecovery::kill_losesNothingThatWasFinished()
{
    QFETCH(quint64, seed);
    const int changes = byEffort(40, 60);
    const int kills = byEffort(3, 12, 300);
    QProcess whole;
    QElapsedTimer clock;
    startVictim(whole, newRoot(), seed, changes);
    QVERIFY(whole.waitForReadyRead(longestWait));
    clock.start();
    QVERIFY(whole.waitForFinished(longestWait));
    const auto lasts = static_cast<std::uint64_t>(clock.elapsed());
    std::vector<State> states;
    for (const QByteArray& line : whole.readAllStandardOutput().trimmed().split('\n'))
        states.push_back(stateIn(line));
    states.pop_back(); // the last line is "done"
    QCOMPARE(states.size(), std::size_t(changes) + 1);

    StrokeFuzzer random(seed);
    int early = 0, exact = 0, next = 0, jumping = 0;
    for (int kill = 0; kill < kills; ++kill) {
        const fs::path root = newRoot();
        QProcess victim;
        startVictim(victim, root, seed, changes);
        if (random.below(10) > 0) // in most runs, waits until the process has a model
            QVERIFY(victim.waitForReadyRead(longestWait));
        QTest::qWait(static_cast<int>(random.below(lasts)));
        victim.kill(); // the process may have finished
        QTRY_COMPARE(victim.state(), QProcess::NotRunning);
        QList<QByteArray> lines = victim.readAllStandardOutput().split('\n');
        lines.pop_back(); // the last line may be truncated
        lines.removeAll("done");
        if (lines.isEmpty()) {
            ++early;
            continue;
        }
        const auto told = static_cast<std::size_t>(lines.size()) - 1;
        QVERIFY(states[told] == stateIn(lines.back()));
        auto found = core::recoverJournal(onlyFolderIn(root));
        QVERIFY2(found && !found->isDamaged, "nothing comes back");
        QVERIFY(core::checkMesh(core::extractMesh(*found->mesh)).printReady());
        const State state = stateOf(*found);
        const bool isLast = told + 1 == states.size(), isExact = state == states[told],
                   isNext = !isLast && state == states[told + 1];
        QVERIFY2(
            isExact || isNext ||
                (!isLast && (isJumping(*found, states[told], states[told + 1]) ||
                             isEditing(*found, states[told], states[told + 1]))),
            qPrintable(QStringLiteral("after %1 changes: %2").arg(told).arg(QString::fromStdString(lineOf(state)))));
        ++(isExact ? exact : isNext ? next : jumping);
        fs::remove_all(root);
    }
    qInfo("%d kills: %d before the model was there, %d at the change told of last, %d at the one after it, %d within a "
          "jump",
          kills, early, exact, next, jumping);
}

void TestRecovery::kill_afterEachKindOfChange_data()
{
    QTest::addColumn<int>("last");
    for (int i = 0; i < static_cast<int>(std::size(kinds)); ++i)
        QTest::addRow("%s", kinds[i].name) << i;
}

void TestRecovery::kill_afterEachKindOfChange()
{
    QFETCH(int, last);
    const fs::path root = newRoot();
    const QList<QByteArray> lines = killAfter(root, last);
    QCOMPARE(lines.size(), last + 1);
    QVERIFY2(last == 0 || lines[last] != lines[last - 1], "it did nothing");
    const bool isModified = lines[last].endsWith(" 1");
    int found = 0; // the journal of the previous model may still exist
    for (const auto& folder : fs::directory_iterator(root)) {
        const auto document = core::recoverJournal(folder.path());
        if (!document || stateOf(*document) != stateIn(lines[last]) || document->isUnsaved() != isModified)
            continue;
        ++found;
        QVERIFY(document->history.isWhole &&
                std::ranges::all_of(document->history.steps,
                                    [](const core::JournalStep& step) { return step.entry != nullptr; }));
    }
    QCOMPARE(found, 1);
}

QList<QByteArray> TestRecovery::killAfter(const fs::path& root, int last)
{
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(test::programPath(), {test::runningClass(), QStringLiteral("--kinds"),
                                       QString::fromStdString(root.string()), QString::number(last)});
    QList<QByteArray> lines;
    while (lines.size() <= last && (victim.canReadLine() || victim.waitForReadyRead(longestWait))) {
        if (victim.canReadLine())
            lines.append(victim.readLine().trimmed());
    }
    victim.kill();
    victim.waitForFinished(longestWait);
    return lines;
}

void TestRecovery::recovered_goesOnWithItsHistory()
{
    const fs::path root = newRoot();
    const State left = leaveJournal(root, 4, 40);
    QVERIFY(left.state != 0);
    State last;
    {
        Session session(root);
        session.openBall();
        QSignalSpy offers(&session.store, &RecoveryStore::offered);
        session.store.findAbandoned();
        QTRY_COMPARE(offers.size(), 1);
        const auto offer = offers[0][0].value<RecoveryOffer>();
        QVERIFY(offer.id != 0);
        QCOMPARE(offer.steps, left.present);
        QSignalSpy opened(&session.document, &Document::opened);
        session.document.opener().recover(offer.id, offer.name);
        QTRY_COMPARE(opened.size(), 1);
        session.wait();
        QVERIFY(session.state() == left);
        QVERIFY(session.document.savedState().isModified());
        QCOMPARE(offers.size(), 2);
        QCOMPARE(offers[1][0].value<RecoveryOffer>().id, quint64(0));
        // Undoes as far as possible, redoes everything, and continues with new strokes.
        session.document.history().goTo(0);
        QCOMPARE(session.document.history().stack().index(), session.document.history().store().firstIndex());
        session.document.history().goTo(left.present);
        QVERIFY(session.state() == left);
        StrokeFuzzer random(5);
        for (int i = 0; i < 5; ++i)
            session.act(random);
        last = session.state();
        until([&] { return !session.document.journaling().journal()->stats().isCompacting; });
        const fs::path folder = session.document.journaling().journal()->folder();
        const auto again = core::recoverJournal(folder);
        QVERIFY(again && stateOf(*again) == last);
    }
    QVERIFY(fs::is_empty(root)); // both documents were closed normally
}

/// The last stroke can be edited as if the program had not been killed.
void TestRecovery::recovered_itsLastStrokeCanBeEdited()
{
    const QList<QByteArray> edited = killAfter(newRoot(), 1);
    QCOMPARE(edited.size(), 2);
    const fs::path root = newRoot();
    QCOMPARE(killAfter(root, 0).size(), 1);
    Session session(root);
    session.openBall();
    QSignalSpy offers(&session.store, &RecoveryStore::offered), opened(&session.document, &Document::opened);
    session.store.findAbandoned();
    QTRY_COMPARE(offers.size(), 1);
    const auto offer = offers[0][0].value<RecoveryOffer>();
    session.document.opener().recover(offer.id, offer.name);
    QTRY_COMPARE(opened.size(), 1);
    session.wait();
    QVERIFY(session.document.lastStroke().step().has_value());
    session.editLast(1.2);
    QVERIFY(session.state() == stateIn(edited[1]));
}

void TestRecovery::recovered_thatWasSavedIsNotOffered()
{
    const fs::path root = newRoot();
    fs::create_directories(root);
    const QString file = QString::fromStdString((root.parent_path() / "saved.ply").string());
    {
        Session session(root);
        session.openBall();
        session.apply(core::Fill{red});
        session.document.saver().save(file);
        session.wait();
        QVERIFY(!session.document.savedState().isModified());
        session.document.journaling().journal()->flush();
        const auto found = core::recoverJournal(session.document.journaling().journal()->folder());
        QVERIFY(found && !found->isUnsaved());
        QCOMPARE(QString::fromStdString(found->document.path), file);
        session.document.history().undo();
        session.wait();
        session.state();
        const auto later = core::recoverJournal(session.document.journaling().journal()->folder());
        QVERIFY(later && later->isUnsaved());
    }
}

void TestRecovery::discarded_isNeverOfferedAgain()
{
    const fs::path root = newRoot();
    leaveJournal(root, 6, 10);
    leaveJournal(root, 7, 10);
    {
        RecoveryStore store(root);
        QSignalSpy offers(&store, &RecoveryStore::offered);
        store.findAbandoned();
        QTRY_COMPARE(offers.size(), 1);
        store.discard(offers[0][0].value<RecoveryOffer>().id);
        QCOMPARE(offers.size(), 2);
        QVERIFY(offers[1][0].value<RecoveryOffer>().id != 0); // the offer of the other document
    }
    {
        RecoveryStore store(root);
        QSignalSpy offers(&store, &RecoveryStore::offered);
        store.findAbandoned();
        QTRY_COMPARE(offers.size(), 1);
        store.discard(offers[0][0].value<RecoveryOffer>().id);
        QCOMPARE(offers[1][0].value<RecoveryOffer>().id, quint64(0));
    }
    QVERIFY(fs::is_empty(root));
}

void TestRecovery::closed_leavesNothing()
{
    const fs::path root = newRoot();
    {
        Session session(root);
        session.openBall();
        session.apply(core::Fill{red});
        session.openBall();
        // the journal of the previous model is removed
        QTRY_COMPARE(std::distance(fs::directory_iterator(root), {}), 1);
    }
    QVERIFY(fs::is_empty(root));
}

void TestRecovery::earlierVersions_areKeptIfAskedFor()
{
    const QTemporaryDir home;
    const QString file = home.filePath(QStringLiteral("ball.ply"));
    const auto kept = [&](int version) { return core::NumberedBackup::nameOf(file.toStdU16String(), version); };
    Session session(newRoot());
    session.openBall();
    for (int i = 0; i < 6; ++i) { // backups are kept in the last four of six rounds
        ui::Settings().set(ui::Preferences{.input = {}, .keepsBackups = i >= 2});
        session.apply(core::Fill{{static_cast<std::uint8_t>(i), 0, 0}});
        session.document.saver().save(file);
        session.wait();
        QVERIFY(i >= 2 || !fs::exists(kept(1)));
    }
    ui::Settings().set(ui::Preferences{});
    for (int version = 1; version <= 3; ++version)
        QCOMPARE(core::readMesh(kept(version)).colors.at(0).r, std::uint8_t(5 - version));
    QVERIFY(!fs::exists(kept(4)));
}

void TestRecovery::another_program_isLeftAlone()
{
    const fs::path root = newRoot();
    QProcess victim;
    startVictim(victim, root, 8, 100'000);
    for (int told = 0; told < 8;) { // waits until the process has unsaved changes
        QVERIFY(victim.canReadLine() || victim.waitForReadyRead(longestWait));
        told += victim.canReadLine() && !victim.readLine().isEmpty();
    }
    {
        Session session(root);
        QSignalSpy offers(&session.store, &RecoveryStore::offered);
        session.store.findAbandoned();
        QTRY_COMPARE(offers.size(), 1);
        QCOMPARE(offers[0][0].value<RecoveryOffer>().id, quint64(0));
        session.openBall();
        session.apply(core::Fill{red});
    }
    QCOMPARE(victim.state(), QProcess::Running);
    victim.kill();
    QVERIFY(victim.waitForFinished(longestWait));
    const auto found = core::recoverJournal(onlyFolderIn(root));
    QVERIFY(found && !found->history.steps.empty());
    // If two programs start at once, only one of them offers the document.
    const auto first = core::JournalFolder::abandoned(root), second = core::JournalFolder::abandoned(root);
    QCOMPARE(first.size(), std::size_t(1));
    QVERIFY(second.empty());
}

void TestRecovery::damagedBeyondUse_isPutAsideAndSaid()
{
    const fs::path root = newRoot(), aside = fs::path(root) += "-damaged";
    leaveJournal(root, 10, 12);
    const fs::path folder = onlyFolderIn(root);
    const auto cut = [](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); };
    cut(core::startFile(folder));
    for (const auto& base : core::filesIn(folder).bases)
        cut(core::baseFile(folder, base.first));
    {
        core::JournalFolder::make(root); // a program that ended before it had a model, which is no loss
        RecoveryStore store(root);
        QSignalSpy offers(&store, &RecoveryStore::offered), told(&store, &RecoveryStore::noticed);
        store.findAbandoned();
        QTRY_COMPARE(told.size(), 1);
        QVERIFY(told[0][0].toString().contains(QString::fromStdString((aside / folder.filename()).string())));
        QCOMPARE(offers[0][0].value<RecoveryOffer>().id, quint64(0));
        store.findAbandoned(); // the damaged journal must not be reported again
        QTRY_COMPARE(offers.size(), 2);
        QCOMPARE(told.size(), 1);
    }
    QVERIFY(fs::is_empty(root));
    QVERIFY(!core::filesIn(aside / folder.filename()).segments.empty());
}

/// Damages a byte in the middle. The changes before it are restored and recorded in a new journal, and the damaged
/// files are kept.
void TestRecovery::damagedInPart_comesBackAndIsKept()
{
    const fs::path root = newRoot(), aside = fs::path(root) += "-damaged";
    const State left = leaveJournal(root, 11, 30);
    const fs::path folder = onlyFolderIn(root);
    const core::JournalFiles files = core::filesIn(folder);
    // earlier segments are not read
    auto segment = files.segments.lower_bound(files.bases.empty() ? 0 : files.bases.rbegin()->first);
    if (std::next(segment) != files.segments.end())
        ++segment; // skips one segment, so that something is recovered even if the first change is large
    {
        std::fstream file(core::segmentFile(folder, segment->first), std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(segment->second / 2)).write("damaged!", 8);
    }
    const auto partly = core::recoverJournal(folder);
    QVERIFY(partly && partly->isDamaged && stateOf(*partly) != left);
    {
        Session session(root);
        session.openBall();
        QSignalSpy offers(&session.store, &RecoveryStore::offered), opened(&session.document, &Document::opened),
            notices(&session.document, &Document::noticed);
        session.store.findAbandoned();
        QTRY_COMPARE(offers.size(), 1);
        const auto offer = offers[0][0].value<RecoveryOffer>();
        QVERIFY(offer.id != 0);
        session.document.opener().recover(offer.id, offer.name);
        QTRY_COMPARE(opened.size(), 1);
        QVERIFY(session.state(false) == stateOf(*partly));
        QVERIFY(notices.size() == 1 && notices[0][0].toString().contains(QString::fromStdString(aside.string())));
        QTRY_VERIFY(fs::exists(aside / folder.filename()));
        QVERIFY(session.document.journaling().journal());
        session.apply(core::Fill{red});
        const State now = session.state();
        const auto again = core::recoverJournal(session.document.journaling().journal()->folder());
        QVERIFY(again && !again->isDamaged && stateOf(*again) == now && again->isUnsaved());
        QCOMPARE(notices.size(), 1);
    }
    QVERIFY(fs::is_empty(root) && fs::exists(aside / folder.filename()));
}

void TestRecovery::fullDisk_recordsAgainWhenThereIsRoom()
{
    if (!largerDisk->isThere())
        QSKIP("This system does not let the test have a small disk.");
    const fs::path root = largerDisk->folder() / "journals";
    Session session(root);
    session.store.setRetryInterval(std::chrono::milliseconds(20));
    QSignalSpy notices(&session.document, &Document::noticed);
    const auto told = [&](const char* words) {
        return std::ranges::count_if(
            notices, [&](const auto& notice) { return notice[0].toString().contains(QLatin1StringView(words)); });
    };
    session.openBall();
    StrokeFuzzer random(12);
    for (int round = 1; round <= 3; ++round) {
        const fs::path before = session.document.journaling().journal()->folder();
        largerDisk->fill();
        while (told("disk is full") < round)
            session.randomStroke(random);
        QVERIFY(session.document.journaling().journal()->isBroken());
        session.randomStroke(random);
        session.document.history().undo(); // the broken journal does not record it
        session.wait();
        QTest::qWait(200); // recording must not resume without free space
        QCOMPARE(told("recorded again"), round - 1);
        fs::remove(largerDisk->folder() / "filler");
        until([&] { return told("recorded again") == round; });
        for (int i = 0; i < 5; ++i)
            session.act(random);
        const State now = session.state();
        until([&] {
            return !session.document.journaling().journal()->stats().isCompacting;
        }); // compaction would remove files while the test reads them
        const auto found = core::recoverJournal(session.document.journaling().journal()->folder());
        QVERIFY(found && stateOf(*found) == now && found->isUnsaved() == session.document.savedState().isModified());
        for (int i = 0; i < now.count; ++i)
            QCOMPARE(QString::fromStdString(found->history.steps[static_cast<std::size_t>(i)].text),
                     session.document.history().stack().text(i));
        QTRY_VERIFY(!fs::exists(before));
        session.document.history().goTo(0);
        session.wait();
        session.document.history().goTo(now.present);
        QVERIFY(session.state() == now);
        QCOMPARE(told("disk is full"), round);
    }
}

void TestRecovery::fullDisk_isSaidOnceAndLosesNoWork()
{
    if (!smallDisk->isThere())
        QSKIP("This system does not let the test have a small disk.");
    Session session(smallDisk->folder() / "journals");
    QSignalSpy notices(&session.document, &Document::noticed);
    const auto head = core::Starter::Cube;
    session.document.opener().openStarter(head);
    session.wait();
    const bool hasBegun = session.document.journaling().journal() != nullptr;
    StrokeFuzzer random(9);
    std::vector<State> states{session.state()};
    for (int i = 0; i < 12; ++i) {
        session.randomStroke(random);
        states.push_back(session.state());
    }
    QTRY_VERIFY(!notices.isEmpty());
    int told = 0;
    for (const auto& notice : notices)
        told += notice[0].toString().contains(QStringLiteral("disk is full"));
    QCOMPARE(told, 1);
    QVERIFY(session.document.history().stack().count() > 3);
    session.document.history().goTo(0);
    QVERIFY(session.state().state == states.front().state);
    if (hasBegun) {
        const auto found = core::recoverJournal(session.document.journaling().journal()->folder());
        QVERIFY(found && std::ranges::find(states, found->mesh->stateHash(), &State::state) != states.end());
    }
    session.openBall(); // the disk is still full, which must not be reported again
    for (const auto& notice : notices)
        told -= notice[0].toString().contains(QStringLiteral("disk is full"));
    QCOMPARE(told, 0);
}

void TestRecovery::closedFolder_isSaidOnceAndAgainWhenItIsOpen()
{
    const fs::path root = newRoot();
    fs::create_directories(root);
    fs::permissions(root, fs::perms::owner_read | fs::perms::owner_exec);
    Session session(root);
    session.store.setRetryInterval(std::chrono::milliseconds(20));
    QSignalSpy notices(&session.document, &Document::noticed);
    session.openBall();
    session.apply(core::Fill{red});
    session.openBall();
    session.apply(core::Fill{red});
    QTest::qWait(200);
    QVERIFY(!session.document.journaling().journal());
    QCOMPARE(notices.size(), 1);
    QVERIFY2(notices[0][0].toString().contains(QStringLiteral("not allowed")), qPrintable(notices[0][0].toString()));
    fs::permissions(root, fs::perms::owner_all);
    until([&] { return notices.size() == 2; });
    QVERIFY(notices[1][0].toString().contains(QStringLiteral("recorded again")));
    const auto found = core::recoverJournal(session.document.journaling().journal()->folder());
    QVERIFY(found && stateOf(*found) == session.state() && found->mesh->color(0) == red);
}

QByteArray TestRecovery::killDisplayOf(const fs::path& root, const QString& changes)
{
    XServer display;
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DISPLAY"), QString::fromLatin1(display.name()));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    victim.setProcessEnvironment(environment);
    victim.start(test::programPath(),
                 {test::runningClass(), QStringLiteral("--window"), QString::fromStdString(root.string()), changes});
    if (!victim.waitForReadyRead(longestWait) || !victim.readAllStandardOutput().contains("ready"))
        return "not ready: " + victim.readAllStandardError();
    display.die();
    if (!victim.waitForFinished(longestWait) || victim.exitStatus() != QProcess::NormalExit)
        return "did not end in order";
    return victim.readAllStandardError();
}

void TestRecovery::lostDisplay_keepsTheChanges()
{
    const fs::path root = newRoot();
    const QByteArray word = killDisplayOf(root, QStringLiteral("changed"));
    QVERIFY2(word.contains("are kept; the next start offers them"), word.constData());
    const auto found = core::recoverJournal(onlyFolderIn(root));
    QVERIFY(found && found->isUnsaved());
    QVERIFY(found->mesh->color(0) == red);
}

void TestRecovery::lostDisplay_withoutChangesKeepsNothing()
{
    const fs::path root = newRoot();
    const QByteArray word = killDisplayOf(root, QStringLiteral("unchanged"));
    QVERIFY2(!word.contains("kept") && !word.contains("not ready"), word.constData());
    RecoveryStore store(root);
    QSignalSpy offers(&store, &RecoveryStore::offered);
    store.findAbandoned();
    QTRY_COMPARE(offers.size(), 1);
    QCOMPARE(offers[0][0].value<RecoveryOffer>().id, quint64(0));
    QVERIFY(fs::is_empty(root));
}

static int recoveryMain(int argc, char* argv[])
{
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_recovery"));
    const auto is = [&](int count, const char* word) { return argc == count && qstrcmp(argv[1], word) == 0; };
    if (is(4, "--window")) {
        const QApplication application(argc, argv);
        return runOnDisplay(argv[2], qstrcmp(argv[3], "changed") == 0);
    }
    const bool isVictim = is(5, "--victim"), isOfKinds = is(4, "--kinds");
    if (!isVictim && !isOfKinds) { // obeyPermissions() must run before any thread starts
        places::obeyPermissions();
        smallDisk = std::make_unique<places::SmallDisk>(
            fs::temp_directory_path() / ("fettle-journal-" + std::to_string(QCoreApplication::applicationPid())));
        largerDisk = std::make_unique<places::SmallDisk>(
            fs::temp_directory_path() / ("fettle-larger-" + std::to_string(QCoreApplication::applicationPid())),
            32 << 10);
    }
    const QCoreApplication application(argc, argv);
    if (isVictim)
        return runVictim(argv[2], QByteArray(argv[3]).toULongLong(), QByteArray(argv[4]).toInt());
    if (isOfKinds)
        return runKinds(argv[2], QByteArray(argv[3]).toInt());
    TestRecovery test;
    const int status = QTest::qExec(&test, argc, argv);
    smallDisk.reset();
    largerDisk.reset();
    return status;
}

FETTLE_TEST_MAIN(TestRecovery, recoveryMain)
#include "tst_recovery.moc"
