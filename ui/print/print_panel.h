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

/// A panel that reports whether the model will print: the findings of the last check and the limits used. Knows no
/// mesh: it requests a check, and setReport() provides the result. Thread: gui.
class PrintPanel : public QWidget
{
    Q_OBJECT

public:
    /// Precondition: the settings outlive the panel.
    explicit PrintPanel(Settings* settings, QWidget* parent = nullptr);

    core::PrintLimits limits() const;
    std::optional<core::PrintPicture> picture() const; ///< colouring to show on the model; nullopt: none
    void focusFindings();

    void setReport(const core::MeshReport& mesh, const core::PrintReport& print,
                   PrintedParts parts = PrintedParts::Apart);
    /// Marks the findings as outdated, because the model has changed.
    void setStale();
    /// Shows that the check is running. `share`: 0 to 1.
    void setProgress(double share);

Q_SIGNALS:
    /// The panel has become visible or hidden.
    void watched(bool isWatched);
    void optionsChanged();
    /// The user requests a check now, even if the previous one was stopped.
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
    QToolButton* m_button = nullptr; ///< Check or Stop, depending on the state
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

/// Adds the panel to the column; the action model.printCheck opens it. Choosing a place flies the camera there.
void addPrintPanel(const PrintPanelContext& context, Settings* settings, const Actions& actions);
} // namespace ui
