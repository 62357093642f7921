#pragma once

#include "core/drawing/line_drawing.h"

#include <QDate>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <filesystem>

class QPainter;
class QPdfWriter;

namespace ui
{
/// "pdf", "svg", "png".
QStringList drawingEndings();

/// What one page says. Any thread.
struct DrawingSheet
{
    QString name; ///< of the model
    QDate date;
    core::LineDrawing drawing;
    bool shaded = false;
};

/// A4 across, in mm of paper.
inline constexpr QSizeF sheetSize{297, 210};

/// How fine a sheet's drawing is.
core::DrawingDetail sheetDetail(bool shaded);

/// Paper to model: the largest of ... 10, 5, 2, 1, 1/2, 1/5, 1/10 ... at which the three views fit; 0 if there is no
/// model.
double sheetScale(const DrawingSheet& sheet);
/// The bar under the views, in mm of paper: it is a round number of the model's mm long.
QRectF sheetScaleBar(const DrawingSheet& sheet);
/// "1:2"
QString sheetScaleText(double scale);

/// A PDF whose pages are sheets, and its painter, before the first of them.
void prepareForSheets(QPdfWriter& writer, const QString& title);
void scaleToSheet(QPainter& painter);
/// Black on white, in units of 1/100 mm of paper.
void paintSheet(QPainter& painter, const DrawingSheet& sheet);

/// In the format that the ending says, one of drawingEndings(); true to scale when printed at 100 %. All or nothing is
/// written. Throws core::FileError. May take a second with many lines: not for the gui thread.
void writeSheet(const std::filesystem::path& path, const DrawingSheet& sheet);
} // namespace ui
