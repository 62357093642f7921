// Sizes on the sheet: the page size in its files, and the true lengths of the drawing.

#include "ui/drawing/drawing_painter.h"
#include "ui/drawing/drawing_sheet.h"

#include "core/mesh/dirty_slots.h"
#include "core/util/file_error.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include <cmath>

namespace
{
core::LineDrawing drawingOf(const core::TriangleMesh& mesh)
{
    core::DrawArrays model;
    model.apply(core::wholePatchOf(*mesh_asserts::sculptable(mesh)));
    return core::drawLines(model, {512}, {}).value();
}

ui::DrawingSheet sheetOf(float side)
{
    return {QStringLiteral("a cube & more"), QDate(2024, 2, 29), drawingOf(shapes::cube(side))};
}

/// Returns true for 1, 2 or 5 times a power of ten.
bool isRound(double value)
{
    const double mantissa = value / std::pow(10, std::floor(std::log10(value) + 1e-9));
    return std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6;
}

bool isDark(const QImage& image, int x, int y)
{
    return qAlpha(image.pixel(x, y)) > 128 && qGray(image.pixel(x, y)) < 128;
}

QByteArray written(const QString& path, const ui::DrawingSheet& sheet)
{
    ui::writeSheet(path.toStdU16String(), sheet);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace

class TestDrawingSheet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theScaleIsRoundAndTheLargestThatFits_data()
    {
        QTest::addColumn<float>("side");
        for (const float side : {0.3F, 4.0F, 30.0F, 55.0F, 80.0F, 300.0F, 2000.0F})
            QTest::addRow("%g mm", static_cast<double>(side)) << side;
    }

    void theScaleIsRoundAndTheLargestThatFits()
    {
        QFETCH(float, side);
        const ui::DrawingSheet sheet = sheetOf(side);
        const double scale = ui::sheetScale(sheet), two = 2 * static_cast<double>(side);
        QVERIFY(isRound(scale >= 1 ? scale : 1 / scale));
        QVERIFY(two * scale < 210); // two views fit above each other on the sheet
        QVERIFY(two * scale >
                0.25 * 210); // they would not fit, with texts and frame, at the next scale (at most 2.5 times larger)
        const QRectF bar = ui::sheetScaleBar(sheet);
        QVERIFY(isRound(bar.width() / scale));
        QVERIFY(bar.width() >= 20 && bar.width() <= 50);
        QVERIFY(QRectF({}, ui::sheetSize).contains(bar));
    }

    void theScaleIsInWords()
    {
        QCOMPARE(ui::sheetScaleText(1), QStringLiteral("1:1"));
        QCOMPARE(ui::sheetScaleText(0.2), QStringLiteral("1:5"));
        QCOMPARE(ui::sheetScaleText(20), QStringLiteral("20:1"));
    }

    void aViewIsAsLargeAsItsScaleSays()
    {
        const core::LineDrawing drawing = drawingOf(shapes::cube(40));
        QImage image(800, 600, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        QFont font;
        font.setPixelSize(10);
        const ui::DrawingStyle style{Qt::black, Qt::white, 2, font};
        ui::DrawingLayout(drawing, {ui::DrawnSides::Right, false, false}, style,
                          ui::DrawingLayout::Arrangement::Projection)
            .paint(painter, {400, 300}, 10);
        painter.end();
        int left = image.width(), right = 0;
        for (int x = 0; x < image.width(); ++x)
            if (isDark(image, x, image.height() / 2)) {
                left = std::min(left, x);
                right = std::max(right, x);
            }
        QVERIFY(std::abs(right - left + 1 - (400 + 2)) <= 1); // plus the line's width
    }

    void theBarIsTrueOnAPicture()
    {
        const QTemporaryDir folder;
        const ui::DrawingSheet sheet = sheetOf(40);
        const QImage image = QImage::fromData(written(folder.filePath(QStringLiteral("a.png")), sheet));
        const double dotsPerMm = image.dotsPerMeterX() / 1000.0;
        QVERIFY(std::abs(image.width() / dotsPerMm - 297) < 0.1 && std::abs(image.height() / dotsPerMm - 210) < 0.1);
        const QRectF bar = ui::sheetScaleBar(sheet);
        const int row = static_cast<int>(bar.center().y() * dotsPerMm);
        int first = 0, last = 0;
        for (int x = static_cast<int>((bar.left() - 1) * dotsPerMm);
             x < static_cast<int>((bar.right() + 1) * dotsPerMm); ++x)
            if (isDark(image, x, row)) {
                first = first == 0 ? x : first;
                last = x;
            }
        QVERIFY(std::abs((last - first) / dotsPerMm - bar.width()) < 0.3);
    }

    void thePdfIsOnePageOfA4()
    {
        const QTemporaryDir folder;
        const QByteArray pdf = written(folder.filePath(QStringLiteral("a.pdf")), sheetOf(40));
        QVERIFY(pdf.startsWith("%PDF-"));
        QVERIFY(pdf.trimmed().endsWith("%%EOF"));
        const auto box = QRegularExpression(QStringLiteral("MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]"))
                             .match(QString::fromLatin1(pdf));
        QVERIFY(box.hasMatch());
        QVERIFY(std::abs(box.captured(1).toDouble() - 297 / 25.4 * 72) < 0.5);
        QVERIFY(std::abs(box.captured(2).toDouble() - 210 / 25.4 * 72) < 0.5);
        QCOMPARE(pdf.count("/Type /Page\n"), 1);
    }

    void theSvgIsInMillimetresAndNamesTheModel()
    {
        const QTemporaryDir folder;
        const QByteArray svg = written(folder.filePath(QStringLiteral("a.SVG")), sheetOf(40));
        QVERIFY(svg.contains("width=\"297mm\"") && svg.contains("height=\"210mm\""));
        QVERIFY(svg.contains("a cube &amp; more"));
        QSvgRenderer renderer(svg);
        QVERIFY(renderer.isValid());
        QImage image(1188, 840, QImage::Format_ARGB32_Premultiplied); // 4 pixels for 1 mm
        image.fill(Qt::white);
        QPainter painter(&image);
        renderer.render(&painter);
        painter.end();
        QVERIFY(isDark(image, 40, 420) || isDark(image, 39, 420)); // frame line, 10 mm from the edge
        QVERIFY(!isDark(image, 20, 420));
    }

    void colorsAreWrittenToo()
    {
        const QTemporaryDir folder;
        core::TriangleMesh mesh = core::icosphere(3, 30);
        mesh.colors.assign(mesh.points.size(), {0, 0, 255});
        core::DrawArrays model;
        model.apply(core::wholePatchOf(*mesh_asserts::sculptable(mesh)));
        const ui::DrawingSheet sheet{QStringLiteral("ball"), QDate(2024, 2, 29),
                                     core::drawLines(model, {512, true}, {}).value(), true};
        const QImage image = QImage::fromData(written(folder.filePath(QStringLiteral("a.png")), sheet));
        int blue = 0;
        for (int x = 0; x < image.width(); ++x)
            for (int y = 0; y < image.height(); y += 10)
                blue += qBlue(image.pixel(x, y)) > qRed(image.pixel(x, y)) + 50 ? 1 : 0;
        QVERIFY(blue > 100);
    }

    void whatCannotBeWrittenLeavesNothing()
    {
        const QTemporaryDir folder;
        const QString inNoFolder = folder.filePath(QStringLiteral("none/a.pdf"));
        QVERIFY_THROWS_EXCEPTION(core::FileError, ui::writeSheet(inNoFolder.toStdU16String(), sheetOf(40)));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void noModelIsAnEmptySheet()
    {
        const QTemporaryDir folder;
        QVERIFY(!written(folder.filePath(QStringLiteral("a.svg")), {QStringLiteral("nothing"), QDate(2024, 2, 29), {}})
                     .isEmpty());
    }
};

FETTLE_TEST(TestDrawingSheet, ui::TestApplication)
#include "tst_drawing_sheet.moc"
