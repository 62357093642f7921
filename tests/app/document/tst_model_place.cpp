#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/ask_worker.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "ui/model/insert_request.h"

#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace app;
using core::Vec3;

namespace
{
using Corner = std::array<float, 3>;
constexpr double radius = 15;

std::set<Corner> cornersOf(const core::TriangleMesh& mesh)
{
    std::set<Corner> corners;
    for (const core::Vec3f& p : mesh.points)
        corners.insert({p.x(), p.y(), p.z()});
    return corners;
}

/// Returns a ball with coordinates in multiples of 2^-10 mm, which files and lattices store exactly at all places used
/// here.
core::TriangleMesh ballAt(const Vec3& place)
{
    core::TriangleMesh ball = core::icosphere(4, radius);
    for (core::Vec3f& p : ball.points)
        p = core::Lattice(10).snap(p.cast<double>() + place);
    return ball;
}

core::TriangleMesh read(const QString& path)
{
    return core::readMesh(path.toStdString());
}

core::Box boxIn(const QString& path)
{
    return core::boxOf(read(path));
}

struct PlacedSession
{
    explicit PlacedSession(const QString& path)
    {
        document.opener().open(path);
        wait();
    }

    void wait()
    {
        QTRY_VERIFY(!document.job().isBusy() && document.queue().isSettled());
        app::settle(worker);
    }

    void apply(const core::ModelCommand& command)
    {
        document.changer().apply(command);
        wait();
    }

    /// Raises the top of the ball in z.
    void stroke()
    {
        core::StrokeSettings settings;
        settings.radius = 5;
        core::StrokeSample sample;
        sample.position = {0, 0, radius};
        document.strokes().beginStroke(settings);
        document.strokes().addSample(sample);
        document.strokes().endStroke();
        wait();
    }

    void save(const QString& path)
    {
        document.saver().save(path);
        wait();
        QCOMPARE(document.modelInfo().path, path);
    }

    std::pair<std::uint64_t, core::MeshFrame> state()
    {
        return ask(worker, [](core::Sculptor& sculptor) {
            return std::pair(sculptor.mesh().meshHash(), sculptor.mesh().frame());
        });
    }

    core::Box box()
    {
        return ask(worker, [](core::Sculptor& sculptor) { return core::boxOf(core::extractMesh(sculptor.mesh())); });
    }

    SculptWorker worker;
    Document document{&worker};
};
} // namespace

/// Tests that files written later keep the coordinates of the model's file, although the document shows the model at
/// the origin.
class TestModelPlace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void saved_liesWhereItLay_data();
    void saved_liesWhereItLay();
    void exported_liesWhereItLay();
    void reopened_isTheSame();
    void inserted_liesWhereItsFileHasIt();
    void inserted_atACentreOfTheWindow();
    void recentred_isSavedAtTheOrigin();
    void onTheBed_isSavedOnTheBed();
    void anotherUnit_movesThePlace();
    void repaired_liesWhereItLay();

private:
    QString file(const QString& name) const { return m_folder.filePath(name); }
    QString ballFile(const Vec3& place, const QString& ending = QStringLiteral("stl"))
    {
        const QString path = file(QStringLiteral("ball%1.%2").arg(++m_count).arg(ending));
        core::writeMesh(path.toStdString(), ballAt(place));
        return path;
    }

    QTemporaryDir m_folder;
    int m_count = 0;
};

void TestModelPlace::saved_liesWhereItLay_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<Vec3>("place");
    for (const char* ending : {"stl", "obj", "ply", "off", "3mf", "glb"}) {
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(60, 0, 0), Vec3(125, 105, 15), Vec3(-3000, 2000.5, 1)}) {
            QTest::addRow("%s at %g", ending, place.x()) << QString::fromLatin1(ending) << place;
        }
    }
}

/// Vertices that the stroke did not touch must keep the file's coordinates, bit for bit.
void TestModelPlace::saved_liesWhereItLay()
{
    QFETCH(QString, ending);
    QFETCH(Vec3, place);
    const QString path = ballFile(place, ending);
    const std::set<Corner> before = cornersOf(read(path));
    PlacedSession session(path);
    QVERIFY(session.box().center().norm() < 0.01);
    session.stroke();
    session.save(path);
    const core::TriangleMesh saved = read(path);
    const std::set<Corner> after = cornersOf(saved);
    std::size_t untouched = 0;
    for (const Corner& corner : before) {
        if (static_cast<double>(corner[2]) > place.z() + 5)
            continue;
        ++untouched;
        QVERIFY(after.contains(corner));
    }
    QVERIFY(untouched > before.size() / 2);
    QVERIFY(core::boxOf(saved).max().z() > place.z() + radius + 0.1);
    QVERIFY(core::checkMesh(saved).printReady());
}

void TestModelPlace::exported_liesWhereItLay()
{
    const Vec3 place(60, -7, 20);
    PlacedSession session(ballFile(place));
    for (const quint64 triangles : {0, 500}) {
        for (const char* ending : {"stl", "glb"}) {
            const QString path = file(QStringLiteral("export%1.%2").arg(triangles).arg(QLatin1StringView(ending)));
            session.document.saver().exportTo(path, {.maxTriangles = triangles});
            session.wait();
            QVERIFY((boxIn(path).center() - place).norm() < 0.5);
            PlacedSession again(path);
            QVERIFY(again.box().center().norm() < 0.5);
        }
    }
}

/// A Fettle document is restored exactly, including its place.
void TestModelPlace::reopened_isTheSame()
{
    for (const Vec3& place : {Vec3(60, 0, 0), Vec3(125, 105, 15)}) {
        PlacedSession session(ballFile(place));
        session.stroke();
        const QString path = file(QStringLiteral("own.glb"));
        session.save(path);
        PlacedSession again(path);
        QVERIFY(again.state() == session.state());
        QVERIFY((again.state().second.place - place).norm() < 0.01);
        again.save(file(QStringLiteral("twice.stl")));
        QVERIFY((boxIn(file(QStringLiteral("twice.stl"))).min() - place - Vec3::Constant(-radius)).norm() < 0.1);
    }
}

/// Two parts of an assembly keep the distance that their files give.
void TestModelPlace::inserted_liesWhereItsFileHasIt()
{
    for (const double away : {60, 5000}) {
        PlacedSession session(ballFile({away, 0, 0}));
        session.document.changer().insert({.path = ballFile({away + 35, 0, 0}), .place = core::Insert::Place::AsItIs});
        session.wait();
        QVERIFY(std::abs(session.box().sizes().x() - (35 + 2 * radius)) < 0.01);
        session.save(file(QStringLiteral("both.stl")));
        const core::Box both = boxIn(file(QStringLiteral("both.stl")));
        QVERIFY(std::abs(both.min().x() - (away - radius)) < 0.01 &&
                std::abs(both.max().x() - (away + 35 + radius)) < 0.01);
    }
}

/// The given centre is in the window's coordinates, where the current model is at the origin.
void TestModelPlace::inserted_atACentreOfTheWindow()
{
    const double away = 5000;
    PlacedSession session(ballFile({away, 0, 0}));
    session.document.changer().insert(
        {.path = ballFile({95, 0, 0}), .place = core::Insert::Place::Centre, .centre = {0, 40, 0}});
    session.wait();
    session.save(file(QStringLiteral("two.stl")));
    const core::Box both = boxIn(file(QStringLiteral("two.stl")));
    QVERIFY((both.center() - Vec3(away, 20, 0)).norm() < 0.01 && std::abs(both.sizes().y() - 40 - 2 * radius) < 0.01);
}

void TestModelPlace::recentred_isSavedAtTheOrigin()
{
    const Vec3 place(60, 1, 2);
    PlacedSession session(ballFile(place));
    session.apply(core::Recentre{});
    QVERIFY(session.document.savedState().isModified());
    session.save(file(QStringLiteral("middle.stl")));
    QVERIFY(boxIn(file(QStringLiteral("middle.stl"))).center().norm() < 0.01);
    session.document.history().undo();
    session.wait();
    session.save(file(QStringLiteral("back.stl")));
    QVERIFY((boxIn(file(QStringLiteral("back.stl"))).center() - place).norm() < 0.01);
}

void TestModelPlace::onTheBed_isSavedOnTheBed()
{
    PlacedSession session(ballFile({60, 30, 2}));
    session.apply(core::PlaceOnBed{});
    session.save(file(QStringLiteral("bed.ply")));
    const core::Box box = boxIn(file(QStringLiteral("bed.ply")));
    QVERIFY(std::abs(box.min().y()) < 0.001 && std::abs(box.center().x() - 60) < 0.01);
}

void TestModelPlace::anotherUnit_movesThePlace()
{
    PlacedSession session(ballFile({60, 0, -8}));
    session.apply(core::Scale{25.4});
    session.save(file(QStringLiteral("inches.stl")));
    QVERIFY((boxIn(file(QStringLiteral("inches.stl"))).center() - 25.4 * Vec3(60, 0, -8)).norm() < 0.01);
}

/// A repaired model keeps the coordinates of its file, even far from the origin.
void TestModelPlace::repaired_liesWhereItLay()
{
    for (const Vec3& place : {Vec3(60, 0, 0), Vec3(500, 0, 0)}) {
        core::TriangleMesh open = ballAt(place);
        open.triangles.pop_back();
        const QString path = file(QStringLiteral("open.ply"));
        core::writeMesh(path.toStdString(), open);
        PlacedSession session(ballFile({0, 0, 0}));
        session.document.opener().openRepaired(path, {});
        session.wait();
        session.save(file(QStringLiteral("whole.ply")));
        QVERIFY((boxIn(file(QStringLiteral("whole.ply"))).center() - place).norm() < 0.01);
        QVERIFY(core::checkMesh(read(file(QStringLiteral("whole.ply")))).printReady());
    }
}

FETTLE_TEST(TestModelPlace, QCoreApplication)
#include "tst_model_place.moc"
