#pragma once

#include <QColor>
#include <QImage>

namespace vr
{
/// The drawing :/icons/<name>.svg in that colour, `pixels` wide and high; null if there is none. Any thread.
QImage iconPicture(const QString& name, const QColor& ink, int pixels);
} // namespace vr
