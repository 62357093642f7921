#include "tests/support/hard_places.h"
#include "tests/support/stroke_fuzzer.h"

#include "app/document.h"
#include "app/journal_shelf.h"
#include "app/stroke_command.h"

#include "core/kept_version.h"
#include "core/mesh_build.h"
#include "core/mesh_check.h"
#include "core/mesh_io.h"
#include "ui/settings.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

#include <iostream>

using namespace app;
namespace fs = std::filesystem;

namespace
{
constexpr int longestWait = 60'000;
constexpr core::Rgb red{250, 10, 20};
constexpr core::JournalLimits smallLimits{.segmentBytes = 256 << 10, .logBytes = 2 << 20}; ///< so that bases come, too

/// What a change left behind; what a victim says of each, and what must come back.
struct State
{
    std::uint64_t mesh = 0, state = 0;
    int present = 0, count = 0;

    friend bool operator==(const State&, const State&) = default;
};

std::string lineOf(const State& s)
{
    return "state " + std::to_string(s.mesh) + ' ' + std::to_string(s.state) + ' ' + std::to_string(s.present) + ' ' + std::to_string(s.count);
}

State stateIn(const QByteArray& line)
{
    const QList<QByteArray> words = line.trimmed().split(' ');
    return words.size() == 5 && words[0] == "state" ? State{words[1].toULongLong(), words[2].toULongLong(), words[3].toInt(), words[4].toInt()} : State();
}

/// A document whose changes are recorded.
struct Session
{
    explicit Session(const fs::path& root) : shelf(root, smallLimits), document(&worker) { document.keepJournals(&shelf); }

    void openBall()
    {
        document.openSphere();
        wait();
    }
    void wait()
    {
        QTRY_VERIFY_WITH_TIMEOUT(!document.isBusy() && document.isSettled() && document.facts().faces > 0, longestWait);
    }
    /// As it is now; with `recorded` not before that would survive the program.
    State state(bool recorded = true)
    {
        std::optional<State> answer;
        const auto journal = document.journal();
        worker.post([&](core::Sculptor& sculptor) {
            const State now{sculptor.mesh().meshHash(), sculptor.mesh().stateHash(), 0, 0};
            const auto tell = [&answer, &mail = mail, now] { mail.post([&answer, now] { answer = now; }); };
            if (recorded && journal)
                journal->after(tell);
            else
                tell();
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer, longestWait); }();
        State now = answer.value_or(State());
        now.present = document.undoStack().index();
        now.count = document.undoStack().count();
        return now;
    }
    void stroke(const core::Stroke& stroke)
    {
        document.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples)
            document.addSample(sample);
        document.endStroke();
        wait();
    }
    void randomStroke(StrokeFuzzer& random)
    {
        core::Stroke made;
        ui::Mailbox fromMesh;
        bool isMade = false;
        worker.post([&](core::Sculptor& sculptor) {
            made = random.stroke(sculptor.mesh());
            fromMesh.post([&isMade] { isMade = true; });
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(isMade, longestWait); }();
        stroke(made);
    }
    void apply(const core::ModelCommand& command)
    {
        document.apply(command);
        wait();
    }
    /// One change of any kind. Whether "finished" is what strokeFinished() says, or must be asked for.
    bool act(StrokeFuzzer& random)
    {
        const auto steps = static_cast<std::uint64_t>(document.undoStack().count());
        switch (random.below(16)) {
        case 0:
        case 1:
        case 2:
            return document.undo(), wait(), false;
        case 3:
        case 4:
            return document.redo(), wait(), false;
        case 5:
            return document.goTo(static_cast<int>(random.below(steps + 1))), wait(), false;
        case 6:
            return wholeModel(random), false;
        default:
            return randomStroke(random), true;
        }
    }
    void wholeModel(StrokeFuzzer& random)
    {
        switch (random.below(6)) {
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
        default:
            return apply(core::Recentre{});
        }
    }

    ui::Mailbox mail;
    JournalShelf shelf;
    SculptWorker worker;
    Document document;
};

/// What the test starts and kills: changes from a seed, each told as soon as it is finished.
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
    std::quick_exit(0); // as if it were killed: the journal stays
}

/// On a display of its own: a window, and a document with a change that no file holds, or with none.
int runOnDisplay(const fs::path& root, bool changes)
{
    JournalShelf shelf(root);
    SculptWorker worker;
    Document document(&worker);
    document.keepJournals(&shelf);
    QWidget window;
    window.show();
    const auto ready = [] { std::cout << "ready" << std::endl; };
    QObject::connect(&document, &Document::opened, &document, [&, ready] {
        if (changes)
            document.apply(core::Fill{red});
        else
            ready();
    });
    QObject::connect(&document, &Document::modifiedChanged, &document, ready);
    document.openStarter(core::Starter::Head);
    return QApplication::exec();
}

State stateOf(const core::RecoveredDocument& document)
{
    return {document.mesh->meshHash(), document.mesh->stateHash(), static_cast<int>(document.history.present),
            static_cast<int>(document.history.steps.size())};
}

fs::path onlyFolderIn(const fs::path& root)
{
    for (const auto& entry : fs::directory_iterator(root))
        return entry.path();
    return {};
}

/// A display server of our own.
class XServer
{
public:
    XServer()
    {
        m_server.start(QStringLiteral("Xvfb"), {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
                                                QStringLiteral("640x480x24")});
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

/// Programs end as they should not, and their documents come back.
class TestRecovery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void kill_losesNothingThatWasFinished_data();
    void kill_losesNothingThatWasFinished();
    void recovered_goesOnWithItsHistory();
    void recovered_thatWasSavedIsNotOffered();
    void discarded_isNeverOfferedAgain();
    void closed_leavesNothing();
    void earlierVersions_areKeptIfAskedFor();
    void another_program_isLeftAlone();
    void fullDisk_isSaidOnceAndLosesNoWork();
    void closedFolder_isSaidOnce();
    void lostDisplay_keepsTheChanges();
    void lostDisplay_withoutChangesKeepsNothing();

private:
    fs::path newRoot() { return fs::path(m_home.path().toStdString()) / std::to_string(m_roots++); }
    void startVictim(QProcess& victim, const fs::path& root, std::uint64_t seed, int changes);
    /// A journal whose program was killed after some changes.
    State leaveJournal(const fs::path& root, std::uint64_t seed, int changes);
    QByteArray killDisplayOf(const fs::path& root, const QString& changes);

    QTemporaryDir m_home;
    int m_roots = 0;
};

std::unique_ptr<places::SmallDisk> smallDisk;

void TestRecovery::startVictim(QProcess& victim, const fs::path& root, std::uint64_t seed, int changes)
{
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--victim"), QString::fromStdString(root.string()),
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

void TestRecovery::kill_losesNothingThatWasFinished_data()
{
    QTest::addColumn<quint64>("seed");
    for (const quint64 seed : {1, 2, 3})
        QTest::addRow("%llu", seed) << seed;
}

/// The same changes each time, and SIGKILL at any moment: what comes back is the last state that was told of, or the one after it.
void TestRecovery::kill_losesNothingThatWasFinished()
{
    QFETCH(quint64, seed);
    constexpr int changes = 60;
    const bool isLong = qEnvironmentVariableIsSet("FETTLE_SOAK");
    const int kills = isLong ? 300 : 12;
    QProcess whole;
    QElapsedTimer clock;
    clock.start();
    startVictim(whole, newRoot(), seed, changes);
    QVERIFY(whole.waitForFinished(longestWait * 5));
    const auto lasts = static_cast<std::uint64_t>(clock.elapsed());
    std::vector<State> states;
    for (const QByteArray& line : whole.readAllStandardOutput().trimmed().split('\n'))
        states.push_back(stateIn(line));
    states.pop_back(); // "done"
    QCOMPARE(states.size(), std::size_t(changes) + 1);

    StrokeFuzzer random(seed);
    int early = 0, exact = 0, next = 0;
    for (int kill = 0; kill < kills; ++kill) {
        const fs::path root = newRoot();
        QProcess victim;
        startVictim(victim, root, seed, changes);
        QTest::qWait(static_cast<int>(random.below(lasts)));
        victim.kill(); // it may be done already
        QTRY_COMPARE_WITH_TIMEOUT(victim.state(), QProcess::NotRunning, longestWait);
        QList<QByteArray> lines = victim.readAllStandardOutput().split('\n');
        lines.pop_back(); // perhaps half of one
        lines.removeAll("done");
        if (lines.isEmpty()) {
            ++early;
            continue;
        }
        const auto told = static_cast<std::size_t>(lines.size()) - 1;
        QVERIFY(states[told] == stateIn(lines.back()));
        const auto found = core::replayJournal(onlyFolderIn(root));
        QVERIFY2(found, "nothing comes back");
        const State state = stateOf(*found);
        const bool isExact = state == states[told], isNext = told + 1 < states.size() && state == states[told + 1];
        QVERIFY2(isExact || isNext, qPrintable(QStringLiteral("after %1 changes").arg(told)));
        QVERIFY(core::checkMesh(core::extractMesh(*found->mesh)).printReady());
        ++(isExact ? exact : next);
        fs::remove_all(root);
    }
    qInfo("%d kills: %d before the model was there, %d at the change told of last, %d at the one after it", kills, early, exact, next);
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
        QSignalSpy offers(&session.shelf, &JournalShelf::offered);
        session.shelf.look();
        QTRY_COMPARE(offers.size(), 1);
        const auto offer = offers[0][0].value<RecoveryOffer>();
        QVERIFY(offer.id != 0);
        QCOMPARE(offer.steps, left.present);
        QSignalSpy opened(&session.document, &Document::opened);
        session.document.recover(offer.id, offer.name);
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, longestWait);
        session.wait();
        QVERIFY(session.state() == left);
        QVERIFY(session.document.isModified());
        QCOMPARE(offers.size(), 2);
        QCOMPARE(offers[1][0].value<RecoveryOffer>().id, quint64(0));
        // As far as it goes, back and forth again, and on.
        session.document.goTo(0);
        QCOMPARE(session.document.undoStack().index(), session.document.history().firstIndex());
        session.document.goTo(left.present);
        QVERIFY(session.state() == left);
        StrokeFuzzer random(5);
        for (int i = 0; i < 5; ++i)
            session.act(random);
        last = session.state();
        const fs::path folder = session.document.journal()->folder();
        const auto again = core::replayJournal(folder);
        QVERIFY(again && stateOf(*again) == last);
    }
    QVERIFY(fs::is_empty(root)); // both documents were given up in order
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
        session.document.save(file);
        session.wait();
        QVERIFY(!session.document.isModified());
        session.document.journal()->flush();
        const auto found = core::replayJournal(session.document.journal()->folder());
        QVERIFY(found && !found->isUnsaved());
        QCOMPARE(QString::fromStdString(found->document.path), file);
        session.document.undo();
        session.wait();
        session.state();
        const auto later = core::replayJournal(session.document.journal()->folder());
        QVERIFY(later && later->isUnsaved());
    }
}

void TestRecovery::discarded_isNeverOfferedAgain()
{
    const fs::path root = newRoot();
    leaveJournal(root, 6, 10);
    leaveJournal(root, 7, 10);
    {
        JournalShelf shelf(root);
        QSignalSpy offers(&shelf, &JournalShelf::offered);
        shelf.look();
        QTRY_COMPARE(offers.size(), 1);
        shelf.discard(offers[0][0].value<RecoveryOffer>().id);
        QCOMPARE(offers.size(), 2);
        QVERIFY(offers[1][0].value<RecoveryOffer>().id != 0); // the other one
    }
    {
        JournalShelf shelf(root);
        QSignalSpy offers(&shelf, &JournalShelf::offered);
        shelf.look();
        QTRY_COMPARE(offers.size(), 1);
        shelf.discard(offers[0][0].value<RecoveryOffer>().id);
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
        QTRY_COMPARE(std::distance(fs::directory_iterator(root), {}), 1); // the model before is given up
    }
    QVERIFY(fs::is_empty(root));
}

void TestRecovery::earlierVersions_areKeptIfAskedFor()
{
    const QTemporaryDir home;
    const QString file = home.filePath(QStringLiteral("ball.ply"));
    const auto kept = [&](int version) { return core::KeptVersion::nameOf(file.toStdU16String(), version); };
    Session session(newRoot());
    session.openBall();
    for (int i = 0; i < 6; ++i) { // the last four with the wish
        ui::Settings().setPreferences({.keepsVersions = i >= 2});
        session.apply(core::Fill{{static_cast<std::uint8_t>(i), 0, 0}});
        session.document.save(file);
        session.wait();
        QVERIFY(i >= 2 || !fs::exists(kept(1)));
    }
    ui::Settings().setPreferences({});
    for (int version = 1; version <= 3; ++version)
        QCOMPARE(core::readMesh(kept(version)).colors.at(0).r, std::uint8_t(5 - version));
    QVERIFY(!fs::exists(kept(4)));
}

void TestRecovery::another_program_isLeftAlone()
{
    const fs::path root = newRoot();
    QProcess victim;
    startVictim(victim, root, 8, 100'000);
    QVERIFY(victim.waitForReadyRead(longestWait));
    QTest::qWait(200);
    {
        Session session(root);
        QSignalSpy offers(&session.shelf, &JournalShelf::offered);
        session.shelf.look();
        QTRY_COMPARE(offers.size(), 1);
        QCOMPARE(offers[0][0].value<RecoveryOffer>().id, quint64(0));
        session.openBall();
        session.apply(core::Fill{red});
    }
    QCOMPARE(victim.state(), QProcess::Running);
    victim.kill();
    QVERIFY(victim.waitForFinished(longestWait));
    const auto found = core::replayJournal(onlyFolderIn(root));
    QVERIFY(found && found->history.present > 0);
    // Two that start at once: one of them offers it.
    const auto first = core::JournalFolder::abandoned(root), second = core::JournalFolder::abandoned(root);
    QCOMPARE(first.size(), std::size_t(1));
    QVERIFY(second.empty());
}

void TestRecovery::fullDisk_isSaidOnceAndLosesNoWork()
{
    if (!smallDisk->isThere())
        QSKIP("This system does not let the test have a small disk.");
    Session session(smallDisk->folder() / "journals");
    QSignalSpy notices(&session.document, &Document::noticed);
    const auto head = core::Starter::Cube;
    session.document.openStarter(head);
    session.wait();
    const bool hasBegun = session.document.journal() != nullptr;
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
    QVERIFY(session.document.undoStack().count() > 3);
    session.document.goTo(0);
    QVERIFY(session.state().state == states.front().state);
    if (hasBegun) {
        const auto found = core::replayJournal(session.document.journal()->folder());
        QVERIFY(found && std::ranges::find(states, found->mesh->stateHash(), &State::state) != states.end());
    }
    session.openBall(); // there is no room for that, either, and it is not said again
    for (const auto& notice : notices)
        told -= notice[0].toString().contains(QStringLiteral("disk is full"));
    QCOMPARE(told, 0);
}

void TestRecovery::closedFolder_isSaidOnce()
{
    const fs::path root = newRoot();
    fs::create_directories(root);
    fs::permissions(root, fs::perms::owner_read | fs::perms::owner_exec);
    Session session(root);
    QSignalSpy notices(&session.document, &Document::noticed);
    session.openBall();
    session.apply(core::Fill{red});
    session.openBall();
    QVERIFY(!session.document.journal());
    QCOMPARE(notices.size(), 1);
    QVERIFY2(notices[0][0].toString().contains(QStringLiteral("not permitted")), qPrintable(notices[0][0].toString()));
    fs::permissions(root, fs::perms::owner_all);
}

QByteArray TestRecovery::killDisplayOf(const fs::path& root, const QString& changes)
{
    XServer display;
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DISPLAY"), QString::fromLatin1(display.name()));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    victim.setProcessEnvironment(environment);
    victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--window"), QString::fromStdString(root.string()), changes});
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
    QVERIFY2(word.contains("are kept, and offered at the next start"), word.constData());
    const auto found = core::replayJournal(onlyFolderIn(root));
    QVERIFY(found && found->isUnsaved());
    QVERIFY(found->mesh->color(0) == red);
}

void TestRecovery::lostDisplay_withoutChangesKeepsNothing()
{
    const fs::path root = newRoot();
    const QByteArray word = killDisplayOf(root, QStringLiteral("unchanged"));
    QVERIFY2(!word.contains("kept") && !word.contains("not ready"), word.constData());
    JournalShelf shelf(root);
    QSignalSpy offers(&shelf, &JournalShelf::offered);
    shelf.look();
    QTRY_COMPARE(offers.size(), 1);
    QCOMPARE(offers[0][0].value<RecoveryOffer>().id, quint64(0));
    QVERIFY(fs::is_empty(root));
}

int main(int argc, char* argv[])
{
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_recovery"));
    const auto is = [&](int count, const char* word) { return argc == count && qstrcmp(argv[1], word) == 0; };
    if (is(4, "--window")) {
        const QApplication application(argc, argv);
        return runOnDisplay(argv[2], qstrcmp(argv[3], "changed") == 0);
    }
    const bool isVictim = is(5, "--victim");
    if (!isVictim) { // before there are threads
        places::obeyPermissions();
        smallDisk = std::make_unique<places::SmallDisk>(fs::temp_directory_path() / ("fettle-journal-" + std::to_string(QCoreApplication::applicationPid())));
    }
    const QCoreApplication application(argc, argv);
    if (isVictim)
        return runVictim(argv[2], QByteArray(argv[3]).toULongLong(), QByteArray(argv[4]).toInt());
    TestRecovery test;
    const int status = QTest::qExec(&test, argc, argv);
    smallDisk.reset();
    return status;
}
#include "tst_recovery.moc"
