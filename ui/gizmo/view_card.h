#pragma once

#include <QFrame>

namespace ui
{
/// A frame with controls in the lower right corner of the view, as wide as they need. Hidden at first. Thread: gui.
class ViewCard : public QFrame
{
public:
    ViewCard(QWidget* view, const char* name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void place();
};
} // namespace ui
