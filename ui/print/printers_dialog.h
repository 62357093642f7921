#pragma once

#include "ui/settings/printer_presets.h"

#include <QDialog>

class QTableWidget;

namespace ui
{
/// The list of printers: names and beds to be changed, rows to be added and taken out. Deletes itself when it closes.
class PrintersDialog : public QDialog
{
    Q_OBJECT

public:
    PrintersDialog(const QList<PrinterPreset>& printers, QWidget* parent);

Q_SIGNALS:
    /// Agreed to. Never empty: without any row it is the usual ones.
    void chosen(const QList<ui::PrinterPreset>& printers);

private:
    void addRow(const PrinterPreset& printer);
    QList<PrinterPreset> printers() const;

    QTableWidget* m_table;
};
} // namespace ui
