#include "model_formats.h"

#include "core/mesh_io.h"

namespace ui
{
QStringList modelEndings()
{
    QStringList endings;
    for (const std::string_view ending : core::meshEndings())
        endings << QLatin1StringView(ending.data(), static_cast<qsizetype>(ending.size()));
    return endings;
}

QString modelFormats()
{
    return modelEndings().join(QStringLiteral(", ")).toUpper();
}

bool isDocumentFormat(const QString& path)
{
    return core::meshFormatOf(path.toStdU16String()) == core::MeshFormat::Glb;
}
} // namespace ui
