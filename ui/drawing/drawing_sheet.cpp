// A sheet: the views in the middle, and below them a strip with name, size and scale. Layout is in units of 1/100 mm:
// font sizes are whole numbers of units, so small units allow nearly any size.
#include "ui/drawing/drawing_sheet.h"

#include "ui/drawing/drawing_painter.h"
#include "ui/util/number_format.h"

#include "core/util/atomic_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
struct SheetText
{
    Q_DECLARE_TR_FUNCTIONS(ui::DrawingSheet)
};

constexpr int unit = 100;                                     ///< painter units in a mm
constexpr double sheetMargin = 10, stripHeight = 24, pad = 4; ///< mm
constexpr double smallText = 3, largeText = 5;                ///< mm, heights of the text
constexpr int pngDotsPerInch = 300, svgDotsPerInch = 254, pdfDotsPerInch = 1200;
constexpr double mmPerInch = 25.4;
constexpr double maxBarLength = 50; ///< longest scale bar, mm of paper

QRectF frame()
{
    return QRectF({}, sheetSize).adjusted(sheetMargin, sheetMargin, -sheetMargin, -sheetMargin);
}

QRectF viewsArea()
{
    return frame().adjusted(pad, pad, -pad, -stripHeight - pad);
}

QRectF strip()
{
    QRectF result = frame();
    result.setTop(result.bottom() - stripHeight);
    return result;
}

QFont textOf(double height)
{
    QFont font;
    font.setPixelSize(static_cast<int>(height * unit));
    return font;
}

DrawingStyle style()
{
    return {Qt::black, QColor(70, 70, 70), 0.35 * unit, textOf(smallText)};
}

/// Returns the layout of the views; it keeps a reference to the sheet's drawing.
DrawingLayout layoutOf(const DrawingSheet& sheet)
{
    return {sheet.drawing, {DrawnSides::All, sheet.shaded, true}, style(), DrawingLayout::Arrangement::Projection};
}

/// Returns the largest number of the form 1, 2 or 5 times a power of ten that is at most `max`.
double roundBelow(double max)
{
    const double power = std::pow(10.0, std::floor(std::log10(max) + 1e-9));
    for (const double step : {5.0, 2.0})
        if (step * power <= max * (1 + 1e-9))
            return step * power;
    return power;
}

double roundAbove(double min)
{
    const double below = roundBelow(min);
    return below >= min * (1 - 1e-9) ? below : roundBelow(2.5 * below);
}

QRectF inUnits(const QRectF& mm)
{
    return {mm.topLeft() * unit, mm.size() * unit};
}

struct Field
{
    QString name, value;
    double share; ///< fraction of the strip's width
};

/// Paints a label and, below it, its value, elided if it is too long.
void paintField(QPainter& painter, const Field& field, const QRectF& area)
{
    painter.setPen(style().faint);
    painter.setFont(textOf(smallText * 0.85));
    painter.drawText(inUnits(area), Qt::AlignLeft | Qt::AlignTop, field.name);
    painter.setPen(Qt::black);
    const QFont font = textOf(largeText * 0.8);
    painter.setFont(font);
    const QRectF below = area.adjusted(0, smallText * 1.6, 0, 0);
    painter.drawText(inUnits(below), Qt::AlignLeft | Qt::AlignTop,
                     QFontMetricsF(font).elidedText(field.value, Qt::ElideMiddle, below.width() * unit));
}

void paintScaleBar(QPainter& painter, const DrawingSheet& sheet)
{
    const QRectF bar = sheetScaleBar(sheet);
    const double length = bar.width() / sheetScale(sheet);
    painter.setPen(QPen(Qt::black, 0.2 * unit));
    for (int i = 0; i < 5; ++i) {
        const QRectF part(bar.left() + i * bar.width() / 5, bar.top(), bar.width() / 5, bar.height());
        painter.setBrush(i % 2 == 0 ? Qt::black : Qt::white);
        painter.drawRect(inUnits(part));
    }
    painter.setFont(textOf(smallText));
    const QRectF above(bar.left(), bar.top() - 1.6 * smallText, bar.width(), 1.5 * smallText);
    painter.drawText(inUnits(above), Qt::AlignLeft | Qt::AlignVCenter, QLocale().toString(0));
    painter.drawText(inUnits(above.adjusted(0, 0, pad, 0)), Qt::AlignRight | Qt::AlignVCenter,
                     SheetText::tr("%1 mm").arg(QLocale().toString(length)));
}

/// Paints the standard's sign of the projection: a truncated cone, seen from the front and from the side.
void paintProjectionSign(QPainter& painter, const QPointF& at)
{
    painter.setPen(QPen(Qt::black, 0.2 * unit));
    painter.setBrush(Qt::NoBrush);
    const auto point = [&at](double x, double y) { return (at + QPointF(x, y)) * unit; };
    painter.drawEllipse(point(3, 0), 2.6 * unit, 2.6 * unit);
    painter.drawEllipse(point(3, 0), 1.3 * unit, 1.3 * unit);
    painter.drawPolygon(QPolygonF{point(8, -1.3), point(14, -2.6), point(14, 2.6), point(8, 1.3)});
}

void paintStrip(QPainter& painter, const DrawingSheet& sheet)
{
    const core::Vec3 size = sheet.drawing.box.isEmpty() ? core::Vec3(0, 0, 0) : core::Vec3(sheet.drawing.box.sizes());
    const Field fields[] = {
        {SheetText::tr("Model"), sheet.name, 0.27},
        {SheetText::tr("Width × height × depth"),
         SheetText::tr("%1 × %2 × %3 mm").arg(millimetres(size.x()), millimetres(size.y()), millimetres(size.z())),
         0.27},
        {SheetText::tr("Volume"), volumeText(std::abs(sheet.drawing.volume)), 0.16},
        {SheetText::tr("Scale"), sheetScaleText(sheetScale(sheet)), 0.12},
        {SheetText::tr("Date"), QLocale().toString(sheet.date, QLocale::ShortFormat), 0.18}};
    const QRectF area = strip();
    double left = area.left();
    for (const Field& field : fields) {
        const double width = field.share * area.width();
        paintField(painter, field, {left + pad / 2, area.top() + pad / 2, width - pad, stripHeight / 2 - pad / 2});
        left += width;
        if (left < area.right() - 1) {
            painter.setPen(QPen(Qt::black, 0.2 * unit));
            painter.drawLine(QPointF(left, area.top()) * unit, QPointF(left, area.top() + stripHeight / 2) * unit);
        }
    }
    painter.setPen(QPen(Qt::black, 0.2 * unit));
    painter.drawLine(QPointF(area.left(), area.center().y()) * unit, QPointF(area.right(), area.center().y()) * unit);
    painter.setPen(style().faint);
    painter.setFont(textOf(smallText));
    painter.drawText(inUnits({area.center().x(), area.center().y(), area.width() / 2 - 20, stripHeight / 2}),
                     Qt::AlignRight | Qt::AlignVCenter, SheetText::tr("True to scale when printed at 100 % on A4"));
    paintProjectionSign(painter, {area.right() - 16, area.bottom() - stripHeight / 4});
    if (!sheet.drawing.box.isEmpty())
        paintScaleBar(painter, sheet);
}

void paintPdf(QBuffer& file, const DrawingSheet& sheet)
{
    QPdfWriter writer(&file);
    prepareForSheets(writer, sheet.name);
    QPainter painter(&writer);
    scaleToSheet(painter);
    paintSheet(painter, sheet);
}

void paintSvg(QBuffer& file, const DrawingSheet& sheet)
{
    QSvgGenerator generator;
    generator.setOutputDevice(&file);
    generator.setResolution(svgDotsPerInch);
    generator.setSize((sheetSize * (svgDotsPerInch / mmPerInch)).toSize());
    generator.setViewBox(QRectF({}, sheetSize * unit));
    generator.setTitle(sheet.name.toHtmlEscaped()); // Qt does not escape it
    QPainter painter(&generator);
    paintSheet(painter, sheet);
}

void paintPng(QBuffer& file, const DrawingSheet& sheet)
{
    constexpr double dotsPerMm = pngDotsPerInch / mmPerInch;
    QImage image((sheetSize * dotsPerMm).toSize(), QImage::Format_RGB32);
    image.setDotsPerMeterX(static_cast<int>(std::lround(1000 * dotsPerMm)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(dotsPerMm / unit, dotsPerMm / unit);
    paintSheet(painter, sheet);
    painter.end();
    image.save(&file, "PNG");
}

struct Format
{
    QLatin1StringView ending;
    void (*paint)(QBuffer& file, const DrawingSheet& sheet);
};
constexpr Format formats[] = {
    {QLatin1StringView("pdf"), paintPdf}, {QLatin1StringView("svg"), paintSvg}, {QLatin1StringView("png"), paintPng}};
} // namespace

QStringList drawingEndings()
{
    QStringList all;
    for (const Format& format : formats)
        all << format.ending;
    return all;
}

core::DrawingDetail sheetDetail(bool shaded)
{
    constexpr int pixels = 3072; // along the longest side of the model
    constexpr std::size_t maxEdges = 300'000;
    return {pixels, shaded, maxEdges};
}

double sheetScale(const DrawingSheet& sheet)
{
    const double max = layoutOf(sheet).scaleFor(viewsArea().size() * unit) / unit;
    if (!(max > 0))
        return 0;
    return max >= 1 ? roundBelow(max) : 1 / roundAbove(1 / max);
}

QRectF sheetScaleBar(const DrawingSheet& sheet)
{
    const double scale = sheetScale(sheet);
    if (!(scale > 0))
        return {};
    const double length = roundBelow(maxBarLength / scale) * scale;
    return {strip().left() + pad / 2, strip().bottom() - pad - 0.5, length, 2};
}

QString sheetScaleText(double scale)
{
    const auto text = [](double value) { return QLocale::c().toString(value, 'g', 12); };
    return scale >= 1 ? text(scale) + QStringLiteral(":1")
                      : QStringLiteral("1:") + text(scale > 0 ? std::round(1 / scale) : 0);
}

void prepareForSheets(QPdfWriter& writer, const QString& title)
{
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Landscape, {}));
    writer.setResolution(pdfDotsPerInch);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Fettle"));
}

void scaleToSheet(QPainter& painter)
{
    const double scale = painter.device()->logicalDpiX() / mmPerInch / unit;
    painter.scale(scale, scale);
}

void paintSheet(QPainter& painter, const DrawingSheet& sheet)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::black, 0.35 * unit));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(inUnits(frame()));
    painter.drawLine(strip().topLeft() * unit, strip().topRight() * unit);
    layoutOf(sheet).paint(painter, viewsArea().center() * unit, sheetScale(sheet) * unit);
    paintStrip(painter, sheet);
}

void writeSheet(const std::filesystem::path& path, const DrawingSheet& sheet)
{
    const QString ending = QString::fromStdU16String(path.extension().u16string()).mid(1).toLower();
    const auto format = std::ranges::find(formats, ending, &Format::ending);
    Q_ASSERT(format != std::end(formats));
    core::AtomicFile file(path); // opened first: an unwritable path fails before any painting
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    format->paint(bytes, sheet);
    file.write({bytes.data().constData(), static_cast<std::size_t>(bytes.data().size())});
    file.commit();
}
} // namespace ui
