#pragma once

#include <QIcon>
#include <QWidget>

namespace ui
{
/// What somebody who stands across the room reads of the brush.
struct CaptionText
{
    QIcon icon;           ///< the tool's
    QString tool, radius; ///< the latter with its unit
    QString time;         ///< that is left of a turn; empty: it has no end
    bool isNearEnd = false;

    /// The icon goes with the tool.
    bool operator==(const CaptionText& other) const
    {
        return tool == other.tool && radius == other.radius && time == other.time && isNearEnd == other.isNearEnd;
    }
};

/// One line in letters that are read from three metres: of a screen's usual size and distance between dots they are 14
/// mm high, and they grow with the window's text. Smaller only where the line would not fit its width, or would take
/// too much of a low window; its height follows.
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
    QFont m_font; ///< that fits
};
} // namespace ui
