// Runs `fettle convert` and `fettle replay` on files of several objects, and on documents of several parts.
#include "core/analysis/mesh_check.h"
#include "core/analysis/part_overlap.h"
#include "core/io/mesh_io.h"
#include "core/parts/part_split.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>
#include <memory>

using core::Part;
using core::PartId;
using core::PartList;
using core::PartPiece;
using core::ReadResult;
using core::Vec3f;

namespace
{
struct Answer
{
    int status = -1;
    QString out, err;
};
} // namespace

class TestPartCommands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void overlappingObjects_needParts();
    void partsAreOfferedOnlyIfTheyHelp();
    void overlappingParts_areUnited_data();
    void overlappingParts_areUnited();
    void overlappingParts_areKeptIfWished();
    void boolean_unitesOverlappingParts();
    void check_measuresTheUnion();
    void hiddenParts_areInGlbOnly();
    void replay_paintsOneObject();
    void replay_refusesStrokesThatChangeNothing();
    void replay_insertsParts();
    void replay_unitesOverlappingParts();

private:
    Answer run(const QString& line) const
    {
        QProcess program;
        program.setWorkingDirectory(m_folder->path());
        program.start(QStringLiteral(FETTLE_PROGRAM), QProcess::splitCommand(line));
        program.closeWriteChannel();
        if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
            return {};
        return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
                QString::fromUtf8(program.readAllStandardError())};
    }
    std::string at(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)).toStdString(); }
    void writeStrokes(const char* name, const QByteArray& commands) const
    {
        QFile file(QString::fromStdString(at(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format":"fettle-strokes","version":1,"strokes":[)" + commands + "]}");
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

/// Writes three cubes of side 2 as objects of two.3mf: the first two share a space of 1 mm3, the third is hidden in
/// parts.glb and left out of the 3MF.
void TestPartCommands::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    std::vector<PartPiece> pieces;
    for (const float at : {0.0f, 1.0f, 50.0f})
        pieces.push_back(
            {static_cast<PartId>(pieces.size()), shapes::moved(shapes::cube(2), Vec3f(at, at, at)), {}, {}});
    const PartList all({{0, "Low", true, false, {}}, {1, "High", true, false, {}}, {2, "Far", false, false, {}}});
    core::DocumentMetadata metadata;
    metadata.frame.emplace().parts = all;
    core::writeMesh(at("parts.glb"), core::joined(pieces), {.metadata = metadata});
    pieces.pop_back();
    core::writeMesh(at("two.3mf"), core::joined(pieces), {.parts = all.without({2})});
}

void TestPartCommands::overlappingObjects_needParts()
{
    const Answer refused = run(QStringLiteral("convert two.3mf out.glb"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains(QStringLiteral("--parts")), qPrintable(refused.err));
    const Answer done = run(QStringLiteral("convert two.3mf out.glb --parts"));
    QVERIFY2(done.status == 0 && done.err.isEmpty(), qPrintable(done.err));
    const ReadResult read = core::readModel(at("out.glb"), {.keepsObjects = true});
    QCOMPARE(read.parts.size(), std::size_t(2));
    QVERIFY(read.parts.all()[0].name == "Low" && read.parts.all()[1].name == "High");
    QCOMPARE(*core::checkMesh(read.mesh).volume, 16.0);
}

/// Tests that the word --parts appears only where it would make the model sound.
void TestPartCommands::partsAreOfferedOnlyIfTheyHelp()
{
    const core::TriangleMesh one = shapes::cube(2);
    core::TriangleMesh open = shapes::moved(one, Vec3f(1, 1, 1));
    open.triangles.pop_back();
    core::writeMesh(at("surface.stl"), core::readMesh(at("two.3mf")));
    core::writeMesh(at("object.obj"), core::readMesh(at("two.3mf")));
    core::writeMesh(at("open.3mf"), core::joined({{0, one, {}, {}}, {1, open, {}, {}}}));
    std::ofstream obj(at("many.obj"));
    for (int i = 0; i <= int(PartList::maxParts); ++i) {
        obj << "o a\n";
        for (const Vec3f& p : one.points)
            obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        for (const core::Triangle& t : one.triangles)
            obj << "f " << int(t[0]) - 8 << ' ' << int(t[1]) - 8 << ' ' << int(t[2]) - 8 << '\n';
    }
    obj.close();
    for (const char* name : {"surface.stl", "object.obj", "open.3mf", "many.obj"}) {
        const Answer refused = run(QStringLiteral("convert %1 out.glb").arg(QLatin1String(name)));
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.err.contains(QStringLiteral("--repair")) && !refused.err.contains(QStringLiteral("--parts")),
                 qPrintable(refused.err));
        QCOMPARE(run(QStringLiteral("convert %1 out.glb --parts").arg(QLatin1String(name))).status, 1);
    }
    QFile file(QString::fromStdString(at("two.3mf")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QProcess program;
    program.setWorkingDirectory(m_folder->path());
    program.start(QStringLiteral(FETTLE_PROGRAM),
                  QProcess::splitCommand(QStringLiteral("convert - out.glb --from 3mf")));
    program.write(file.readAll());
    program.closeWriteChannel();
    QVERIFY(program.waitForFinished(-1));
    QCOMPARE(program.exitCode(), 1);
    QVERIFY(program.readAllStandardError().contains("--parts"));
}

void TestPartCommands::overlappingParts_areUnited_data()
{
    QTest::addColumn<QString>("out");
    QTest::addColumn<bool>("isUnited");
    for (const std::string_view ending : core::writtenEndings()) {
        const QString name = QStringLiteral("out.") + QString::fromStdString(std::string(ending));
        QTest::addRow("%s", qPrintable(name)) << name << (ending != "obj" && ending != "glb");
    }
}

void TestPartCommands::overlappingParts_areUnited()
{
    QFETCH(const QString, out);
    QFETCH(const bool, isUnited);
    const Answer done = run(QStringLiteral("convert two.3mf %1 --parts").arg(out));
    QVERIFY2(done.status == 0, qPrintable(done.err));
    QCOMPARE(done.out.isEmpty() && done.err.isEmpty(), !isUnited); // it says that they were united
    const ReadResult read = core::readModel(at(qPrintable(out)), {.keepsObjects = true});
    QCOMPARE(read.parts.size(), std::size_t(isUnited ? 1 : 2));
    const core::MeshReport report = core::checkMesh(read.mesh);
    QVERIFY(report.printReady());
    QVERIFY(std::abs(*report.volume - (isUnited ? 15 : 16)) < 1e-5);
    if (isUnited)
        QVERIFY(judgedByCgal(read.mesh)->allWell());
}

void TestPartCommands::overlappingParts_areKeptIfWished()
{
    for (const char* out : {"out.stl", "out.3mf"}) {
        const Answer done = run(QStringLiteral("convert two.3mf %1 --parts --overlaps keep").arg(QLatin1String(out)));
        QVERIFY2(done.status == 0 && done.out.isEmpty() && done.err.isEmpty(), qPrintable(done.err));
        const ReadResult read = core::readModel(at(out), {.keepsObjects = true});
        QCOMPARE(read.mesh.triangles.size(), 2 * shapes::cube(2).triangles.size());
    }
    QCOMPARE(run(QStringLiteral("convert two.3mf out.stl --parts --overlaps melt")).status, 2);
}

/// Tests that the print check of a document measures what an export writes: a plate of 0.5 mm is no thin wall if it is
/// sunk into a block, nor if it is hidden.
void TestPartCommands::check_measuresTheUnion()
{
    const auto thinnest = [this](float below, float above, bool isVisible) {
        core::TriangleMesh plate = shapes::cube(10);
        for (Vec3f& p : plate.points)
            p.y() = p.y() > 0 ? above : below;
        core::DocumentMetadata metadata;
        metadata.frame.emplace().parts =
            PartList({{0, "Block", true, false, std::nullopt}, {1, "Plate", isVisible, false, std::nullopt}});
        core::writeMesh(at("plate.glb"), core::joined({{0, shapes::cube(20), {}, {}}, {1, plate, {}, {}}}),
                        {.metadata = metadata});
        const Answer answer = run(QStringLiteral("check --print --json plate.glb"));
        const QJsonObject json = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        return answer.status == 0 && json[QLatin1StringView("faces")].toInt() == 24
                   ? json[QLatin1StringView("min_wall_mm")].toDouble(-1)
                   : -2;
    };
    QVERIFY(thinnest(9.75F, 10.25F, true) > 9);
    QVERIFY(std::abs(thinnest(11, 11.5F, true) - 0.5) < 1e-6);
    QVERIFY(thinnest(11, 11.5F, false) > 9);
}

void TestPartCommands::boolean_unitesOverlappingParts()
{
    core::writeMesh(at("box.obj"), shapes::moved(shapes::cube(20), Vec3f(-5, -5, -5)));
    const Answer done = run(QStringLiteral("boolean intersect parts.glb box.obj -o out.stl"));
    QVERIFY2(done.status == 0, qPrintable(done.err));
    const core::MeshReport report = core::checkMesh(core::readMesh(at("out.stl")));
    QVERIFY(report.printReady() && std::abs(*report.volume - 15) < 1e-4);
}

void TestPartCommands::hiddenParts_areInGlbOnly()
{
    QCOMPARE(run(QStringLiteral("convert parts.glb out.glb")).status, 0);
    QVERIFY(core::readModel(at("out.glb")).mesh.triangles.size() ==
            core::readModel(at("parts.glb")).mesh.triangles.size());
    QCOMPARE(run(QStringLiteral("convert parts.glb out.stl")).status, 0);
    QVERIFY(std::abs(*core::checkMesh(core::readMesh(at("out.stl"))).volume - 15) < 1e-5);
    writeStrokes("hide.json", R"({"command":"show_parts","parts":[]})");
    QCOMPARE(run(QStringLiteral("replay --strokes hide.json --in parts.glb --out none.glb")).status, 0);
    const Answer refused = run(QStringLiteral("convert none.glb none.stl"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains(QStringLiteral("hidden")), qPrintable(refused.err));
    QVERIFY(!QFile::exists(QString::fromStdString(at("none.stl"))));
}

void TestPartCommands::replay_paintsOneObject()
{
    writeStrokes("paint.json", R"({"command":"fill","color":[255,0,0],"part":1})");
    const Answer refused = run(QStringLiteral("replay --strokes paint.json --in two.3mf --out out.glb"));
    QCOMPARE(refused.status, 2); // not sound
    QVERIFY2(refused.err.contains(QStringLiteral("--parts")), qPrintable(refused.err));
    core::writeMesh(at("surface.stl"), core::readMesh(at("two.3mf")));
    const Answer alone = run(QStringLiteral("replay --strokes paint.json --in surface.stl --out out.glb"));
    QVERIFY2(alone.status == 2 && !alone.err.contains(QStringLiteral("--parts")), qPrintable(alone.err));
    QCOMPARE(run(QStringLiteral("replay --strokes paint.json --parts --out out.glb")).status, 2); // without --in
    const Answer done = run(QStringLiteral("replay --strokes paint.json --in two.3mf --parts --out out.glb"));
    QVERIFY2(done.status == 0, qPrintable(done.err));
    const ReadResult read = core::readModel(at("out.glb"), {.keepsObjects = true});
    for (const PartPiece& piece : core::splitByPart(read.mesh)) {
        const auto red = std::ranges::count(piece.mesh.colors, core::Rgb{255, 0, 0});
        QCOMPARE(std::size_t(red), read.parts.find(piece.part)->name == "High" ? piece.mesh.points.size() : 0);
    }
}

/// Strokes on a locked, a hidden and a missing part are refused as commands are.
void TestPartCommands::replay_refusesStrokesThatChangeNothing()
{
    const QByteArray stroke = R"({"tool":"pull","radius":1,"part":%,"samples":[{"position":[1,1,2]}]})";
    const QByteArray locked = R"({"command":"edit_part","name":"Low","locked":true,"part":0},)";
    for (const auto& [before, part] : {std::pair<QByteArray, const char*>{locked, "0"}, {{}, "2"}, {{}, "9"}}) {
        writeStrokes("stroke.json", before + QByteArray(stroke).replace('%', part));
        const Answer refused = run(QStringLiteral("replay --strokes stroke.json --in parts.glb --out out.glb"));
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.err.contains(QStringLiteral("strokes[%1]").arg(before.isEmpty() ? 0 : 1)),
                 qPrintable(refused.err));
        QVERIFY(!QFile::exists(QString::fromStdString(at("out.glb"))));
    }
    writeStrokes("stroke.json", QByteArray(stroke).replace('%', "1"));
    QCOMPARE(run(QStringLiteral("replay --strokes stroke.json --in parts.glb --out out.glb")).status, 0);
}

void TestPartCommands::replay_insertsParts()
{
    writeStrokes("insert.json", R"({"command":"insert","primitive":"ball","radius":0.4,"combine":"part","name":"Bead",)"
                                R"("where":"as_it_is"},)"
                                R"({"command":"insert","file":"two.stl","combine":"part","where":"as_it_is"},)"
                                R"({"command":"insert","file":"two.stl","combine":"part"},)"
                                R"({"command":"edit_part","name":"Last","part":1})");
    QCOMPARE(run(QStringLiteral("convert two.3mf two.stl --parts")).status, 0);
    const Answer done = run(QStringLiteral("replay --strokes insert.json --out out.glb"));
    QVERIFY2(done.status == 0, qPrintable(done.err));
    const ReadResult read = core::readModel(at("out.glb"), {.keepsObjects = true});
    std::vector<std::string> names;
    for (const Part& part : read.parts.all())
        names.push_back(part.name);
    QVERIFY2(names == std::vector<std::string>({"", "Last", "two", "two 2"}), names.back().c_str());
    QVERIFY(core::checkMesh(read.mesh).printReady() && core::doPartsOverlap(read.mesh));
}

void TestPartCommands::replay_unitesOverlappingParts()
{
    writeStrokes("none.json", "");
    const Answer done = run(QStringLiteral("replay --strokes none.json --in two.3mf --parts --out out.stl"));
    QVERIFY2(done.status == 0 && (done.out + done.err).contains(QStringLiteral("united")), qPrintable(done.out));
    const core::MeshReport report = core::checkMesh(core::readMesh(at("out.stl")));
    QVERIFY(report.printReady());
    QVERIFY(std::abs(*report.volume - 15) < 1e-3);
    const Answer apart = run(QStringLiteral("replay --strokes none.json --in two.3mf --parts --out out.glb"));
    QVERIFY2(apart.status == 0 && apart.err.isEmpty(), qPrintable(apart.err));
    QCOMPARE(core::readModel(at("out.glb"), {.keepsObjects = true}).parts.size(), std::size_t(2));
}

FETTLE_TEST(TestPartCommands)
#include "tst_part_commands.moc"
