#pragma once

#include "core/operations/starter_models.h"

#include <QFrame>
#include <QList>

class QButtonGroup;
class QLineEdit;
class QPushButton;

namespace ui
{
class Actions;

/// Asks who sculpts next, and with what to begin, before a turn. Lies over all of a widget, which nobody reaches
/// meanwhile. Thread: gui.
class PupilNamePanel : public QFrame
{
    Q_OBJECT

public:
    static constexpr int maxNameLength = 40; ///< characters

    /// The starters look as their actions do, in that order.
    PupilNamePanel(const QList<core::Starter>& starters, const Actions& actions, QWidget* over);

    /// Without a name, and with the first starter.
    void open();
    void close();

Q_SIGNALS:
    /// The name has no space at its ends, and is not empty.
    void begun(const QString& pupil, core::Starter starter);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* card(const QList<core::Starter>& starters, const Actions& actions);
    QLayout* tiles(const QList<core::Starter>& starters, const Actions& actions);
    void begin();

    QWidget* m_over;
    QLineEdit* m_name;
    QButtonGroup* m_starters; ///< by core::Starter
    QPushButton* m_begin;
};
} // namespace ui
