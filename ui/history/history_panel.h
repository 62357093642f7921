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
    QString icon;     ///< file in :/icons without ending
    quint64 dabs = 0; ///< 0: it was no stroke
    quint64 fusions = 0;
};

/// What the panel shows. State 0 is the model as it was opened, state i the one after step i - 1.
struct History
{
    QList<HistoryStep> steps;
    int present = 0;         ///< state
    int first = 0, last = 0; ///< states that can be reached; what lies beyond has expired
    qint64 bytes = 0;        ///< in memory
};

/// The steps that were done, a click or Return goes to any that is still kept, a timeline through them, and how much
/// memory they may take. Knows no document: it shows what it is given, and asks. Thread: gui.
class HistoryPanel : public QWidget
{
    Q_OBJECT

public:
    explicit HistoryPanel(Settings* settings, QWidget* parent = nullptr);
    ~HistoryPanel() override;

    /// Cost: the rows in sight.
    void setHistory(History history);
    qint64 cap() const; ///< bytes

Q_SIGNALS:
    void jumpRequested(int state);
    /// By the timeline; many in a row, of which only the newest counts.
    void stateRequested(int state);
    void capChanged(qint64 bytes);
    /// It can be seen, and may show what is old.
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

/// Adds the panel to the column.
HistoryPanel* addHistoryPanel(SideColumn* column, Settings* settings);
} // namespace ui
