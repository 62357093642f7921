#include "ui/util/format_filters.h"

#include "core/io/mesh_io.h"

#include <QCoreApplication>

#include <algorithm>

namespace ui
{
namespace
{
QStringList toList(std::span<const std::string_view> words)
{
    QStringList list;
    for (const std::string_view word : words)
        list << QLatin1StringView(word.data(), static_cast<qsizetype>(word.size()));
    return list;
}

class FormatFilters
{
    Q_DECLARE_TR_FUNCTIONS(ui::FormatFilters)
};
} // namespace

QStringList modelEndings()
{
    return toList(core::readEndings());
}

QStringList writtenEndings()
{
    return toList(core::writtenEndings());
}

QStringList reportEndings()
{
    return {QStringLiteral("html"), QStringLiteral("pdf")};
}

QString classEnding()
{
    return QStringLiteral("fettleclass");
}

bool isClassFile(const QString& path)
{
    return path.endsWith(u'.' + classEnding(), Qt::CaseInsensitive);
}

QString modelFormats()
{
    constexpr qsizetype named = 4;
    const auto own = static_cast<qsizetype>(core::meshEndings().size());
    const QStringList all = modelEndings();
    const QString words = all.first(std::min(all.size(), own + named)).join(QStringLiteral(", ")).toUpper();
    return all.size() > own + named ? FormatFilters::tr("%1 and others").arg(words) : words;
}

bool isDocumentFormat(const QString& path)
{
    return core::meshFormatOf(path.toStdU16String()) == core::MeshFormat::Glb;
}

QString writtenFormats()
{
    return writtenEndings().join(QStringLiteral(", ")).toUpper();
}

bool isWritten(const QString& path)
{
    return core::isWritten(path.toStdU16String());
}
} // namespace ui
