#pragma once

#include <QIcon>
#include <QWidget>

namespace ui
{
/// The brush's state in words, for an audience that watches from across the room.
struct CaptionText
{
    QIcon icon;           ///< icon of the tool
    QString tool, radius; ///< tool name; radius with its unit
    QString time;         ///< time left of the turn; empty: the turn has no end
    bool isNearEnd = false;

    /// Ignores the icon, which depends on the tool only.
    bool operator==(const CaptionText& other) const
    {
        return tool == other.tool && radius == other.radius && time == other.time && isNearEnd == other.isNearEnd;
    }
};

/// A line of text that can be read from three metres: letters are about 14 mm high on a usual screen and scale with the
/// window's text size. The letters shrink if the line does not fit the width, or takes too much height of the window.
/// The caption's height is that of its font.
class BrushCaption : public QWidget
{
    Q_OBJECT

public:
    explicit BrushCaption(QWidget* parent = nullptr);

    void setText(const CaptionText& words);
    const CaptionText& text() const { return m_text; }

    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void fit();

    CaptionText m_text;
    QFont m_font; ///< largest font that fits
};
} // namespace ui
