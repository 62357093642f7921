#pragma once

#include <QWidget>

class QLabel;

namespace ui
{
class SimulatorView;

/// The VR simulator's window, beside the program's: what the headset shows, and which key does what. Thread: gui.
class SimulatorWindow : public QWidget
{
    Q_OBJECT

public:
    explicit SimulatorWindow(QWidget* main);

    SimulatorView* view() const { return m_view; }
    /// Shows the window at the start of a visit, with nothing pressed.
    void begin();

Q_SIGNALS:
    /// Somebody closed it, and so wants to leave VR.
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
