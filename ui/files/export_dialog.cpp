#include "ui/files/export_dialog.h"

#include "ui/files/slicer.h"
#include "ui/settings/settings.h"
#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/named.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QRadioButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr int textWidth = 380;
constexpr int gameTriangles = 20'000; ///< usual triangle budget of game engines

/// The texts of a choice in the dialog. The choices are in the order of `exportUses`.
struct Preset
{
    const char* title;
    const char* words;
};
constexpr Preset presets[] = {
    {QT_TRANSLATE_NOOP("ui::ExportDialog", "&Print: STL"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "The shape alone, in millimetres, Z up. Every slicer reads it.")},
    {QT_TRANSLATE_NOOP("ui::ExportDialog", "Print with &colour: 3MF"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "Shape and colours, always in millimetres, Z up. Newer slicers read it.")},
    {QT_TRANSLATE_NOOP("ui::ExportDialog", "&Game: GLB"),
     QT_TRANSLATE_NOOP("ui::ExportDialog",
                       "Shape and colours, in metres, Y up. Game engines, web pages and Blender read it.")}};

class ExportDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::ExportDialog)

public:
    ExportDialog(QWidget* parent, const ModelInfo& modelInfo, const ExportSettings& last)
        : QDialog(parent)
        , m_presets(new QButtonGroup(this))
    {
        QVBoxLayout* column = beginDialog(this, "exportChoice", tr("Export for Print or Game"));
        column->addWidget(dialogText(tr("What is the file for?"), textWidth));
        for (std::size_t i = 0; i < exportUses.size(); ++i)
            addPreset(column, presets[i], exportUses[i].key);
        column->addSpacing(dialogGap);
        addBudget(column, modelInfo);
        addUnion(column);
        addSlicerCheck(column);
        column->addSpacing(dialogGap);
        addDialogButtons(this, tr("&Export…"));
        applySettings(last);
        connect(m_presets, &QButtonGroup::idToggled, this, [this](int, bool isChosen) {
            if (isChosen)
                applyDefaults();
        });
    }

    ExportSettings options() const
    {
        return {use(), m_limits->isChecked() ? static_cast<quint64>(m_max->value()) : 0, m_slices->isChecked(),
                m_joins->isChecked()};
    }
    /// Says that parts overlap, and offers to unite them.
    void offerUnion()
    {
        m_joins->show();
        m_overlap->show();
        adjustSize();
    }
    bool wantsSlicerCheck() const { return m_slices->isChecked() && prints() && !installedSlicer().isEmpty(); }

private:
    ExportUse use() const { return exportUses[static_cast<std::size_t>(m_presets->checkedId())].value; }
    bool prints() const { return use() != ExportUse::Game; }

    void addPreset(QVBoxLayout* column, const Preset& preset, const char* ending)
    {
        auto* button = named(new QRadioButton(tr(preset.title)), ending, tr(preset.words));
        button->setAccessibleDescription(tr(preset.words));
        m_presets->addButton(button, static_cast<int>(m_presets->buttons().size()));
        QLabel* words = dialogText(tr(preset.words), textWidth);
        words->setIndent(3 * dialogGap);
        auto* both = new QVBoxLayout;
        both->setSpacing(0);
        both->addWidget(button);
        both->addWidget(words);
        column->addLayout(both);
    }

    void addBudget(QVBoxLayout* column, const ModelInfo& modelInfo)
    {
        m_limits = named(
            new QCheckBox(tr("&Limit triangles to:")), "limits",
            tr("Removes triangles where shape and colours change least. The model in the window stays as it is."));
        m_max = named(new QSpinBox, "most",
                      tr("Maximum number of triangles in the file. A notice appears if the model's holes and parts "
                         "require more."),
                      tr("Most triangles"));
        m_max->setRange(minExportTriangles, maxExportTriangles);
        m_max->setGroupSeparatorShown(true);
        m_max->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        auto* row = new QHBoxLayout;
        row->setSpacing(dialogGap);
        row->addWidget(m_limits);
        row->addWidget(m_max, 1);
        column->addLayout(row);
        column->addWidget(dialogText(tr("The model has %1 triangles. The file is verified after saving.")
                                         .arg(QLocale().toString(modelInfo.faces)),
                                     textWidth));
        connect(m_limits, &QCheckBox::toggled, m_max, &QWidget::setEnabled);
    }

    /// Adds the check box for uniting parts; it is visible only if parts overlap.
    void addUnion(QVBoxLayout* column)
    {
        m_joins = named(new QCheckBox(tr("&Unite overlapping parts")), "joins",
                        tr("Writes the exact union of the visible parts. The model in the window keeps its parts."));
        m_overlap = named(dialogText(tr("Parts of the model overlap. Slicers expect surfaces that do not intersect; "
                                        "GLB files keep parts."),
                                     textWidth),
                          "overlap");
        m_overlap->setIndent(3 * dialogGap);
        for (QWidget* widget : {static_cast<QWidget*>(m_joins), static_cast<QWidget*>(m_overlap)}) {
            column->addWidget(widget);
            widget->hide();
        }
    }

    /// Adds the check box for slicing; it is visible only if a slicer is installed.
    void addSlicerCheck(QVBoxLayout* column)
    {
        m_slices = named(new QCheckBox(tr("&Test in PrusaSlicer")), "slices",
                         tr("Slices the file with PrusaSlicer's own settings and reports layers and time, or its "
                            "error. Esc stops it."));
        column->addWidget(m_slices);
        m_slices->setVisible(!installedSlicer().isEmpty());
    }

    void applySettings(const ExportSettings& last)
    {
        const auto row = std::ranges::find(exportUses, last.use, &Named<ExportUse>::value) - exportUses.begin();
        m_presets->button(static_cast<int>(row))->setChecked(true);
        m_presets->button(static_cast<int>(row))->setFocus();
        setTriangles(last.maxTriangles);
        m_slices->setChecked(last.slices);
        m_joins->setChecked(last.joinsParts);
        enablePrintChoices();
    }

    void applyDefaults()
    {
        setTriangles(prints() ? 0 : gameTriangles);
        enablePrintChoices();
    }

    void enablePrintChoices()
    {
        m_slices->setEnabled(prints());
        m_joins->setEnabled(prints());
    }

    /// Sets the limit of triangles; 0: no limit.
    void setTriangles(quint64 max)
    {
        m_limits->setChecked(max > 0);
        m_max->setEnabled(max > 0);
        m_max->setValue(max > 0 ? static_cast<int>(max) : gameTriangles);
    }

    QButtonGroup* m_presets;
    QCheckBox* m_limits = nullptr;
    QSpinBox* m_max = nullptr;
    QCheckBox *m_joins = nullptr, *m_slices = nullptr;
    QLabel* m_overlap = nullptr;
};
} // namespace

void askForExportChoice(QWidget* parent, const ExportContext& context,
                        const std::function<void(const ExportSettings&)>& callback)
{
    Settings* const settings = context.settings;
    auto* dialog = new ExportDialog(parent, context.modelInfo, settings->get<ExportSettings>());
    context.askOverlap([shown = QPointer<ExportDialog>(dialog)](bool doOverlap) {
        if (shown && doOverlap)
            shown->offerUnion();
    });
    QObject::connect(dialog, &QDialog::accepted, dialog, [dialog, settings, callback] {
        ExportSettings options = dialog->options();
        settings->set(options);
        options.slices = dialog->wantsSlicerCheck();
        callback(options);
    });
    dialog->open();
}
} // namespace ui
