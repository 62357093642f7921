// Tests the whole program in a locale with a decimal comma, which must not change the content of files.

#include "app/import/sandboxed_importer.h"
#include "core/io/export_check.h"
#include "core/io/mesh_io.h"
#include "core/io/stroke/stroke_file.h"
#include "tests/support/test_main.h"

#include <QApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

namespace
{
constexpr unsigned seed = 20261122;

/// Returns triangles with random colours and coordinates of any size that a format may have to write.
core::TriangleMesh awkwardTriangles()
{
    std::mt19937 engine(seed);
    const auto coordinate = [&engine] {
        for (;;) {
            const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(engine()));
            if (std::abs(value) > 1e-30F && std::abs(value) < 1e12F)
                return value;
        }
    };
    core::TriangleMesh mesh;
    for (core::Slot i = 0; i < 300; ++i) {
        mesh.points.emplace_back(coordinate(), coordinate(), coordinate());
        mesh.colors.push_back({static_cast<std::uint8_t>(engine()), static_cast<std::uint8_t>(engine()),
                               static_cast<std::uint8_t>(engine())});
        if (i % 3 == 2)
            mesh.triangles.push_back({i - 2, i - 1, i});
    }
    return mesh;
}
} // namespace

class TestGermanLocale : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void formats_areBitIdentical_data();
    void formats_areBitIdentical();
    void textByOthers_isRead_data();
    void textByOthers_isRead();
    void strokes_areTheSame();
    void commands_writeAndReadPoints();

private:
    QString at(const char* name) const { return m_folder.filePath(QLatin1StringView(name)); }
    void write(const char* name, const QByteArray& bytes) const
    {
        QFile file(at(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    QTemporaryDir m_folder;
};

/// Checks the precondition: the locale exists and uses a decimal comma.
void TestGermanLocale::initTestCase()
{
    QVERIFY2(QByteArray(std::setlocale(LC_ALL, nullptr)).contains("de_DE.UTF-8"), std::setlocale(LC_ALL, nullptr));
    char text[8];
    std::snprintf(text, sizeof text, "%.1f", 1.5);
    QCOMPARE(text, "1,5");
    QCOMPARE(std::strtod("1,5", nullptr), 1.5);
    QCOMPARE(QLocale().toString(1.5), QStringLiteral("1,5"));
    core::setExternalReader(app::sandboxedImporter(FETTLE_PROGRAM));
}

void TestGermanLocale::formats_areBitIdentical_data()
{
    QTest::addColumn<QByteArray>("ending");
    for (const std::string_view ending : core::writtenEndings())
        QTest::newRow(std::string(ending).c_str()) << QByteArray(ending.data(), static_cast<qsizetype>(ending.size()));
}

void TestGermanLocale::formats_areBitIdentical()
{
    QFETCH(QByteArray, ending);
    const core::TriangleMesh mesh = awkwardTriangles();
    const auto path = at("a." + ending).toStdString();
    core::writeMesh(path, mesh);
    const core::ExportVerdict verdict = core::checkExport(path, mesh);
    QVERIFY(verdict.sameCorners && verdict.sameColors);
}

void TestGermanLocale::textByOthers_isRead_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("STL") << QStringLiteral("b.stl")
                         << QByteArray("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0.125 0 0\nvertex 1.5e0 0 "
                                       "0\nvertex 0 2.75 0\nendloop\nendfacet\nendsolid s\n");
    QTest::newRow("OBJ") << QStringLiteral("b.obj") << QByteArray("v 0.125 0 0\nv 1.5e0 0 0\nv 0 0 -2.75\nf 1 2 3\n");
    QTest::newRow("PLY")
        << QStringLiteral("b.ply")
        << QByteArray("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                      "z\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n0.125 0 0\n1.5e0 0 0\n0 0 -2.75\n3 0 1 2\n");
    QTest::newRow("OFF") << QStringLiteral("b.off")
                         << QByteArray("OFF\n3 1 0\n0.125 0 0\n1.5e0 0 0\n0 0 -2.75\n3 0 1 2\n");
    QTest::newRow("by Assimp") << QStringLiteral("b.nff") << QByteArray("p 3\n0.125 0 0\n1.5 0 0\n0 0 -2.75\n");
}

/// Each file contains the same triangle, in the document's axes.
void TestGermanLocale::textByOthers_isRead()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    write(qPrintable(name), text);
    const core::TriangleMesh mesh = core::readMesh(at(qPrintable(name)).toStdString());
    QCOMPARE(mesh.points.size(), std::size_t(3));
    for (const core::Vec3f& point : {core::Vec3f(0.125F, 0, 0), core::Vec3f(1.5F, 0, 0), core::Vec3f(0, 0, -2.75F)})
        QVERIFY(std::ranges::find(mesh.points, point) != mesh.points.end());
}

void TestGermanLocale::strokes_areTheSame()
{
    core::Stroke stroke;
    stroke.settings.radius = 0.1;
    stroke.settings.strength = 1.0 / 3;
    stroke.samples.emplace_back().position = {1.0 / 7, -1e-9, 1234567.875};
    std::ostringstream text;
    core::writeStrokes(text, {stroke});
    const auto back = std::get<core::Stroke>(core::parseStrokes(text.str()).at(0));
    QCOMPARE(back.settings.radius, stroke.settings.radius);
    QCOMPARE(back.settings.strength, stroke.settings.strength);
    QVERIFY(back.samples.at(0).position == stroke.samples[0].position);
}

void TestGermanLocale::commands_writeAndReadPoints()
{
    core::writeMesh(at("ball.obj").toStdString(), core::icosphere(2, 1.25));
    const auto fettle = [](const QStringList& arguments) {
        QProcess process;
        process.start(QStringLiteral(FETTLE_PROGRAM), arguments);
        process.waitForFinished(-1);
        return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
    };
    const auto text = [](const char* word) { return QString::fromLatin1(word); };
    fettle(
        {text("convert"), at("ball.obj"), at("inches.ply"), text("--unit"), text("in"), text("--size"), text("63.5")});
    const QByteArray answer =
        fettle({text("check"), text("--print"), text("--overhang"), text("37.5"), text("--json"), at("inches.ply")});
    const QJsonObject json = QJsonDocument::fromJson(answer).object();
    QVERIFY2(std::abs(json[text("size_mm")][1].toDouble() - 63.5) < 1e-3, answer.constData());
    QVERIFY(json[text("overhang_share")].toDouble() > 0.1);
}

static int germanLocaleMain(int argc, char* argv[])
{
    const QTemporaryDir locales;
    const QByteArray folder = locales.path().toLocal8Bit();
    if (std::system(("localedef -c -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8'").constData()) != 0)
        qWarning("localedef cannot make the German locale: is the package locales installed?");
    qputenv("LOCPATH", folder);
    qputenv("LC_ALL", "de_DE.UTF-8");
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    TestGermanLocale test;
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestGermanLocale, germanLocaleMain)
#include "tst_german_locale.moc"
