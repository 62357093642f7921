#pragma once

#include <QWidget>

class QLabel;

namespace ui
{
class SimulatorView;

/// The window of the VR simulator, beside the main window: the picture of the headset and a legend of the keys. Thread:
/// gui.
class SimulatorWindow : public QWidget
{
    Q_OBJECT

public:
    explicit SimulatorWindow(QWidget* main);

    SimulatorView* view() const { return m_view; }
    /// Shows the window at the start of a session, with no button pressed.
    void begin();

Q_SIGNALS:
    /// The user has closed the window, which requests to leave VR.
    void closed();

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* legend();
    void placeBesideMain();
    void showQuestion();
    void showHand();

    SimulatorView* m_view;
    QLabel* m_hand;
};
} // namespace ui
