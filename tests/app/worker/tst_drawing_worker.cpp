#include "app/worker/drawing_worker.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/test_main.h"
#include "ui/util/thread_mailbox.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
std::shared_ptr<core::Sculptor> ball(int subdivisions)
{
    return std::make_shared<core::Sculptor>(core::buildMesh(core::icosphere(subdivisions, 50)).mesh);
}

/// The mesh thread with a ball, the drawing thread, and the received results. Signals of the threads arrive as events.
struct Studio
{
    explicit Studio(int subdivisions = 4)
    {
        QObject::connect(&drawings, &DrawingWorker::drawn, &here, [this](const auto& drawing) {
            ++count;
            last = drawing;
        });
        QObject::connect(&drawings, &DrawingWorker::refused, &here,
                         [this](const QString& sentence) { refused << sentence; });
        QObject::connect(&drawings, &DrawingWorker::noticed, &here,
                         [this](const QString& sentence) { noticed << sentence; });
        worker.setModel(ball(subdivisions));
    }
    ~Studio() { worker.stop(); }

    void pull()
    {
        core::StrokeSettings settings;
        settings.radius = 15;
        worker.strokes().beginStroke(Source::Desktop, settings);
        for (int i = 0; i < 10; ++i) {
            core::StrokeSample sample;
            sample.position = {0, 50, 0};
            sample.direction = {0, -1, 0};
            worker.strokes().addSample(Source::Desktop, sample);
        }
        worker.strokes().endStroke(Source::Desktop);
    }

    double height() const { return last ? last->box.sizes().y() : 0; }

    double pixelsAlong() const { return last->box.sizes().maxCoeff() / static_cast<double>(last->pixel); }

    QObject here;
    SculptWorker worker;
    DrawingWorker drawings{&worker};
    int count = 0;
    std::shared_ptr<const core::LineDrawing> last;
    QStringList refused, noticed;
};

QByteArray content(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace

class TestDrawingWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itFollowsStrokesWhileItIsWatched()
    {
        Studio studio;
        studio.drawings.watch(true, false);
        QTRY_VERIFY(studio.last);
        QVERIFY(std::abs(studio.height() - 100) < 1);
        QCOMPARE(studio.drawings.latencyMs(), 0.0);
        studio.pull();
        QTRY_VERIFY(studio.height() > 101);
        QTRY_VERIFY(!studio.last->isInterim);
        QVERIFY(studio.drawings.latencyMs() > 0);
    }

    void nobodyLooksNothingIsDrawn()
    {
        Studio studio;
        studio.pull();
        studio.drawings.watch(true, false);
        QTRY_VERIFY(studio.height() > 101); // earlier changes are in the drawing
        studio.drawings.watch(false, false);
        bool isDone = false;
        ui::ThreadMailbox mail;
        studio.worker.post([&](core::Sculptor&) { mail.post([&isDone] { isDone = true; }); });
        QTRY_VERIFY(isDone);
        const int before = studio.count;
        studio.pull();
        QTest::qWait(200);
        QCOMPARE(studio.count, before);
        studio.drawings.watch(true, true);
        QTRY_VERIFY(studio.count > before);
        QVERIFY(!studio.last->views[0].shaded.pixels.empty());
    }

    void colorsComeWhenTheyAreAskedFor()
    {
        Studio studio;
        studio.drawings.watch(true, false);
        QTRY_VERIFY(studio.last);
        QVERIFY(studio.last->views[0].shaded.pixels.empty());
        studio.drawings.watch(true, true);
        QTRY_VERIFY(!studio.last->views[0].shaded.pixels.empty());
    }

    void anotherModelIsDrawnAnew()
    {
        Studio studio;
        studio.drawings.watch(true, false);
        studio.pull();
        QTRY_VERIFY(studio.height() > 101);
        studio.worker.setModel(ball(2));
        QTRY_VERIFY(studio.height() <= 100);
    }

    void coarseWhileTheHandWorksThenFine()
    {
        Studio studio(7);
        studio.drawings.watch(true, true);
        QTRY_VERIFY(studio.last && !studio.last->isInterim);
        const double fine = studio.pixelsAlong();
        studio.pull();
        QTRY_VERIFY(studio.last->isInterim);
        QVERIFY(studio.pixelsAlong() < 0.7 * fine);
        QTRY_VERIFY(studio.height() > 101 && !studio.last->isInterim);
        QVERIFY(std::abs(studio.pixelsAlong() - fine) < 1);
    }

    void sheetsAreOfTheModelAsItIs()
    {
        const QTemporaryDir folder;
        Studio studio;
        studio.pull();
        const QString path = folder.filePath(QStringLiteral("ball.svg"));
        studio.drawings.exportTo(path, QStringLiteral("my ball"), false);
        QTRY_COMPARE(studio.noticed.size(), 1);
        QVERIFY(studio.noticed[0].contains(QStringLiteral("ball.svg")));
        QVERIFY(content(path).contains("my ball"));
        QVERIFY(!content(path).contains("100.0 × 100.0")); // the ball was pulled, so it is no longer 100 mm wide
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void whatCannotBeWrittenIsSaidInOneSentence()
    {
        const QTemporaryDir folder;
        Studio studio;
        studio.drawings.exportTo(folder.filePath(QStringLiteral("a.doc")), {}, false);
        QCOMPARE(studio.refused.size(), 1);
        studio.drawings.exportTo(folder.filePath(QStringLiteral("none/a.pdf")), {}, false);
        QTRY_COMPARE(studio.refused.size(), 2);
        QVERIFY(studio.refused[1].contains(QStringLiteral("a.pdf")));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void itEndsWhileItDraws()
    {
        Studio studio(7);
        studio.drawings.watch(true, true);
        studio.pull();
        QTest::qWait(50);
    }
};

FETTLE_TEST(TestDrawingWorker, QApplication)
#include "tst_drawing_worker.moc"
