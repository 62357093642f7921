#pragma once

#include <QColor>
#include <QImage>

namespace vr
{
/// Returns the drawing :/icons/<name>.svg in the colour `ink`, `pixels` wide and high; null if there is no such file.
/// Thread: any.
QImage iconPicture(const QString& name, const QColor& ink, int pixels);
} // namespace vr
