#pragma once

#include "ui/settings/printer_presets.h"

#include <QDialog>

class QTableWidget;

namespace ui
{
/// A dialog that edits the list of printers with their names and bed sizes. It deletes itself when it closes.
class PrintersDialog : public QDialog
{
    Q_OBJECT

public:
    PrintersDialog(const QList<PrinterPreset>& printers, QWidget* parent);

Q_SIGNALS:
    /// The user has accepted the list. An empty table is replaced by the default printers, so the list is never empty.
    void chosen(const QList<ui::PrinterPreset>& printers);

private:
    void addRow(const PrinterPreset& printer);
    QList<PrinterPreset> printers() const;

    QTableWidget* m_table;
};
} // namespace ui
