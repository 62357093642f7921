#pragma once

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class QSlider;
class QToolButton;

namespace ui
{
struct History;

/// A slider over the kept states of the model, with the number and name of the step; Left and Right move by one state.
/// A button plays the states. Knows no document: setHistory() provides what is shown, and stateRequested() requests
/// changes. Thread: gui.
class Timeline : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    /// Shows a changed history. The slider stays at a requested state until the model has reached it.
    void setHistory(const History& history);

Q_SIGNALS:
    /// The user wants this state. Emitted repeatedly during a drag; only the latest counts.
    void stateRequested(int state);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void requestState(int state);
    void showState(const QString& name);
    void setPlaying(bool isPlaying);
    void playNext();
    QString nameOf(int state) const;

    QStringList m_names; ///< names of the steps
    int m_present = 0;
    std::optional<int> m_requested; ///< state that was requested and has not been reached
    QSlider* m_slider;
    QLabel* m_text;
    QToolButton* m_play;
    QTimer m_playTimer;
};
} // namespace ui
