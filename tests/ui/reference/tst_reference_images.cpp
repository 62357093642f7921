#include "tests/support/test_main.h"
#include "tests/ui/sphere_model.h"
#include "tests/ui/ui_test.h"

#include "ui/preferences/preferences_dialog.h"
#include "ui/reference/reference_images.h"
#include "ui/scene/reference_image.h"
#include "ui/settings/settings.h"
#include "ui/widgets/side_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/window_metadata.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>

using Side = ui::OrbitCamera::Side;

namespace
{
/// Returns a picture that is red on the left and blue on the right, with a green band at the top.
QImage testPicture(QSize size)
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::red);
    QPainter painter(&image);
    painter.fillRect(size.width() / 2, 0, size.width(), size.height(), Qt::blue);
    painter.fillRect(0, 0, size.width(), size.height() / 4, Qt::green);
    return image;
}

/// Numbers of pixels that are red, green or blue like the test picture; clay and background are none of these colours.
struct Counts
{
    int red = 0, green = 0, blue = 0;
    double redX = 0, blueX = 0, greenY = 0, redY = 0; ///< mean coordinates

    int firstX = 1 << 20, lastX = -1; ///< smallest and largest x of green pixels

    int width() const { return lastX - firstX + 1; }
    bool none() const { return red + green + blue == 0; }
};

Counts countsOf(const QImage& picture)
{
    Counts counts;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor color = picture.pixelColor(x, y);
            const auto isMost = [](int most, int a, int b) { return most > 2 * a && most > 2 * b && most > 100; };
            if (isMost(color.red(), color.green(), color.blue()))
                ++counts.red, counts.redX += x, counts.redY += y;
            if (isMost(color.blue(), color.green(), color.red()))
                ++counts.blue, counts.blueX += x;
            if (isMost(color.green(), color.red(), color.blue()))
                ++counts.green, counts.greenY += y, counts.firstX = std::min(counts.firstX, x),
                                                    counts.lastX = std::max(counts.lastX, x);
        }
    counts.redX /= std::max(counts.red, 1);
    counts.redY /= std::max(counts.red, 1);
    counts.blueX /= std::max(counts.blue, 1);
    counts.greenY /= std::max(counts.green, 1);
    return counts;
}

bool drop(ui::MainWindow& window, const QString& path)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    QDropEvent event({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    return event.isAccepted();
}

core::DocumentMetadata metadataOf(const ui::MainWindow& window)
{
    core::DocumentMetadata metadata;
    ui::addMetadata(window, metadata);
    return metadata;
}

/// A window with a white ball, seen from the front.
struct Shown
{
    Shown()
    {
        window.resize(900, 700);
        window.show();
        patch = model.whole();
        window.viewport()->setPatchSource([this] { return std::exchange(patch, std::nullopt); });
        ui::ModelInfo facts;
        facts.box = model.box();
        facts.size = facts.box.sizes();
        window.setModel(facts);
        window.viewport()->patchReady();
        QCoreApplication::processEvents();
        trigger("view.front");
    }

    QAction* action(const char* id) { return window.action(QLatin1StringView(id)); }
    void trigger(const char* id) { action(id)->trigger(); }
    template <class Widget> Widget* child(const char* name)
    {
        return window.findChild<Widget*>(QLatin1StringView(name));
    }
    Counts seen() { return countsOf(window.viewport()->grabFramebuffer()); }
    QString banner() { return child<QLabel>("banner")->text(); }

    SphereModel model;
    std::optional<core::MeshPatch> patch;
    ui::MainWindow window;
};
} // namespace

/// Tests images pinned to sides of the view: where they are visible, and to which document they belong.
class TestReferenceImages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        SKIP_WITHOUT_GRAPHICS();
        QVERIFY(m_folder.isValid());
        QVERIFY(testPicture({200, 150}).save(picture()));
    }

    void init() { QSettings().clear(); }

    void anImageStandsBehindTheModelOnItsSideOnly_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("perspective") << false;
        QTest::newRow("orthographic") << true;
    }

    void anImageStandsBehindTheModelOnItsSideOnly()
    {
        QFETCH(bool, orthographic);
        Shown shown;
        shown.action("view.orthographic")->setChecked(orthographic);
        QVERIFY(shown.seen().none());
        QVERIFY(drop(shown.window, picture()));
        QTRY_VERIFY(!shown.seen().none());

        const Counts front = shown.seen();
        QVERIFY(front.red > 100 && front.green > 100 && front.blue > 100);
        QVERIFY(front.redX < front.blueX);
        QVERIFY(front.greenY < front.redY);
        const QImage picture = shown.window.viewport()->grabFramebuffer();
        QVERIFY(countsOf(picture.copy(picture.width() / 2 - 20, picture.height() / 2 - 20, 40, 40))
                    .none()); // the clay hides the picture

        for (const char* id : {"view.back", "view.left", "view.right", "view.top", "view.bottom"}) {
            shown.trigger(id);
            QVERIFY2(shown.seen().none(), id);
        }
        shown.trigger("view.front");
        QCOMPARE(shown.seen().red, front.red);
        shown.trigger("reference.show");
        QVERIFY(shown.seen().none());
        shown.trigger("reference.show");
        QCOMPARE(shown.seen().red, front.red);
        shown.trigger("reference.remove");
        QVERIFY(shown.seen().none());
        QVERIFY(!shown.action("reference.remove")->isEnabled());
    }

    /// The image's scale in mm is that at the model's centre, at any distance of the camera.
    void itIsAsLargeAsTheModelsOutline()
    {
        const core::Box box(core::Vec3(-10, -20, 5), core::Vec3(10, 20, 45));
        ui::OrbitCamera camera;
        camera.setViewport(300, 200);
        camera.turnTo(Side::Front);
        camera.frame(box);
        ui::References references;
        references[static_cast<std::size_t>(Side::Front)] = {ui::readReference(picture()),
                                                             {.width = 16, .x = 3, .y = 4}};
        const ui::PlacedReference placed = ui::seenReference(references, camera, box);
        for (const double aside : {-1.0, 1.0}) {
            const auto seen = camera.project(placed.center + aside * placed.halfRight),
                       wanted = camera.project({3 + aside * 8, 4, 25});
            QVERIFY(std::abs(seen.x() - wanted.x()) < 1e-6 && std::abs(seen.y() - wanted.y()) < 1e-6);
        }
    }

    void itIsSeenAFewDegreesAside()
    {
        Shown shown;
        drop(shown.window, picture());
        QTRY_VERIFY(!shown.seen().none());
        shown.window.viewport()->navigation()->turnModel(0.05, 0);
        QVERIFY(!shown.seen().none());
        shown.window.viewport()->navigation()->turnModel(0.1, 0);
        QVERIFY(shown.seen().none());
    }

    /// The panel sets position and size in mm.
    void thePanelPlacesIt()
    {
        Shown shown;
        shown.trigger("view.orthographic");
        drop(shown.window, picture());
        QTRY_VERIFY(!shown.seen().none());
        QVERIFY(shown.child<ui::SidePanel>("referencePanel")->isVisible());
        auto* width = shown.child<QDoubleSpinBox>("reference.width");
        QCOMPARE(std::lround(width->value()), 133L); // the image is 4 : 3, and the ball of 100 mm fits its height
        width->setValue(120);
        const double perMm =
            shown.window.viewport()->camera().pixelsPerMm({0, 0, 0}) * shown.window.devicePixelRatioF();
        QVERIFY2(std::abs(shown.seen().width() - 120 * perMm) < 4,
                 qPrintable(QString::number(shown.seen().width() / perMm)));

        const Counts before = shown.seen();
        shown.child<QDoubleSpinBox>("reference.y")->setValue(20);
        const double moved = before.greenY - shown.seen().greenY;
        QVERIFY2(std::abs(moved - 20 * perMm) < 10, qPrintable(QString::number(moved)));

        const int behind = shown.seen().red;
        shown.child<QSpinBox>("reference.opacity")->setValue(100);
        shown.child<QCheckBox>("reference.inFront")->setChecked(true);
        QVERIFY(shown.seen().red > behind * 2);
    }

    /// The panel shows the side that the camera is nearest to, and each side has its own image.
    void eachSideHasItsOwn()
    {
        Shown shown;
        auto* side = shown.child<QComboBox>("reference.side");
        auto* width = shown.child<QDoubleSpinBox>("reference.width");
        QVERIFY(!width->isEnabled());
        drop(shown.window, picture());
        QTRY_VERIFY(width->isEnabled());
        shown.trigger("view.top");
        QCOMPARE(side->currentIndex(), static_cast<int>(Side::Top));
        QVERIFY(!width->isEnabled());
        drop(shown.window, picture());
        QTRY_VERIFY(width->isEnabled());
        width->setValue(10);
        Q_EMIT side->activated(static_cast<int>(Side::Front));
        QVERIFY(width->value() > 100);
        QVERIFY(!shown.seen().none());
    }

    void aModelIsStillOpenedByDrop()
    {
        Shown shown;
        QSignalSpy opened(shown.window.files(), &ui::ModelFiles::openRequested);
        drop(shown.window, picture());
        drop(shown.window, m_folder.filePath(QStringLiteral("a.stl")));
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(opened[0][0].toString().endsWith(QStringLiteral("a.stl")));
    }

    void theDialogChooses()
    {
        Shown shown;
        shown.trigger("reference.choose");
        auto* dialog = shown.child<QFileDialog>("pictureDialog");
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(picture());
        dialog->close();
        QTRY_VERIFY(!shown.seen().none());
    }

    void theyBelongToTheDocument()
    {
        Shown shown;
        drop(shown.window, picture());
        QTRY_VERIFY(!shown.seen().none());
        shown.child<QDoubleSpinBox>("reference.x")->setValue(-7.5);
        const core::DocumentMetadata metadata = metadataOf(shown.window);
        QCOMPARE(metadata.references.size(), 1U);
        QCOMPARE(metadata.references[0].side, std::string("front"));
        QCOMPARE(metadata.references[0].x, -7.5);
        ui::applyMetadata(shown.window, {});
        QVERIFY(shown.seen().none());
        QVERIFY(!shown.action("reference.remove")->isEnabled());
        QVERIFY(metadataOf(shown.window).references.empty());
        ui::applyMetadata(shown.window, metadata);
        QTRY_VERIFY(!shown.seen().none());
        QCOMPARE(shown.child<QDoubleSpinBox>("reference.x")->value(), -7.5);
        shown.trigger("reference.remove");
        QVERIFY(metadataOf(shown.window).references.empty());
    }

    /// An image that is still being read when another document is opened does not become part of that document.
    void anImageThatComesTooLateIsDropped()
    {
        Shown shown;
        shown.window.findChild<ui::ReferenceImages*>()->choose(Side::Front, picture(), {});
        ui::applyMetadata(shown.window, {});
        QTest::qWait(500);
        QVERIFY(shown.seen().none());
        QVERIFY(metadataOf(shown.window).references.empty());
    }

    /// A file that is no image is refused with one message, and the present image stays.
    void whatIsNoImageIsRefused()
    {
        const QString broken = m_folder.filePath(QStringLiteral("broken.png"));
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no image") > 0);
        file.close();
        Shown shown;
        drop(shown.window, picture());
        QTRY_VERIFY(!shown.seen().none());
        drop(shown.window, broken);
        QTRY_VERIFY(shown.banner().contains(QStringLiteral("broken.png")));
        QVERIFY(!shown.seen().none());
        QCOMPARE(metadataOf(shown.window).references.at(0).path, std::filesystem::path(picture().toStdString()));
    }

    void aFileThatIsGoneIsSaidAndKeepsItsPlace()
    {
        const std::filesystem::path gone(m_folder.filePath(QStringLiteral("gone.png")).toStdString());
        core::DocumentMetadata metadata;
        metadata.references = {{"front", gone, 42, 1, 2, 0.5, true}};
        Shown shown;
        ui::applyMetadata(shown.window, metadata);
        QTRY_VERIFY(shown.banner().contains(QStringLiteral("gone.png")));
        QVERIFY(shown.seen().none());
        QVERIFY(metadataOf(shown.window).references == metadata.references);
        QVERIFY(shown.action("reference.remove")->isEnabled());
    }

    /// A reset keeps the images and shows hidden ones.
    void resettingKeepsThem()
    {
        Shown shown;
        drop(shown.window, picture());
        QTRY_VERIFY(!shown.seen().none());
        shown.trigger("reference.show");
        QVERIFY(shown.seen().none());
        shown.trigger("edit.preferences");
        Q_EMIT shown.window.findChild<ui::PreferencesDialog*>()->resetRequested();
        QVERIFY(!shown.seen().none());
        QVERIFY(ui::Settings().get(&ui::Setting::showsReferences));
    }

    /// Mip levels are uploaded over several frames; the finest is visible in the last frame.
    void aLargeImageGrowsSharp_data()
    {
        QTest::addColumn<ui::Scene::Mode>("mode");
        QTest::newRow("by Qt3D") << ui::Scene::Mode::Qt3d;
        QTest::newRow("by OpenGL") << ui::Scene::Mode::OpenGl;
    }

    void aLargeImageGrowsSharp()
    {
        QFETCH(ui::Scene::Mode, mode);
        const QString large = m_folder.filePath(QStringLiteral("fine.png"));
        QVERIFY(testPicture({3000, 3000}).save(large));
        const ui::SharedReferencePicture picture = ui::readReference(large);
        ui::Scene scene(mode);
        ui::OrbitCamera camera;
        camera.setViewport(100, 100);
        camera.turnTo(Side::Front);
        ui::References references;
        references[static_cast<std::size_t>(Side::Front)] = {picture, {}};
        scene.showReference(ui::seenReference(references, camera, {}));
        int frames = 1;
        while (scene.render(camera, {100, 100}, 1).isDraft)
            ++frames;
        QCOMPARE(frames, 3); // levels of up to a million pixels, then 1500 x 1500, then 3000 x 3000
        QVERIFY(!scene.render(camera, {100, 100}, 1).isDraft);
    }

    void largeImagesAreMadeSmaller()
    {
        const QString large = m_folder.filePath(QStringLiteral("large.png"));
        QVERIFY(testPicture({ui::maxReferencePixels + 904, 500}).save(large));
        const ui::SharedReferencePicture picture = ui::readReference(large);
        QVERIFY(picture);
        QCOMPARE(picture->size().width(), ui::maxReferencePixels);
        QCOMPARE(picture->size().height(), 409);
        QCOMPARE(picture->levels.back().size(), QSize(1, 1));
        for (std::size_t i = 1; i < picture->levels.size(); ++i)
            QCOMPARE(picture->levels[i].width(), std::max(picture->levels[i - 1].width() / 2, 1));
        QVERIFY(!ui::readReference(m_folder.filePath(QStringLiteral("none.png"))));
    }

private:
    QString picture() const { return m_folder.filePath(QStringLiteral("picture.png")); }

    QTemporaryDir m_folder;
};

FETTLE_TEST(TestReferenceImages, ui::TestApplication)
#include "tst_reference_images.moc"
