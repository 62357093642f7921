#pragma once

#include <QList>
#include <QWidget>

#include <memory>

class QLabel;
class QSpinBox;
class QTreeView;

namespace ui
{
class Settings;
class SideColumn;
class Timeline;

struct HistoryStep
{
    QString name;
    QString icon;     ///< file in :/icons without its suffix
    quint64 dabs = 0; ///< dabs of the stroke; 0: the step is not a stroke
    quint64 fusions = 0;
};

/// The history as shown by the panel. State 0 is the model as it was opened; state i is the model after steps[i - 1].
struct History
{
    QList<HistoryStep> steps;
    int present = 0;         ///< index of the present state
    int first = 0, last = 0; ///< first and last reachable state; the steps of other states have been discarded
    qint64 bytes = 0;        ///< memory of the history
};

/// A list of the model's steps, a timeline through them, and a limit for their memory. A click or Return goes to any
/// state that is still kept. Knows no document: setHistory() provides what is shown, and signals request changes.
/// Thread: gui.
class HistoryPanel : public QWidget
{
    Q_OBJECT

public:
    explicit HistoryPanel(Settings* settings, QWidget* parent = nullptr);
    ~HistoryPanel() override;

    /// Cost: proportional to the number of visible rows.
    void setHistory(History history);
    qint64 cap() const; ///< limit for the history's memory, bytes

Q_SIGNALS:
    void jumpRequested(int state);
    /// The timeline requests a state. Emitted repeatedly during a drag; only the latest counts.
    void stateRequested(int state);
    void capChanged(qint64 bytes);
    /// The panel has become visible, and its content may be outdated.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    class Model;
    std::unique_ptr<Model> m_model;
    QTreeView* m_list;
    Timeline* m_timeline;
    QLabel* m_memory;
    QSpinBox* m_cap;
};

/// Adds the panel to the column and returns it.
HistoryPanel* addHistoryPanel(SideColumn* column, Settings* settings);
} // namespace ui
