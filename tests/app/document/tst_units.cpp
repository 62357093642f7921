// Tests models without a unit in the real window: the question about the unit, and the effect of its answers.

#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/model/unit_bar.h"

#include <QAction>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtEndian>

using namespace app;

namespace
{
/// Writes a glTF with an embedded buffer.
void writeGltf(const QString& path, const core::TriangleMesh& mesh)
{
    constexpr qsizetype jsonAt = 20, chunkHead = 8;
    core::writeMesh((path + QStringLiteral(".glb")).toStdString(), mesh);
    QFile packed(path + QStringLiteral(".glb")), text(path);
    QVERIFY(packed.open(QIODevice::ReadOnly) && text.open(QIODevice::WriteOnly));
    const QByteArray bytes = packed.readAll();
    const auto size = static_cast<qsizetype>(qFromLittleEndian<quint32>(bytes.constData() + 12));
    QJsonObject document = QJsonDocument::fromJson(bytes.mid(jsonAt, size)).object();
    QJsonObject buffer = document[QStringLiteral("buffers")][0].toObject();
    buffer[QStringLiteral("uri")] = QStringLiteral("data:application/octet-stream;base64,") +
                                    QString::fromLatin1(bytes.mid(jsonAt + size + chunkHead).toBase64());
    document[QStringLiteral("buffers")] = QJsonArray{buffer};
    text.write(QJsonDocument(document).toJson());
}
} // namespace

class TestUnits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void unit_scalesInOneStep_data();
    void unit_scalesInOneStep();
    void otherChanges_endTheDoubt();
    void anotherModel_endsTheDoubt();
    void knownUnits_areNotDoubted_data();
    void knownUnits_areNotDoubted();

private:
    /// Writes a cube with this side length and opens it in the window.
    void open(Program& program, const char* name, float side)
    {
        const QString path = m_folder->filePath(QLatin1StringView(name));
        if (path.endsWith(QStringLiteral(".gltf")))
            writeGltf(path, shapes::cube(side));
        else
            core::writeMesh(path.toStdString(), shapes::cube(side));
        openFile(program, path);
    }
    static ui::UnitBar* bar(const Program& program) { return program.window.findChild<ui::UnitBar*>(); }
    static double side(const Program& program) { return program.document.modelInfo().size.maxCoeff(); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestUnits::init()
{
    QSettings().clear();
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestUnits::unit_scalesInOneStep_data()
{
    QTest::addColumn<float>("side");
    QTest::addColumn<QString>("button");
    QTest::addColumn<double>("becomes");
    QTest::newRow("inches, as guessed") << 1.5F << QStringLiteral("asInches") << 38.1;
    QTest::newRow("inches, though slicers take it for millimetres") << 6.0F << QStringLiteral("asInches") << 152.4;
    QTest::newRow("metres, as guessed") << 0.25F << QStringLiteral("asMetres") << 250.0;
    QTest::newRow("centimetres") << 1.5F << QStringLiteral("asCentimetres") << 15.0;
}

void TestUnits::unit_scalesInOneStep()
{
    QFETCH(float, side);
    QFETCH(QString, button);
    QFETCH(double, becomes);
    Program program;
    open(program, "part.stl", side);
    QTRY_VERIFY(bar(program) && bar(program)->isVisible());
    const double before = TestUnits::side(program);
    auto* unit = bar(program)->findChild<QPushButton*>(button);
    QCOMPARE(unit->isDefault(), button != QStringLiteral("asCentimetres"));
    unit->setFocus();
    QTest::keyClick(unit, Qt::Key_Return);
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QTRY_VERIFY(!bar(program));
    QTRY_VERIFY(std::abs(TestUnits::side(program) - becomes) < 1e-3 * becomes);
    QVERIFY(program.document.savedState().isModified());
    QVERIFY(program.window.viewport()->hasFocus());
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(TestUnits::side(program), before);
    QVERIFY(!program.document.savedState().isModified() && !program.document.history().canUndo());
    QVERIFY(!bar(program));
}

void TestUnits::otherChanges_endTheDoubt()
{
    Program program;
    open(program, "part.stl", 1.5F);
    QTRY_VERIFY(bar(program));
    program.window.action(QStringLiteral("model.placeOnBed"))->trigger();
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QTRY_VERIFY(!bar(program));
}

void TestUnits::anotherModel_endsTheDoubt()
{
    Program program;
    open(program, "part.stl", 1.5F);
    QTRY_VERIFY(bar(program));
    open(program, "other.stl", 1.2F);
    QTRY_COMPARE(program.window.findChildren<ui::UnitBar*>().size(), 1);
    open(program, "large.stl", 20);
    QTRY_VERIFY(!bar(program));
}

void TestUnits::knownUnits_areNotDoubted_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<float>("side");
    QTest::newRow("GLB knows its unit") << QByteArray("part.glb") << 1.5F;
    QTest::newRow("glTF knows its unit") << QByteArray("part.gltf") << 1.5F;
    QTest::newRow("3MF knows its unit") << QByteArray("part.3mf") << 1.5F;
    QTest::newRow("large enough") << QByteArray("part.stl") << 20.0F;
}

void TestUnits::knownUnits_areNotDoubted()
{
    QFETCH(QByteArray, name);
    QFETCH(float, side);
    Program program;
    open(program, name.constData(), side);
    QVERIFY(!bar(program));
}

FETTLE_TEST(TestUnits, app::OnScreen)
#include "tst_units.moc"
