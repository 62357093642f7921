#pragma once

#include <QFrame>

namespace ui
{
/// A frame with controls in the lower right corner of the view, as large as they need. Hidden at first. Thread: gui.
class ViewCard : public QFrame
{
    Q_OBJECT

public:
    ViewCard(QWidget* view, const char* name);
    /// Adapts the size to the controls that are visible.
    void place();

Q_SIGNALS:
    /// Return was pressed, and no button has the focus. The view gets the focus, so that Undo undoes the model.
    void entered();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};
} // namespace ui
