#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"

#include "app/document/history_visit.h"
#include "app/document/time_lapse.h"

#include "ui/history/time_lapse_dialog.h"
#include "ui/util/thread_mailbox.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QImage>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace app;

namespace
{
QStringList filesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The window with a ball and a number of strokes.
struct Studio
{
    explicit Studio(int strokes)
    {
        program.window.resize(1000, 700);
        program.window.show();
        program.document.opener().setDiscardPrompt({});
        program.document.opener().openBall();
        rest();
        for (int i = 0; i < strokes; ++i) {
            core::StrokeSettings settings;
            settings.radius = 14;
            settings.strength = 2;
            core::StrokeSample sample;
            sample.position = 50 * core::Vec3(std::cos(i), std::sin(i), 0.8).normalized();
            program.document.strokes().beginStroke(settings);
            program.document.strokes().addSample(sample);
            program.document.strokes().endStroke();
            rest();
        }
    }

    void rest()
    {
        QTRY_VERIFY(!program.document.job().isBusy() && program.document.queue().isSettled() &&
                    program.document.modelInfo().faces > 0);
    }

    std::uint64_t state()
    {
        rest();
        return stateHash(program.worker);
    }

    /// Draws the time lapse as the menu command does, with small pictures. `stops`: cancels after the first picture.
    TimeLapseOutcome draw(const QString& folder, int every = 1, bool stops = false)
    {
        TimeLapseOutcome outcome;
        bool isDone = false;
        TimeLapseRequest request{folder, every,
                                 core::viewOf({core::Vec3::Constant(-60), core::Vec3::Constant(60)}, 96, 54)};
        const bool began = visitHistory(
            program.document, QStringLiteral("Drawing"),
            [&](const ModelHistory& history, core::JobControl control) {
                std::stop_source stop;
                if (stops)
                    control = {stop.get_token(), [&stop](double) { stop.request_stop(); }};
                outcome = TimeLapse::run(request, history, control);
            },
            [&isDone] { isDone = true; });
        [&] { QTRY_VERIFY(began && isDone); }();
        return outcome;
    }

    Program program;
};
} // namespace

class TestTimeLapse : public QObject
{
    Q_OBJECT

public:
    static const places::SmallDisk* disk;

private Q_SLOTS:
    void itHasAPictureOfEachState();
    void everyFewSteps_data();
    void everyFewSteps();
    void whatIsThereIsNotWrittenOver();
    void whoStopsHasNothing();
    void placesThatCannotBeWritten_areOneSentence();
    void aFullDisk_leavesNothing();
    void handsRestMeanwhile();
    void byTheMenu();
    void byTheCommandLine();
};

const places::SmallDisk* TestTimeLapse::disk = nullptr;

void TestTimeLapse::itHasAPictureOfEachState()
{
    const QTemporaryDir whole, part;
    Studio s(6);
    s.program.document.history().undo();
    const std::uint64_t state = s.state();
    const bool isModified = s.program.document.savedState().isModified();
    const TimeLapseOutcome outcome = s.draw(whole.path());
    QCOMPARE(outcome.problem, QString());
    QCOMPARE(outcome.frames, 6); // the start and five strokes; undone steps are not shown
    QCOMPARE(filesIn(whole.path()), TimeLapse::frameNames(0, 5, 1));
    QSet<QByteArray> pictures;
    for (const QString& name : filesIn(whole.path())) {
        const QImage image(whole.filePath(name));
        QCOMPARE(image.size(), QSize(96, 54));
        QVERIFY(!image.hasAlphaChannel());
        QVERIFY(image.pixel(48, 27) != image.pixel(0, 0));
        pictures << contentOf(whole.filePath(name));
    }
    QCOMPARE(pictures.size(), 6); // every stroke changes the picture
    QCOMPARE(s.state(), state);
    QCOMPARE(s.program.document.history().stack().index(), 5);
    QCOMPARE(s.program.document.history().stack().count(), 6);
    QCOMPARE(s.program.document.savedState().isModified(), isModified);

    s.program.document.history().goTo(2); // a model of an earlier state is drawn up to that state only
    s.rest();
    QCOMPARE(s.draw(part.path()).frames, 3);
    for (const QString& name : filesIn(part.path()))
        QCOMPARE(contentOf(part.filePath(name)), contentOf(whole.filePath(name)));
    s.program.document.history().goTo(6);
    QVERIFY(s.state() != state);
}

void TestTimeLapse::everyFewSteps_data()
{
    QTest::addColumn<int>("every");
    QTest::addColumn<QList<int>>("states");
    QTest::newRow("2") << 2 << QList<int>{0, 2, 4, 5};
    QTest::newRow("3") << 3 << QList<int>{0, 3, 5};
    QTest::newRow("5") << 5 << QList<int>{0, 5};
    QTest::newRow("99") << 99 << QList<int>{0, 5};
}

void TestTimeLapse::everyFewSteps()
{
    QFETCH(int, every);
    QFETCH(QList<int>, states);
    const QTemporaryDir all, some;
    Studio s(5);
    s.draw(all.path());
    QCOMPARE(s.draw(some.path(), every).frames, states.size());
    const QStringList names = filesIn(some.path()), allNames = filesIn(all.path());
    QCOMPARE(names.size(), states.size());
    for (qsizetype i = 0; i < names.size(); ++i)
        QCOMPARE(contentOf(some.filePath(names[i])), contentOf(all.filePath(allNames[states[i]])));
}

void TestTimeLapse::whatIsThereIsNotWrittenOver()
{
    const QTemporaryDir folder;
    Studio s(2);
    QFile file(folder.filePath(QStringLiteral("frame-0002.png")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("mine");
    file.close();
    const TimeLapseOutcome outcome = s.draw(folder.path());
    QVERIFY2(outcome.problem.contains(QStringLiteral("frame-0002.png")), qPrintable(outcome.problem));
    QCOMPARE(filesIn(folder.path()), QStringList{QStringLiteral("frame-0002.png")});
    QCOMPARE(contentOf(file.fileName()), QByteArray("mine"));
}

void TestTimeLapse::whoStopsHasNothing()
{
    const QTemporaryDir folder;
    Studio s(8);
    const std::uint64_t state = s.state();
    const TimeLapseOutcome outcome = s.draw(folder.path(), 1, true);
    QVERIFY(outcome.problem.isEmpty());
    QCOMPARE(outcome.frames, 0);
    QCOMPARE(filesIn(folder.path()), QStringList());
    QCOMPARE(s.state(), state);
}

void TestTimeLapse::placesThatCannotBeWritten_areOneSentence()
{
    const QTemporaryDir folder;
    Studio s(1);
    const QString gone = folder.filePath(QStringLiteral("gone"));
    TimeLapseOutcome outcome = s.draw(gone);
    QVERIFY2(outcome.problem.contains(gone) && outcome.frames == 0, qPrintable(outcome.problem));
    const QString closed = folder.filePath(QStringLiteral("closed"));
    QVERIFY(QDir().mkdir(closed) && QFile::setPermissions(closed, QFile::ReadOwner | QFile::ExeOwner));
    outcome = s.draw(closed);
    QVERIFY2(outcome.problem.contains(closed) && outcome.problem.endsWith(QLatin1Char('.')) && outcome.frames == 0,
             qPrintable(outcome.problem));
    QCOMPARE(filesIn(closed), QStringList());
}

void TestTimeLapse::aFullDisk_leavesNothing()
{
    if (!disk->isThere())
        QSKIP("The system forbids to mount.");
    Studio s(3);
    const std::uint64_t state = s.state();
    const QString folder = QString::fromStdString(disk->folder().string());
    disk->fill();
    const TimeLapseOutcome outcome = s.draw(folder);
    QVERIFY(!outcome.problem.isEmpty() && outcome.frames == 0);
    QCOMPARE(filesIn(folder), QStringList{QStringLiteral("filler")});
    QCOMPARE(s.state(), state);
}

void TestTimeLapse::handsRestMeanwhile()
{
    const QTemporaryDir folder;
    Studio s(3);
    bool isDone = false;
    std::atomic<bool> mayGoOn = false;
    QVERIFY(visitHistory(
        s.program.document, QStringLiteral("Drawing"),
        [&](const ModelHistory&, const core::JobControl&) {
            while (!mayGoOn)
                std::this_thread::yield();
        },
        [&isDone] { isDone = true; }));
    QVERIFY(!visitHistory(s.program.document, {}, {}, {}));
    QTRY_VERIFY(!s.program.worker.strokes().beginStroke(Source::Headset, {}));
    s.program.document.history().undo(); // undo waits for the end of the time lapse
    QCOMPARE(s.program.document.history().stack().index(), 3);
    mayGoOn = true;
    QTRY_VERIFY(isDone);
    QTRY_COMPARE(s.program.document.history().stack().index(), 2);
}

void TestTimeLapse::byTheMenu()
{
    const QTemporaryDir folder;
    Studio s(3);
    s.program.window.action(QStringLiteral("file.timeLapse"))->trigger();
    auto* dialog = s.program.window.findChild<QDialog*>(QStringLiteral("timeLapse"));
    QVERIFY(dialog && dialog->isVisible());
    auto* size = dialog->findChild<QComboBox*>();
    size->setCurrentIndex(1);
    const QSize chosen = size->currentData().toSize();
    dialog->findChild<QSpinBox*>()->setValue(2);
    QVERIFY(dialog->findChild<QLabel*>(QStringLiteral("frameCount"))->text().contains(QStringLiteral("3")));
    dialog->accept();
    chooseFile(s.program, "folderDialog", folder.path());
    QTRY_COMPARE(filesIn(folder.path()).size(), 3);
    s.rest();
    QTRY_VERIFY(notice(s.program).contains(QStringLiteral("3")));
    for (const QString& name : filesIn(folder.path()))
        QCOMPARE(QImage(folder.filePath(name)).size(), chosen);
}

void TestTimeLapse::byTheCommandLine()
{
    const QTemporaryDir folder;
    QFile strokes(folder.filePath(QStringLiteral("s.json")));
    QVERIFY(strokes.open(QIODevice::WriteOnly));
    strokes.write(R"({"format": "fettle-strokes", "version": 1, "strokes": [
        {"tool": "pull", "radius": 0.4, "strength": 2, "samples": [{"position": [0, 0, 1]}]},
        {"tool": "pull", "radius": 0.4, "strength": 2, "samples": [{"position": [3, 0, 1]}]},
        {"command": "scale", "factor": 1.5},
        {"tool": "push", "radius": 0.6, "strength": 2, "samples": [{"position": [0, 1.5, 0]}]}]})");
    strokes.close();
    const auto run = [&](const QStringList& more) {
        QProcess program;
        program.start(QStringLiteral(FETTLE_PROGRAM),
                      QStringList{QStringLiteral("replay"), QStringLiteral("--strokes"), strokes.fileName()} + more);
        return program.waitForFinished(-1) && program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    };
    const QString frames = folder.filePath(QStringLiteral("frames"));
    QCOMPARE(run({QStringLiteral("--frames"), frames}), 2); // the folder for the pictures does not exist
    QVERIFY(QDir().mkdir(frames));
    QCOMPARE(run({QStringLiteral("--frames"), frames, QStringLiteral("--every"), QStringLiteral("0")}), 2);
    QCOMPARE(run({QStringLiteral("--every"), QStringLiteral("2")}), 2);
    QCOMPARE(filesIn(frames), QStringList());
    QCOMPARE(run({QStringLiteral("--frames"), frames}), 0);
    // commands and strokes that changed nothing have no picture
    QCOMPARE(filesIn(frames), TimeLapse::frameNames(0, 3, 1));
    for (const QString& name : filesIn(frames))
        QCOMPARE(QImage(QDir(frames).filePath(name)).size(), QSize(1280, 720));
    const QByteArray first = contentOf(QDir(frames).filePath(QStringLiteral("frame-0001.png")));
    QCOMPARE(run({QStringLiteral("--frames"), frames}), 2); // the pictures exist already
    QCOMPARE(contentOf(QDir(frames).filePath(QStringLiteral("frame-0001.png"))), first);
}

static int timeLapseMain(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk disk(folder.filePath(QStringLiteral("small")).toStdString());
    places::obeyPermissions();
    TestTimeLapse::disk = &disk;
    return test::run<TestTimeLapse, app::OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestTimeLapse, timeLapseMain)
#include "tst_time_lapse.moc"
