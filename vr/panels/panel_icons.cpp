#include "vr/panels/panel_icons.h"

#include <QFile>
#include <QImageReader>
#include <QtCore/QBuffer> // Qt3D has one of that name, too

namespace vr
{
namespace
{
/// The colour in the files that stands for the text's.
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
