#pragma once

#include "ui/print/print_findings.h"
#include "ui/print/print_legend.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QProgressBar;
class QToolButton;

namespace ui
{
class Actions;
class Settings;
class SideColumn;
class Viewport;

/// Will it print? Shows what the last check of the model found, and by which limits. Knows no mesh: it requests a check
/// and shows the result that it is given. Thread: gui.
class PrintPanel : public QWidget
{
    Q_OBJECT

public:
    /// The settings must outlive the panel.
    explicit PrintPanel(Settings* settings, QWidget* parent = nullptr);

    core::PrintLimits limits() const;
    std::optional<core::PrintPicture> picture() const; ///< to be shown on the model
    void focusFindings();

    void setReport(const core::MeshReport& mesh, const core::PrintReport& print);
    /// The model is another one now; what is shown is of before, and is said to be.
    void setStale();
    /// It is being looked at: 0 to 1.
    void setProgress(double share);

Q_SIGNALS:
    /// It can be seen now, or not any more.
    void watched(bool isWatched);
    void optionsChanged();
    /// Now, though it was stopped before.
    void checkRequested();
    void stopRequested();
    void placeChosen(const core::PrintPlace& place);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class State { Stale, Running, Answered };

    void addHead();
    void addOptions();
    void addList();
    void applyOptions();
    void applySettings();
    void show(State state);
    void showColors();
    void addRow(const PrintFinding& finding);
    void choose(int row);

    Settings* m_settings;
    QFormLayout* m_form = nullptr;
    QLabel *m_icon = nullptr, *m_word = nullptr;
    QToolButton* m_button = nullptr; ///< Check, or Stop
    QProgressBar* m_progress = nullptr;
    QComboBox *m_printer = nullptr, *m_picture = nullptr;
    QDoubleSpinBox *m_wall = nullptr, *m_overhang = nullptr;
    PrintLegend* m_legend = nullptr;
    QListWidget* m_list = nullptr;
    State m_state = State::Stale;
    QList<PrinterPreset> m_printers;
    QList<PrintFinding> m_findings;
    bool m_isFilling = false;
};

struct PrintPanelContext
{
    SideColumn* column;
    Viewport* viewport;
};

/// Adds the panel to the column; model.printCheck opens it. A place that is chosen
/// is flown to.
void addPrintPanel(const PrintPanelContext& context, Settings* settings, const Actions& actions);
} // namespace ui
