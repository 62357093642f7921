#include "model_formats.h"

#include "core/mesh_io.h"

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
} // namespace

QStringList modelEndings()
{
    return toList(core::meshEndings());
}

QStringList writtenEndings()
{
    return toList(core::writtenEndings());
}

QString modelFormats()
{
    return modelEndings().join(QStringLiteral(", ")).toUpper();
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
