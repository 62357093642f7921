#include "vr/scene/label_textures.h"

#include <QFontMetrics>
#include <QImage>
#include <QPainter>

#include <cmath>

namespace vr
{
namespace
{
// Sizes in pixels. On the screen a plate is only about a third as high, so that its smaller mip levels are used.
constexpr int plateHeight = 64, textHeight = 40, margin = 20, longestText = 680;
constexpr qsizetype maxKept = 64;

const QColor plateColor(20, 22, 26, 236), borderColor(255, 255, 255, 34), textColor(236, 239, 244);

QFont labelFont()
{
    QFont font;
    font.setPixelSize(textHeight);
    font.setWeight(QFont::Medium);
    return font;
}

QImage paint(const QString& text)
{
    const QFont font = labelFont();
    const QFontMetrics metrics(font);
    const QString shown = metrics.elidedText(text, Qt::ElideRight, longestText);
    QImage image(metrics.horizontalAdvance(shown) + 2 * margin, plateHeight, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(borderColor, 2));
    painter.setBrush(plateColor);
    painter.drawRoundedRect(QRectF(image.rect()).adjusted(2, 2, -2, -2), 16, 16);
    painter.setFont(font);
    painter.setPen(textColor);
    painter.drawText(image.rect(), Qt::AlignCenter, shown);
    return image;
}
} // namespace

void LabelTextures::create(QOpenGLExtraFunctions* gl)
{
    m_gl = gl;
    paint(QStringLiteral("ABCabc"));
}

void LabelTextures::destroy()
{
    for (Entry& entry : m_entries)
        entry.picture.destroy();
    *this = {};
}

void LabelTextures::startFrame()
{
    m_mayPaint = true;
    ++m_frame;
    if (m_entries.size() > maxKept)
        dropUnused();
}

std::optional<LabelTexture> LabelTextures::find(const QString& text)
{
    auto entry = m_entries.find(text);
    if (entry == m_entries.end()) {
        if (!m_mayPaint)
            return {};
        m_mayPaint = false;
        entry = m_entries.insert(text, {});
        entry->picture.create(m_gl);
        entry->picture.upload(paint(text));
    }
    entry->usedIn = m_frame;
    const QSize size = entry->picture.size();
    return LabelTexture{entry->picture.id(), static_cast<double>(size.width()) / size.height()};
}

/// Deletes all textures that the last frame did not use.
void LabelTextures::dropUnused()
{
    for (auto entry = m_entries.begin(); entry != m_entries.end();) {
        if (entry->usedIn + 1 >= m_frame) {
            ++entry;
            continue;
        }
        entry->picture.destroy();
        entry = m_entries.erase(entry);
    }
}
} // namespace vr
