#include "vr/panels/panel_icons.h"

#include <QFile>
#include <QImageReader>
#include <QtCore/QBuffer> // the full path, because Qt3D has a header <QBuffer> too

namespace vr
{
namespace
{
/// Colour in the files that is replaced by `ink`.
constexpr char inkInFile[] = "#000000";
} // namespace

QImage iconPicture(const QString& name, const QColor& ink, int pixels)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray drawing = file.readAll().replace(inkInFile, ink.name().toLatin1());
    QBuffer buffer(&drawing);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize({pixels, pixels});
    return reader.read();
}
} // namespace vr
