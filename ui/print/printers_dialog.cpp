#include "ui/print/printers_dialog.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/spacing.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr int margin = 2 * gap;
constexpr QSize dialogSize(560, 400);
} // namespace

PrintersDialog::PrintersDialog(const QList<PrinterPreset>& printers, QWidget* parent)
    : QDialog(parent)
    , m_table(new QTableWidget(0, 4))
{
    setObjectName(QStringLiteral("printersDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Printers"));
    named(m_table, "printers", {}, tr("Printers"));
    m_table->setHorizontalHeaderLabels({tr("Name"), tr("Width"), tr("Depth"), tr("Height")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeading | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (const PrinterPreset& printer : printers)
        addRow(printer);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* add = new QPushButton(tr("&Add"));
    auto* remove = new QPushButton(tr("&Remove"));
    for (QPushButton* button : {add, remove})
        button->setAutoDefault(false); // Return presses OK
    add->setObjectName(QStringLiteral("addPrinter"));
    remove->setObjectName(QStringLiteral("removePrinter"));
    connect(add, &QPushButton::clicked, this, [this] {
        addRow({tr("Another printer"), {200, 200, 200}});
        m_table->setCurrentCell(m_table->rowCount() - 1, 0);
        m_table->editItem(m_table->currentItem());
    });
    connect(remove, &QPushButton::clicked, this, [this] { m_table->removeRow(m_table->currentRow()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(this->printers()); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(gap);
    column->addWidget(m_table);
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    row->addWidget(add);
    row->addWidget(remove);
    row->addStretch();
    row->addWidget(buttons);
    column->addLayout(row);
    resize(dialogSize);
}

void PrintersDialog::addRow(const PrinterPreset& printer)
{
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    m_table->setItem(row, 0, new QTableWidgetItem(printer.name));
    int column = 1;
    for (const double side : {printer.bed.x, printer.bed.y, printer.bed.z}) {
        auto* box = new NumberField;
        box->setRange(minBed, maxBed);
        box->setDecimals(1);
        box->setSuffix(tr(" mm"));
        box->setValue(side);
        box->setFrame(false);
        box->setAccessibleName(m_table->horizontalHeaderItem(column)->text());
        m_table->setCellWidget(row, column++, box);
    }
}

QList<PrinterPreset> PrintersDialog::printers() const
{
    QList<PrinterPreset> printers;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString name = m_table->item(row, 0)->text().simplified();
        const auto side = [&](int column) {
            return qobject_cast<QDoubleSpinBox*>(m_table->cellWidget(row, column))->value();
        };
        if (!name.isEmpty())
            printers << PrinterPreset{name, {side(1), side(2), side(3)}};
    }
    return printers.isEmpty() ? defaultPrinters() : printers;
}
} // namespace ui
