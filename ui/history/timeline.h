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

/// A slider over the states of the model, from the first that is kept to the last, with number and name of the step;
/// Left and Right go by one. It plays them, too. Knows no document: it shows what it is given, and asks. Thread: gui.
class Timeline : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    /// While the model is on its way to the state that was asked for, the slider stays there.
    void setHistory(const History& history);

Q_SIGNALS:
    /// Many in a row while somebody drags: only the newest counts.
    void stateRequested(int state);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void requestState(int state);
    void showState(const QString& name);
    void setPlaying(bool isPlaying);
    void playNext();
    QString nameOf(int state) const;

    QStringList m_names; ///< of the steps
    int m_present = 0;
    std::optional<int> m_requested; ///< not reached yet
    QSlider* m_slider;
    QLabel* m_text;
    QToolButton* m_play;
    QTimer m_playTimer;
};
} // namespace ui
