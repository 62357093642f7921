#pragma once

#include <QByteArray>

#include <filesystem>

namespace ui
{
struct ClassReport;

/// Returns the report as a PDF of upright A4 pages. Heads are repeated on each page, rows are not split across pages,
/// and the foot has "2 / 4". Names link to the models. `path`: file of the PDF, for the links. Precondition: a
/// QGuiApplication exists, because fonts are used. Thread: any.
QByteArray reportPdf(const ClassReport& report, const std::filesystem::path& path);
} // namespace ui
