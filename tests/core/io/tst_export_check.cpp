#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/export_check.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using core::TriangleMesh;

namespace
{
TriangleMesh paintedBall()
{
    TriangleMesh mesh = core::icosphere(3, 1.0 / 3);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        mesh.colors.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(3 * i), 7});
    return mesh;
}
} // namespace

class TestExportCheck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatWasWritten_isThere_data();
    void whatWasWritten_isThere();
    void oneBit_isFound_data();
    void oneBit_isFound();
    void anotherModel_isFound();
    void unsoundModel_isFound();
    void missingFile_isAnError();

private:
    std::filesystem::path file(const QString& name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

void TestExportCheck::whatWasWritten_isThere_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view ending : core::writtenEndings())
        QTest::addRow("%s", ending.data())
            << QStringLiteral("a.") + QLatin1StringView(ending.data(), static_cast<qsizetype>(ending.size()));
}

void TestExportCheck::whatWasWritten_isThere()
{
    QFETCH(QString, name);
    core::writeMesh(file(name), paintedBall());
    const core::ExportVerdict verdict = core::checkExport(file(name), paintedBall());
    QVERIFY(verdict.sameCorners && verdict.sameColors && verdict.holds());
    QCOMPARE(verdict.report.faces, paintedBall().triangles.size());
}

void TestExportCheck::oneBit_isFound_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("fromEnd"); ///< distance of the changed byte from the end of the file
    QTest::addColumn<bool>("isColor");
    QTest::newRow("a coordinate in STL") << QStringLiteral("a.stl") << 2 + 12 << false;
    QTest::newRow("a corner in PLY") << QStringLiteral("a.ply") << 4 << false;
    QTest::newRow("a colour in GLB") << QStringLiteral("a.glb")
                                     << static_cast<int>(12 * paintedBall().triangles.size()) + 8 - 1 << true;
}

void TestExportCheck::oneBit_isFound()
{
    QFETCH(QString, name);
    QFETCH(int, fromEnd);
    QFETCH(bool, isColor);
    core::writeMesh(file(name), paintedBall());
    {
        std::fstream spoilt(file(name), std::ios::binary | std::ios::in | std::ios::out);
        spoilt.seekg(-fromEnd, std::ios::end);
        const char byte = static_cast<char>(spoilt.get() ^ (isColor ? 0x40 : 1));
        spoilt.seekp(-fromEnd, std::ios::end);
        spoilt.put(byte);
    }
    const core::ExportVerdict verdict = core::checkExport(file(name), paintedBall());
    QVERIFY(!verdict.holds());
    QCOMPARE(verdict.sameCorners, isColor);
    QVERIFY(!isColor || !verdict.sameColors); // a changed corner may also change which colour is compared
}

void TestExportCheck::anotherModel_isFound()
{
    core::writeMesh(file(QStringLiteral("a.ply")), core::icosphere(2, 1.0 / 3));
    const core::ExportVerdict verdict = core::checkExport(file(QStringLiteral("a.ply")), paintedBall());
    QVERIFY(!verdict.sameCorners && !verdict.sameColors && !verdict.holds());
}

void TestExportCheck::unsoundModel_isFound()
{
    const TriangleMesh open = shapes::openCone(12);
    core::writeMesh(file(QStringLiteral("a.stl")), open);
    const core::ExportVerdict verdict = core::checkExport(file(QStringLiteral("a.stl")), open);
    QVERIFY(verdict.sameCorners && !verdict.report.printReady() && !verdict.holds());
}

void TestExportCheck::missingFile_isAnError()
{
    QVERIFY_EXCEPTION_THROWN(core::checkExport(file(QStringLiteral("none.stl")), paintedBall()), core::FileError);
}

FETTLE_TEST(TestExportCheck)
#include "tst_export_check.moc"
