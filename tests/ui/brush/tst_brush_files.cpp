// Good and bad files of alphas and brush shapes, and how the window lets the user choose them.
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "ui/brush/brush_files.h"
#include "ui/brush/brush_shapes.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QBuffer>
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

using core::Tool;

namespace
{
QByteArray bigEndian(quint32 value)
{
    const char bytes[] = {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
    return {bytes, sizeof bytes};
}

/// Returns the beginning of a PNG file whose header declares a square image of this side.
QByteArray pngHeader(quint32 side)
{
    const QByteArray content = "IHDR" + bigEndian(side) + bigEndian(side) + QByteArray::fromHex("0800000000");
    quint32 crc = ~0u;
    for (const char c : content) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
    }
    return QByteArray::fromHex("89504e470d0a1a0a") + bigEndian(13) + content + bigEndian(~crc);
}

bool write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

bool contains(const QString& sentence, const QString& words)
{
    return sentence.contains(words) && sentence.endsWith(u'.') && !sentence.contains(u'\n');
}
} // namespace

class TestBrushFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void init() { QSettings().clear(); }
    void alpha_isGrey();
    void alpha_ofATransparentShape();
    void alpha_ofOnePixel();
    void alpha_refused_data();
    void alpha_refused();
    void alpha_cutOff();
    void model_isRead();
    void model_refused_data();
    void model_refused();
    void window_choosesAlphas();
    void window_choosesModels();
    void window_takesItsOwnModel();
    void settings_keepTheAlpha();
    void settings_keepTheAlphaOfEachTool();
    void settings_keepTheModel();
    void aModelThatIsGone_isSaidOnce_data();
    void aModelThatIsGone_isSaidOnce();
    void aLaterModelWins();
    void aLaterAlphaWins();
    void aRefusedFile_isForgotten();
    void aFile_isReadAnew();

private:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    QTemporaryDir m_folder;
};

void TestBrushFiles::alpha_isGrey()
{
    QImage image(3, 2, QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setPixelColor(0, 0, Qt::black);
    image.setPixelColor(2, 1, QColor(100, 100, 100));
    QVERIFY(image.save(path("grey.png")));
    const auto file = ui::readAlpha(path("grey.png"));
    QVERIFY2(file.what, qPrintable(file.problem));
    QCOMPARE(file.what->pixels(), (std::vector<std::uint8_t>{0, 255, 255, 255, 255, 100}));
    QCOMPARE(file.what->width(), 3);
    QCOMPARE(QString::fromStdString(file.what->source()), path("grey.png"));
}

/// Transparent pixels are 0. A black shape on transparent ground, which would be empty, counts as white.
void TestBrushFiles::alpha_ofATransparentShape()
{
    for (const QColor& color : {QColor(Qt::white), QColor(Qt::black)}) {
        QImage image(2, 1, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        image.setPixelColor(1, 0, color);
        QVERIFY(image.save(path("shape.png")));
        const auto file = ui::readAlpha(path("shape.png"));
        QVERIFY2(file.what, qPrintable(file.problem));
        QCOMPARE(file.what->pixels(), (std::vector<std::uint8_t>{0, 255}));
    }
}

void TestBrushFiles::alpha_ofOnePixel()
{
    QImage image(1, 1, QImage::Format_Grayscale8);
    image.fill(128);
    QVERIFY(image.save(path("one.png")));
    const auto file = ui::readAlpha(path("one.png"));
    QVERIFY2(file.what, qPrintable(file.problem));
    QCOMPARE(file.what->at(0.7, -0.7), 128.0 / 255);
}

void TestBrushFiles::alpha_refused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    QTest::newRow("text") << QByteArray("This is no image.") << QStringLiteral("not an image");
    QTest::newRow("empty") << QByteArray() << QStringLiteral("not an image");
    QTest::newRow("SVG")
        << QByteArray(R"(<svg xmlns="http://www.w3.org/2000/svg" width="8" height="8"><text y="8">a</text></svg>)")
        << QStringLiteral("not an image");
    QTest::newRow("20,000 x 20,000") << pngHeader(20'000) + bigEndian(20) + "IDAT" + QByteArray(24, 'x')
                                     << QStringLiteral("20000 × 20000 pixels");
    QTest::newRow("a header alone") << pngHeader(64) << QStringLiteral("damaged");
    QByteArray black;
    QBuffer buffer(&black);
    buffer.open(QIODevice::WriteOnly);
    QImage image(4, 4, QImage::Format_RGB32);
    image.fill(Qt::black);
    image.save(&buffer, "png");
    QTest::newRow("black") << black << QStringLiteral("all black");
}

void TestBrushFiles::alpha_refused()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    QVERIFY(write(path("bad.png"), bytes));
    const auto file = ui::readAlpha(path("bad.png"));
    QVERIFY(!file.what);
    QVERIFY2(contains(file.problem, words) && file.problem.contains(path("bad.png")), qPrintable(file.problem));
    QVERIFY(contains(ui::readAlpha(path("gone.png")).problem, QStringLiteral("no such file")));
}

/// A file cut off at any byte gives an image or an error message.
void TestBrushFiles::alpha_cutOff()
{
    QByteArray whole;
    QBuffer buffer(&whole);
    buffer.open(QIODevice::WriteOnly);
    QImage image(32, 32, QImage::Format_Grayscale8);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            image.setPixelColor(x, y, QColor::fromHsv(0, 0, (x * 37 + y * 91) % 256));
    image.save(&buffer, "png");
    int refused = 0;
    for (qsizetype length = 0; length < whole.size(); length += 29) {
        QVERIFY(write(path("cut.png"), whole.first(length)));
        const auto file = ui::readAlpha(path("cut.png"));
        QVERIFY(bool(file.what) == file.problem.isEmpty());
        refused += file.what ? 0 : 1;
    }
    QVERIFY(refused > 3);
}

void TestBrushFiles::model_isRead()
{
    core::writeMesh(path("torus.stl").toStdString(), core::starterModel(core::Starter::Torus));
    const auto file = ui::readBrushModel(path("torus.stl"));
    QVERIFY2(file.what, qPrintable(file.problem));
    QCOMPARE(QString::fromStdString(file.what->source()), path("torus.stl"));
}

void TestBrushFiles::model_refused_data()
{
    QTest::addColumn<core::TriangleMesh>("mesh");
    QTest::addColumn<QString>("words");
    core::TriangleMesh open = core::icosphere(2, 1), flat = open, tiny = open;
    open.triangles.pop_back();
    for (core::Vec3f& p : flat.points)
        p.y() *= 1e-5f;
    for (core::Vec3f& p : tiny.points)
        p *= 1e-7f;
    QTest::newRow("open") << open << QStringLiteral("open edges: 3");
    QTest::newRow("flat") << flat << QStringLiteral("too flat");
    QTest::newRow("tiny") << tiny << QStringLiteral("too small");
    QTest::newRow("huge") << core::icosphere(7, 1) << QStringLiteral("250,000");
}

void TestBrushFiles::model_refused()
{
    QFETCH(core::TriangleMesh, mesh);
    QFETCH(QString, words);
    core::writeMesh(path("bad.ply").toStdString(), mesh);
    const auto file = ui::readBrushModel(path("bad.ply"));
    QVERIFY(!file.what);
    QVERIFY2(contains(file.problem, words) && file.problem.contains(path("bad.ply")), qPrintable(file.problem));
    QVERIFY(write(path("broken.glb"), "glTF and no more"));
    QVERIFY(!ui::readBrushModel(path("broken.glb")).problem.isEmpty());
    QVERIFY(write(path("empty.obj"), {}));
    QVERIFY(!ui::readBrushModel(path("empty.obj")).problem.isEmpty());
}

void TestBrushFiles::window_choosesAlphas()
{
    QImage image(4, 4, QImage::Format_Grayscale8);
    image.fill(200);
    QVERIFY(image.save(path("mine.png")));
    QVERIFY(write(path("bad.png"), "no image"));
    ui::MainWindow window;
    auto* box = window.findChild<QComboBox*>(QStringLiteral("alpha"));
    auto* shapes = window.findChild<ui::BrushShapes*>();
    QVERIFY(box && shapes);
    const auto choose = [box](const QString& source) {
        box->setCurrentIndex(box->findData(source));
        Q_EMIT box->activated(box->currentIndex());
    };
    choose(QStringLiteral("star"));
    QCOMPARE(window.brush()->stroke().alpha, core::builtInAlpha("star"));
    window.brush()->setTool(Tool::Grab);
    QVERIFY(!box->isEnabled());
    window.brush()->setTool(Tool::Pull);
    QVERIFY(box->isEnabled());
    QSignalSpy refused(shapes, &ui::BrushShapes::refused);
    shapes->chooseAlpha(path("bad.png"));
    QTRY_COMPARE(refused.count(), 1);
    QCOMPARE(window.brush()->stroke().alpha, core::builtInAlpha("star"));
    QCOMPARE(box->currentData().toString(), QStringLiteral("star"));
    shapes->chooseAlpha(path("mine.png"));
    QTRY_COMPARE(box->currentData().toString(), path("mine.png"));
    QCOMPARE(box->currentText(), QStringLiteral("mine.png"));
    QCOMPARE(window.brush()->stroke().alpha->at(0, 0), 200.0 / 255);
    QCOMPARE(window.brush()->stroke().spacing, 2.0); // adjacent prints do not overlap
    choose({});
    QVERIFY(!window.brush()->stroke().alpha);
    QCOMPARE(window.brush()->stroke().spacing, ui::defaultSpacing);
    choose(QStringLiteral("star"));
    window.brush()->setValue(core::Parameter::Spacing, 0.5);
    choose(QStringLiteral("ring"));
    QCOMPARE(window.brush()->stroke().spacing, 0.5); // spacing set by the user is kept
    choose({});
    QCOMPARE(window.brush()->stroke().spacing, 0.5);
    QVERIFY(box->findData(path("mine.png")) > 0); // still in the list of recent files
}

void TestBrushFiles::window_choosesModels()
{
    core::writeMesh(path("cube.stl").toStdString(), core::starterModel(core::Starter::Cube));
    core::TriangleMesh open = core::icosphere(2, 1);
    open.triangles.pop_back();
    core::writeMesh(path("open.ply").toStdString(), open);
    ui::MainWindow window;
    auto* box = window.findChild<QComboBox*>(QStringLiteral("stampShape"));
    auto* shapes = window.findChild<ui::BrushShapes*>();
    QVERIFY(box && shapes && box->currentData().toString().isEmpty());
    shapes->chooseModel(path("cube.stl"));
    QTRY_COMPARE(box->currentData().toString(), path("cube.stl"));
    const auto cube = window.brush()->stroke().model;
    QVERIFY(cube);
    QSignalSpy refused(shapes, &ui::BrushShapes::refused);
    shapes->chooseModel(path("open.ply"));
    QTRY_COMPARE(refused.count(), 1);
    QCOMPARE(window.brush()->stroke().model, cube);
    shapes->chooseModel({});
    QVERIFY(!window.brush()->stroke().model);
}

/// The document's model can be requested as the brush shape from the menu or the list. Until it arrives, the list shows
/// the present shape.
void TestBrushFiles::window_takesItsOwnModel()
{
    core::writeMesh(path("own.glb").toStdString(), core::starterModel(core::Starter::Cube));
    ui::MainWindow window;
    QSignalSpy asked(window.action(QStringLiteral("brush.fromModel")), &QAction::triggered);
    window.action(QStringLiteral("brush.fromModel"))->trigger();
    auto* box = window.findChild<QComboBox*>(QStringLiteral("stampShape"));
    box->setCurrentIndex(box->count() - 2);
    Q_EMIT box->activated(box->currentIndex());
    QCOMPARE(asked.count(), 2);
    QVERIFY(box->currentData().toString().isEmpty());
    window.progress()->begin(QStringLiteral("Saving"));
    QVERIFY(!window.action(QStringLiteral("brush.fromModel"))->isEnabled());
    window.progress()->end();
    window.setBrushModel(path("own.glb"));
    QTRY_COMPARE(box->currentData().toString(), path("own.glb"));
    QCOMPARE(window.brush()->tool(), Tool::Stamp);
    QVERIFY(window.brush()->stroke().model);
}

void TestBrushFiles::settings_keepTheAlpha()
{
    QImage image(4, 4, QImage::Format_Grayscale8);
    image.fill(200);
    QVERIFY(image.save(path("kept.png")));
    // Makes the start-up change the brush while the file is being read
    ui::Settings().setValue(core::Parameter::Strength, 0.3);
    {
        ui::MainWindow window;
        window.findChild<ui::BrushShapes*>()->chooseAlpha(path("kept.png"));
        QTRY_VERIFY(window.brush()->stroke().alpha);
        window.findChild<QCheckBox*>(QStringLiteral("alphaFollows"))->click();
    }
    {
        ui::MainWindow window;
        QTRY_VERIFY(window.brush()->stroke().alpha &&
                    window.brush()->stroke().alpha->source() == path("kept.png").toStdString());
        QVERIFY(window.brush()->stroke().alphaFollows);
    }
    {
        ui::MainWindow window; // closed before the file was read
        window.brush()->setTool(Tool::Clay);
    }
    QCOMPARE(ui::Settings().get<ui::StoredShapes>().alpha, path("kept.png"));
    QVERIFY(ui::Settings().get<ui::StoredShapes>().alphaFollows);
    QVERIFY(QFile::remove(path("kept.png")));
    ui::MainWindow window;
    QTest::qWait(100);
    QVERIFY(!window.brush()->stroke().alpha);
}

/// Each tool's alpha is stored, whether a file, a bundled alpha or none. A missing file is reported once, even if
/// several tools use it.
void TestBrushFiles::settings_keepTheAlphaOfEachTool()
{
    QImage image(4, 4, QImage::Format_Grayscale8);
    image.fill(200);
    QVERIFY(image.save(path("each.png")));
    {
        ui::MainWindow window;
        auto* shapes = window.findChild<ui::BrushShapes*>();
        for (const Tool tool : {Tool::Clay, Tool::Layer}) {
            window.brush()->setTool(tool);
            shapes->chooseAlpha(path("each.png"));
            QTRY_VERIFY(window.brush()->stroke().alpha);
        }
        window.brush()->setTool(Tool::Inflate);
        shapes->chooseAlpha(QStringLiteral("star"));
        window.brush()->setTool(Tool::Smooth);
        QVERIFY(!window.brush()->stroke().alpha);
    }
    const auto alphaOf = [](const ui::MainWindow& window, Tool tool) {
        return window.brush()->tools()->of(tool).alpha;
    };
    {
        ui::MainWindow window;
        QTRY_VERIFY(alphaOf(window, Tool::Clay) && alphaOf(window, Tool::Layer));
        QCOMPARE(alphaOf(window, Tool::Clay)->source(), path("each.png").toStdString());
        QCOMPARE(alphaOf(window, Tool::Inflate), core::builtInAlpha("star"));
        QVERIFY(!alphaOf(window, Tool::Pull) && !alphaOf(window, Tool::Smooth));
    }
    QVERIFY(QFile::remove(path("each.png")));
    for (const int times : {1, 0}) {
        ui::MainWindow window;
        QSignalSpy refused(window.findChild<ui::BrushShapes*>(), &ui::BrushShapes::refused);
        QTest::qWait(200);
        QCOMPARE(refused.count(), times);
        QVERIFY(!alphaOf(window, Tool::Clay) && !alphaOf(window, Tool::Layer));
        QCOMPARE(alphaOf(window, Tool::Inflate), core::builtInAlpha("star"));
    }
}

/// The stored model is kept, even if something else is chosen while its file is being read.
void TestBrushFiles::settings_keepTheModel()
{
    core::writeMesh(path("stamp.stl").toStdString(), core::starterModel(core::Starter::Torus));
    // Makes the start-up change the brush while the file is being read
    ui::Settings().setValue(core::Parameter::Strength, 0.3);
    {
        ui::MainWindow window;
        auto* shapes = window.findChild<ui::BrushShapes*>();
        shapes->chooseModel(path("stamp.stl"));
        shapes->chooseAlpha(QStringLiteral("star"));
        QTRY_VERIFY(window.brush()->stroke().model);
    }
    {
        ui::MainWindow window; // closed before the file was read
        window.findChild<ui::BrushShapes*>()->chooseAlpha(QStringLiteral("ring"));
    }
    {
        ui::MainWindow window;
        QSignalSpy refused(window.findChild<ui::BrushShapes*>(), &ui::BrushShapes::refused);
        auto* box = window.findChild<QComboBox*>(QStringLiteral("stampShape"));
        QTRY_COMPARE(box->currentData().toString(), path("stamp.stl"));
        QCOMPARE(window.brush()->stroke().alpha, core::builtInAlpha("ring"));
        QCOMPARE(refused.count(), 0);
        window.findChild<ui::BrushShapes*>()->chooseModel({});
    }
    ui::MainWindow window;
    QTest::qWait(100);
    QVERIFY(!window.brush()->stroke().model);
    // Still in the list of recent files
    QCOMPARE(ui::Settings().get<ui::StoredShapes>().models, QStringList{path("stamp.stl")});
}

void TestBrushFiles::aModelThatIsGone_isSaidOnce_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("gone") << QByteArray();
    QTest::newRow("broken") << QByteArray("solid nothing");
}

void TestBrushFiles::aModelThatIsGone_isSaidOnce()
{
    QFETCH(QByteArray, bytes);
    QVERIFY(QFile::remove(path("was.stl")) || !QFile::exists(path("was.stl")));
    QVERIFY(bytes.isEmpty() || write(path("was.stl"), bytes));
    ui::StoredShapes stored;
    stored.model = path("was.stl");
    stored.models = QStringList{stored.model};
    ui::Settings().set(stored);
    for (const int times : {1, 0}) {
        ui::MainWindow window;
        QSignalSpy refused(window.findChild<ui::BrushShapes*>(), &ui::BrushShapes::refused);
        QTest::qWait(200);
        QCOMPARE(refused.count(), times);
        QVERIFY(!window.brush()->stroke().model);
        QVERIFY(window.findChild<QComboBox*>(QStringLiteral("stampShape"))->currentData().toString().isEmpty());
        if (times == 1)
            QVERIFY2(contains(refused[0][0].toString(), path("was.stl")), qPrintable(refused[0][0].toString()));
    }
}

void TestBrushFiles::aLaterModelWins()
{
    core::writeMesh(path("first.stl").toStdString(), core::starterModel(core::Starter::Torus));
    core::writeMesh(path("second.stl").toStdString(), core::starterModel(core::Starter::Cube));
    ui::StoredShapes stored;
    stored.model = path("first.stl");
    ui::Settings().set(stored);
    ui::MainWindow window;
    window.findChild<ui::BrushShapes*>()->chooseModel(path("second.stl"));
    QTest::qWait(300);
    QCOMPARE(window.brush()->stroke().model->source(), path("second.stl").toStdString());
    QCOMPARE(ui::Settings().get<ui::StoredShapes>().model, path("second.stl"));
}

/// An alpha from an opened document wins over the stored file that is still being read.
void TestBrushFiles::aLaterAlphaWins()
{
    QImage image(4, 4, QImage::Format_Grayscale8);
    image.fill(200);
    QVERIFY(image.save(path("late.png")));
    ui::StoredShapes stored;
    stored.alpha = path("late.png");
    ui::Settings().set(stored);
    ui::MainWindow window;
    core::StrokeSettings noted = window.brush()->stroke();
    noted.alpha = core::builtInAlpha("star");
    window.brush()->apply(noted);
    QTest::qWait(200);
    QCOMPARE(window.brush()->stroke().alpha, core::builtInAlpha("star"));
    QCOMPARE(ui::Settings().get<ui::StoredShapes>().alpha, QStringLiteral("star"));
}

void TestBrushFiles::aRefusedFile_isForgotten()
{
    ui::StoredShapes stored;
    stored.alphas = stored.models = QStringList{path("never.png")};
    ui::Settings().set(stored);
    ui::MainWindow window;
    auto* shapes = window.findChild<ui::BrushShapes*>();
    QSignalSpy refused(shapes, &ui::BrushShapes::refused);
    shapes->chooseAlpha(path("never.png"));
    shapes->chooseModel(path("never.png"));
    QTRY_COMPARE(refused.count(), 2);
    QVERIFY(ui::Settings().get<ui::StoredShapes>().alphas.isEmpty() &&
            ui::Settings().get<ui::StoredShapes>().models.isEmpty());
}

/// Choosing a file again reads its changed content.
void TestBrushFiles::aFile_isReadAnew()
{
    ui::MainWindow window;
    auto* shapes = window.findChild<ui::BrushShapes*>();
    for (const uint grey : {200u, 100u}) {
        QImage image(4, 4, QImage::Format_Grayscale8);
        image.fill(grey);
        QVERIFY(image.save(path("changing.png")));
        shapes->chooseAlpha(path("changing.png"));
        QTRY_VERIFY(window.brush()->stroke().alpha && window.brush()->stroke().alpha->pixels().front() == grey);
    }
}

FETTLE_TEST(TestBrushFiles, ui::TestApplication)
#include "tst_brush_files.moc"
