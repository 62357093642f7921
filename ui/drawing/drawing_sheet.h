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
/// Returns the suffixes "pdf", "svg" and "png".
QStringList drawingEndings();

/// The content of a sheet. Thread: any.
struct DrawingSheet
{
    QString name; ///< name of the model
    QDate date;
    core::LineDrawing drawing;
    bool shaded = false;
};

/// Size of A4 landscape paper, mm.
inline constexpr QSizeF sheetSize{297, 210};

/// Returns the level of detail of a sheet's drawing.
core::DrawingDetail sheetDetail(bool shaded);

/// Returns the ratio of paper to model: the largest of ..., 10, 5, 2, 1, 1/2, 1/5, 1/10, ... at which the three views
/// fit; 0 if there is no model.
double sheetScale(const DrawingSheet& sheet);
/// Returns the rectangle of the scale bar below the views, mm of paper. Its length is a round number of mm of the
/// model; an empty rectangle if there is no model.
QRectF sheetScaleBar(const DrawingSheet& sheet);
/// Returns the scale as text, such as "1:2".
QString sheetScaleText(double scale);

/// Prepare a PDF writer and its painter for sheets, before the first page is painted.
void prepareForSheets(QPdfWriter& writer, const QString& title);
void scaleToSheet(QPainter& painter);
/// Paints the sheet in black on white, in units of 1/100 mm of paper.
void paintSheet(QPainter& painter, const DrawingSheet& sheet);

/// Writes the sheet atomically in the format of the file's suffix, one of drawingEndings(). Its scale is true when
/// printed at 100 %. Throws core::FileError. Cost: up to a second for many lines; not for the gui thread.
void writeSheet(const std::filesystem::path& path, const DrawingSheet& sheet);
} // namespace ui
