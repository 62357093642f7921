#pragma once

#include <QLabel>
#include <QTimer>

namespace ui
{
/// A message over the lower edge of its parent that disappears after a while. Stays above the cards of the view, whose
/// buttons it must not cover. Transparent for the mouse.
class NotificationBanner : public QLabel
{
    Q_OBJECT

public:
    explicit NotificationBanner(QWidget* parent);

    /// Keeps the banner from covering this sibling by moving above it. The sibling must outlive the banner.
    void stayAbove(QWidget* sibling);
    /// Shows a sentence and replaces the one before.
    void showMessage(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void moveAbove(const QRect& other);

    QWidget* m_sibling = nullptr;
    QTimer m_timer;
};
} // namespace ui
