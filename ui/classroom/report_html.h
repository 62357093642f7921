#pragma once

#include <QByteArray>

#include <filesystem>

namespace ui
{
struct ClassReport;

/// Returns the report as one self-contained HTML page in UTF-8: pictures, style and the sorting script are embedded,
/// and nothing is fetched. Its security policy blocks other scripts. Without scripts everything is readable, unsorted.
/// `path`: file of the page, for relative links to the models.
QByteArray reportHtml(const ClassReport& report, const std::filesystem::path& path);
} // namespace ui
