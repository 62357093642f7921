#pragma once

#include <QLabel>
#include <QTimer>

namespace ui
{
/// A message over the lower edge of its parent that disappears after a while. Transparent for the mouse.
class NotificationBanner : public QLabel
{
    Q_OBJECT

public:
    explicit NotificationBanner(QWidget* parent);

    /// Stands above that sibling, which must outlive this, where it would cover it.
    void stayAbove(QWidget* sibling);
    /// Replaces what is shown.
    void showMessage(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QWidget* m_sibling = nullptr;
    QTimer m_timer;
};
} // namespace ui
