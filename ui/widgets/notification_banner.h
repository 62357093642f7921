#pragma once

#include <QLabel>
#include <QTimer>

namespace ui
{
/// A sentence over the lower edge of its parent, which goes by itself. The mouse goes through it.
class Banner : public QLabel
{
    Q_OBJECT

public:
    explicit Banner(QWidget* parent);

    /// Stands above that sibling, which must outlive this, where it would cover it.
    void keepOff(QWidget* sibling);
    /// Replaces what is shown.
    void say(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QWidget* m_sibling = nullptr;
    QTimer m_timer;
};
} // namespace ui
