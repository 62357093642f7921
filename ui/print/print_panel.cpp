#include "ui/print/print_panel.h"

#include "ui/actions/actions.h"
#include "ui/print/printers_dialog.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_button.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ui
{
namespace
{
constexpr int iconSide = 20, rowIconSide = 16;
constexpr double minWall = 0.05, minOverhang = 0, maxOverhang = 90;
/// Item data: index of the row's finding; index of the row's place in that finding, or -1 for the row of the finding.
constexpr int findingRole = Qt::UserRole, placeRole = Qt::UserRole + 1;

QString iconOf(PrintVerdict verdict)
{
    static const QString icons[] = {QStringLiteral("sound"), QStringLiteral("about"), QStringLiteral("unsound")};
    return icons[static_cast<int>(verdict)];
}

QDoubleSpinBox* numberBox(const char* name, double min, double max, int decimals, const QString& unit)
{
    auto* box = named(new NumberField, name);
    box->setRange(min, max);
    box->setDecimals(decimals);
    box->setSingleStep(decimals > 0 ? 0.1 : 5);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);
    return box;
}
} // namespace

PrintPanel::PrintPanel(Settings* settings, QWidget* parent) : QWidget(parent), m_settings(settings)
{
    panelLayout(this);
    addHead();
    addOptions();
    addList();
    applySettings();
    show(State::Stale);
    settings->onReset([this] { applySettings(); });
}

void PrintPanel::addHead()
{
    m_icon = new QLabel;
    m_word = named(new QLabel, "print.verdict");
    m_word->setWordWrap(true);
    m_button = panelButton(QStringLiteral("print.check"), QStringLiteral("print-check"), {}, {});
    connect(m_button, &QToolButton::clicked, this, [this] {
        if (m_state == State::Running)
            Q_EMIT stopRequested();
        else
            Q_EMIT checkRequested();
    });
    m_progress = named(new QProgressBar, "print.progress");
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(gap / 2);
    auto* head = new QHBoxLayout;
    head->setSpacing(gap);
    head->addWidget(m_icon);
    head->addWidget(m_word, 1);
    head->addWidget(m_button);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addLayout(head);
    column->addWidget(m_progress);
}

void PrintPanel::addOptions()
{
    m_form = new QFormLayout;
    m_form->setSpacing(gap);
    m_printer = named(new QComboBox, "print.printer");
    m_printer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_printer->setMinimumContentsLength(12);
    auto* edit = panelButton(QStringLiteral("print.printers"), QStringLiteral("preferences"), tr("Printers…"),
                             tr("Edits the list of printers."));
    connect(edit, &QToolButton::clicked, this, [this] {
        auto* dialog = new PrintersDialog(m_printers, window());
        connect(dialog, &PrintersDialog::chosen, this, [this](const QList<PrinterPreset>& printers) {
            m_settings->set(&Setting::printers, printers);
            applySettings();
        });
        dialog->open();
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(gap / 2);
    row->addWidget(m_printer, 1);
    row->addWidget(edit);
    m_wall = numberBox("print.wall", minWall, core::PrintLimits::maxWall, 2, tr(" mm"));
    m_overhang = numberBox("print.overhang", minOverhang, maxOverhang, 0, tr("°"));
    m_picture = named(new QComboBox, "print.picture");
    m_picture->addItems({tr("None"), tr("Thickness"), tr("Overhang")});
    m_legend = named(new PrintLegend, "print.legend");
    const auto add = [this](const QString& name, auto* what, QWidget* control, const QString& tip) {
        m_form->addRow(name, what);
        control->setAccessibleName(name);
        control->setToolTip(QStringLiteral("%1\n%2").arg(name, tip));
    };
    add(tr("Printer"), row, m_printer, tr("The printer to check against."));
    add(tr("Minimum wall"), m_wall, m_wall, tr("Finds thinner walls. Two lines of the nozzle are usual."));
    add(tr("Overhang"), m_overhang, m_overhang,
        tr("Steepest overhang that prints without support, from the vertical."));
    add(tr("Colours"), m_picture, m_picture, tr("Colours the model by wall thickness or by overhang."));
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addLayout(m_form);
    column->addWidget(m_legend);
    for (QDoubleSpinBox* box : {m_wall, m_overhang})
        connect(box, &QDoubleSpinBox::valueChanged, this, &PrintPanel::applyOptions);
    for (QComboBox* box : {m_printer, m_picture})
        connect(box, &QComboBox::currentIndexChanged, this, &PrintPanel::applyOptions);
}

void PrintPanel::addList()
{
    m_list = named(new QListWidget, "print.findings",
                   tr("The findings. Click a place, or press Return, to see it on the model."), tr("Findings"));
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setIconSize({rowIconSide, rowIconSide});
    m_list->setMinimumHeight(96);
    connect(m_list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { choose(m_list->row(item)); });
    connect(m_list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { choose(m_list->row(item)); });
    layout()->addWidget(m_list);
}

/// Sets the controls to the stored settings.
void PrintPanel::applySettings()
{
    m_isFilling = true;
    const PrintSettings choice = m_settings->get<PrintSettings>();
    m_printers = m_settings->get(&Setting::printers);
    m_printer->clear();
    for (const PrinterPreset& printer : m_printers)
        m_printer->addItem(printer.name);
    const auto chosen = std::ranges::find(m_printers, choice.printer, &PrinterPreset::name);
    m_printer->setCurrentIndex(chosen != m_printers.end() ? static_cast<int>(chosen - m_printers.begin()) : 0);
    m_wall->setValue(choice.wall);
    m_overhang->setValue(choice.overhang);
    m_picture->setCurrentIndex(choice.picture);
    m_isFilling = false;
    applyOptions();
}

void PrintPanel::applyOptions()
{
    if (m_isFilling)
        return;
    m_settings->set(
        PrintSettings{m_printer->currentText(), m_wall->value(), m_overhang->value(), m_picture->currentIndex()});
    m_legend->setVisible(picture().has_value());
    if (const auto shown = picture())
        m_legend->setScale({*shown, *shown == core::PrintPicture::Thickness ? m_wall->value() : m_overhang->value()});
    Q_EMIT optionsChanged();
}

core::PrintLimits PrintPanel::limits() const
{
    core::PrintLimits limits;
    limits.minWall = m_wall->value();
    limits.overhang = m_overhang->value();
    limits.bed = m_printers[std::max(0, m_printer->currentIndex())].bed;
    return limits;
}

std::optional<core::PrintPicture> PrintPanel::picture() const
{
    const int chosen = m_picture->currentIndex();
    return chosen > 0 ? std::optional(static_cast<core::PrintPicture>(chosen - 1)) : std::nullopt;
}

void PrintPanel::focusFindings()
{
    m_list->setFocus();
}

void PrintPanel::setReport(const core::MeshReport& mesh, const core::PrintReport& print, PrintedParts parts)
{
    m_findings = printFindings(mesh, print, limits(), m_printer->currentText(), parts);
    std::ranges::stable_sort(m_findings, std::greater(), &PrintFinding::verdict); // the worst findings come first
    const int row = m_list->currentRow();
    m_list->clear();
    for (const PrintFinding& finding : m_findings)
        addRow(finding);
    m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    show(State::Answered);
}

void PrintPanel::setStale()
{
    show(State::Stale);
}

void PrintPanel::setProgress(double share)
{
    m_progress->setValue(static_cast<int>(std::lround(100 * share)));
    if (m_state != State::Running)
        show(State::Running);
}

/// Adds a row for a finding and an indented row for each of its places.
void PrintPanel::addRow(const PrintFinding& finding)
{
    static const char* const verdicts[] = {QT_TR_NOOP("good"), QT_TR_NOOP("warning"), QT_TR_NOOP("to fix")};
    const int number = static_cast<int>(&finding - m_findings.constData());
    const auto add = [&](const QString& text, int place) {
        auto* item = new QListWidgetItem(text, m_list);
        item->setToolTip(finding.tip);
        item->setData(findingRole, number);
        item->setData(placeRole, place);
        return item;
    };
    QListWidgetItem* row = add(finding.text, -1);
    row->setIcon(themedIcon(iconOf(finding.verdict)));
    row->setData(Qt::AccessibleTextRole,
                 QStringLiteral("%1: %2").arg(tr(verdicts[static_cast<int>(finding.verdict)]), finding.text));
    QPixmap nothing(rowIconSide, rowIconSide); // transparent icon that aligns places with the finding's text
    nothing.fill(Qt::transparent);
    for (qsizetype i = 0; i < finding.placeTexts.size(); ++i) {
        QListWidgetItem* place = add(QStringLiteral("  ") + finding.placeTexts[i], static_cast<int>(i));
        place->setIcon(nothing);
        place->setData(Qt::AccessibleTextRole, finding.placeTexts[i]);
    }
}

/// Emits placeChosen() for the row's place; the row of the finding means its first place. If the model is coloured,
/// switches to the colouring that shows the place.
void PrintPanel::choose(int row)
{
    const QListWidgetItem* item = m_list->item(row);
    const PrintFinding& finding = m_findings[item->data(findingRole).toInt()];
    if (m_state != State::Answered || finding.places.empty())
        return;
    if (picture() && finding.picture)
        m_picture->setCurrentIndex(static_cast<int>(*finding.picture) + 1);
    Q_EMIT placeChosen(finding.places[static_cast<std::size_t>(std::max(0, item->data(placeRole).toInt()))]);
}

void PrintPanel::show(State state)
{
    m_state = state;
    const bool isRunning = state == State::Running;
    const QString what = isRunning ? tr("Stop") : tr("Check Now");
    m_button->setIcon(themedIcon(isRunning ? QStringLiteral("stop") : QStringLiteral("print-check")));
    m_button->setAccessibleName(what);
    m_button->setToolTip(
        QStringLiteral("%1\n%2").arg(what, isRunning ? tr("Ends the check.") : tr("Checks the model as it is now.")));
    m_button->setEnabled(state != State::Answered);
    m_progress->setVisible(isRunning);
    m_list->setEnabled(state == State::Answered);
    showColors();
}

/// Shows the result by icon and text; the icon is that of the worst finding.
void PrintPanel::showColors()
{
    PrintVerdict worst = PrintVerdict::Good;
    for (const PrintFinding& finding : std::as_const(m_findings))
        worst = std::max(worst, finding.verdict);
    const QString words[] = {tr("Ready to print"), tr("Printable, with warnings"), tr("Fix before printing")};
    const bool isKnown = m_state == State::Answered;
    m_word->setText(isKnown                     ? words[static_cast<int>(worst)]
                    : m_state == State::Running ? tr("Checking…")
                                                : tr("Not checked since the last change"));
    m_icon->setPixmap(themedIcon(isKnown ? iconOf(worst) : QStringLiteral("wait"))
                          .pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
}

void PrintPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showColors();
}

void PrintPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    Q_EMIT watched(true);
}

void PrintPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    Q_EMIT watched(false);
}

void addPrintPanel(const PrintPanelContext& context, Settings* settings, const Actions& actions)
{
    auto* panel = new PrintPanel(settings);
    SidePanel* section = context.column->add(QStringLiteral("printPanel"), PrintPanel::tr("Print Check"), panel);
    Viewport* viewport = context.viewport;
    QObject::connect(panel, &PrintPanel::placeChosen, viewport, [viewport](const core::PrintPlace& found) {
        viewport->navigation()->flyTo(found.point, found.normal, std::sqrt(found.area));
    });
    QObject::connect(panel, &PrintPanel::watched, viewport, [viewport](bool isWatched) {
        if (!isWatched)
            viewport->navigation()->clearMark();
    });
    const QAction* check = actions.get(QStringLiteral("model.printCheck"));
    section->openBy(check);
    QObject::connect(check, &QAction::triggered, panel, &PrintPanel::focusFindings);
}
} // namespace ui
