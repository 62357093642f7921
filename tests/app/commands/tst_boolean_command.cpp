// Runs `fettle boolean` as a script does.
#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

using namespace core;

namespace
{
struct BooleanAnswer
{
    int status = -1;
    QByteArray out;
    QString err;
};

/// Runs the command in a folder. `input`: its standard input.
BooleanAnswer boolean(const QString& folder, const QString& line, const QByteArray& input = {})
{
    QProcess program;
    program.setWorkingDirectory(folder);
    program.start(QStringLiteral(FETTLE_PROGRAM),
                  QStringList(QStringLiteral("boolean")) + QProcess::splitCommand(line));
    program.write(input);
    program.closeWriteChannel();
    if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
        return {};
    return {program.exitCode(), program.readAllStandardOutput(), QString::fromUtf8(program.readAllStandardError())};
}
} // namespace

class TestBooleanCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void operations_haveTheirVolumes_data();
    void operations_haveTheirVolumes();
    void unitAndUpAxis_areThoseOfTheFiles();
    void standardFiles_areReadAndWritten();
    void nothingLeft_isStatusOne_data();
    void nothingLeft_isStatusOne();
    void bad_isOneSentence_data();
    void bad_isOneSentence();
    void noClobber_keepsAFile();

private:
    BooleanAnswer run(const QString& line, const QByteArray& input = {}) const
    {
        return boolean(m_folder->path(), line, input);
    }
    QString at(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    TriangleMesh read(const char* name) const { return readMesh(at(name).toStdString()); }
    void write(const char* name, const TriangleMesh& mesh) const { writeMesh(at(name).toStdString(), mesh); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

/// Writes cubes of side 2 away from the origin: a and b overlap, b and c overlap, a and c touch at a corner.
void TestBooleanCommand::init()
{
    const Vec3f away(41, 11, -19); // centre of a, whose lower corner is (40, 10, -20)
    m_folder = std::make_unique<QTemporaryDir>();
    write("a.obj", shapes::moved(shapes::cube(2), away));
    write("b.obj", shapes::moved(shapes::cube(2), away + Vec3f(1, 1, 1)));
    write("c.obj", shapes::moved(shapes::cube(2), away + Vec3f(2, 2, 2)));
    write("open.stl", shapes::openCone(12));
}

void TestBooleanCommand::operations_haveTheirVolumes_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<double>("volume");
    QTest::addColumn<Vec3>("low");
    QTest::addColumn<Vec3>("high");
    const Vec3 away(40, 10, -20);
    QTest::newRow("union") << "union a.obj b.obj" << 15.0 << away << Vec3(away + Vec3(3, 3, 3));
    QTest::newRow("three") << "union a.obj b.obj c.obj" << 22.0 << away << Vec3(away + Vec3(4, 4, 4));
    QTest::newRow("subtract") << "subtract a.obj b.obj" << 7.0 << away << Vec3(away + Vec3(2, 2, 2));
    QTest::newRow("intersect") << "intersect a.obj b.obj" << 1.0 << Vec3(away + Vec3(1, 1, 1))
                               << Vec3(away + Vec3(2, 2, 2));
    QTest::newRow("the same twice") << "union a.obj a.obj" << 8.0 << away << Vec3(away + Vec3(2, 2, 2));
}

/// Compares volume and place of the result, in each format.
void TestBooleanCommand::operations_haveTheirVolumes()
{
    QFETCH(const QString, line);
    QFETCH(const double, volume);
    QFETCH(const Vec3, low);
    QFETCH(const Vec3, high);
    for (const char* out : {"out.obj", "out.stl", "out.glb", "out.3mf"}) {
        const BooleanAnswer answer = run(line + QStringLiteral(" -o ") + QString::fromUtf8(out));
        QVERIFY2(answer.status == 0 && answer.err.isEmpty(), qPrintable(answer.err));
        QCOMPARE(answer.out.count('\n'), 1);
        QVERIFY2(answer.out.startsWith(out) && answer.out.contains(" mm"), answer.out.constData());
        const TriangleMesh mesh = read(out);
        const auto verdict = judgedByCgal(mesh);
        QVERIFY(verdict && verdict->allWell());
        QVERIFY(std::abs(checkMesh(mesh).volume.value() - volume) < 1e-4);
        const Box box = boxOf(mesh);
        QVERIFY((box.min() - low).norm() < 1e-4 && (box.max() - high).norm() < 1e-4);
    }
}

void TestBooleanCommand::unitAndUpAxis_areThoseOfTheFiles()
{
    QCOMPARE(run(QStringLiteral("union a.obj b.obj -o in.obj --unit in")).status, 0);
    QVERIFY((boxOf(read("in.obj")).sizes() - 25.4 * Vec3(3, 3, 3)).norm() < 1e-3);
    QCOMPARE(run(QStringLiteral("union a.obj b.obj -o turned.obj --up z")).status, 0);
    const Vec3 low = boxOf(read("turned.obj")).min(), expected(40, -20, -13); // (x, z, -y)
    QVERIFY2((low - expected).norm() < 1e-4,
             qPrintable(QStringLiteral("%1 %2 %3").arg(low.x()).arg(low.y()).arg(low.z())));
}

void TestBooleanCommand::standardFiles_areReadAndWritten()
{
    QFile file(at("b.obj"));
    QVERIFY(file.open(QFile::ReadOnly));
    const BooleanAnswer answer = run(QStringLiteral("intersect a.obj - -o - --from obj --to off"), file.readAll());
    QCOMPARE(answer.status, 0);
    QVERIFY(answer.out.startsWith("OFF"));
    QCOMPARE(answer.err.count(u'\n'), 1); // the line about the result
}

void TestBooleanCommand::nothingLeft_isStatusOne_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("words");
    QTest::newRow("no common space") << "intersect a.obj c.obj"
                                     << "no space in common";
    QTest::newRow("itself") << "subtract a.obj a.obj"
                            << "Nothing is left of a.obj";
}

void TestBooleanCommand::nothingLeft_isStatusOne()
{
    QFETCH(const QString, line);
    QFETCH(const QString, words);
    const BooleanAnswer answer = run(line + QStringLiteral(" -o out.stl"));
    QCOMPARE(answer.status, 1);
    QVERIFY(answer.out.isEmpty() && answer.err.count(u'\n') == 1);
    QVERIFY2(answer.err.contains(words), qPrintable(answer.err));
    QVERIFY(!QFile::exists(at("out.stl")));
}

void TestBooleanCommand::bad_isOneSentence_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("words");
    QTest::newRow("no operation") << "-o out.stl"
                                  << "the operation is missing: one of union, subtract, intersect";
    QTest::newRow("another operation") << "cut a.obj b.obj -o out.stl"
                                       << "\"cut\" is not an operation";
    QTest::newRow("mistyped") << "unoin a.obj b.obj -o out.stl"
                              << "Did you mean union?";
    QTest::newRow("one model") << "union a.obj -o out.stl"
                               << "needs two models or more; 1 was given";
    QTest::newRow("no output") << "union a.obj b.obj"
                               << "name it with -o";
    QTest::newRow("ending") << "union a.obj b.obj -o out.txt"
                            << "cannot tell the format";
    QTest::newRow("missing") << "union a.obj none.obj -o out.stl"
                             << "none.obj";
    QTest::newRow("open") << "union a.obj open.stl -o out.stl"
                          << "open.stl cannot be combined";
    QTest::newRow("how to repair") << "union a.obj open.stl -o out.stl"
                                   << "fettle convert --repair";
    QTest::newRow("format of -") << "union a.obj - -o out.stl"
                                 << "--from";
    QTest::newRow("folder") << "union a.obj b.obj -o nowhere/out.stl"
                            << "nowhere";
}

void TestBooleanCommand::bad_isOneSentence()
{
    QFETCH(const QString, line);
    QFETCH(const QString, words);
    const BooleanAnswer answer = run(line);
    QCOMPARE(answer.status, 2);
    QVERIFY(answer.out.isEmpty());
    QVERIFY2(answer.err.count(u'\n') == 1 && answer.err.contains(words), qPrintable(answer.err));
    QVERIFY(!QFile::exists(at("out.stl")));
}

void TestBooleanCommand::noClobber_keepsAFile()
{
    const BooleanAnswer answer = run(QStringLiteral("union a.obj b.obj -o c.obj --no-clobber"));
    QCOMPARE(answer.status, 2);
    QVERIFY2(answer.err.contains(QStringLiteral("already exists")), qPrintable(answer.err));
    QVERIFY(std::abs(checkMesh(read("c.obj")).volume.value() - 8) < 1e-6);
}

FETTLE_TEST(TestBooleanCommand, QCoreApplication)
#include "tst_boolean_command.moc"
