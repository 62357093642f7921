#pragma once

#include <QByteArray>

#include <filesystem>

namespace ui
{
struct ClassReport;

/// One page, alone in its file: pictures, style and the few lines of script that sort are inside of it, nothing is
/// fetched, and no script but ours would run. Without scripts all can be read, in the rows' order. `path`: of the page,
/// for its links. UTF-8.
QByteArray reportHtml(const ClassReport& report, const std::filesystem::path& path);
} // namespace ui
