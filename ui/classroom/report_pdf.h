#pragma once

#include <QByteArray>

#include <filesystem>

namespace ui
{
struct ClassReport;

/// A4, upright: the heads on each page, no row cut by a page's end, "2 / 4" at the foot; names are links. `path`: of
/// the file, for these. Needs a QGuiApplication, whose fonts it uses. Any thread.
QByteArray reportPdf(const ClassReport& report, const std::filesystem::path& path);
} // namespace ui
