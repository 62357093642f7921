#include "export_dialog.h"

#include "slicer.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr int margin = 16, gap = 8; ///< of the window's spacing grid
constexpr int textWidth = 380;
constexpr int leastTriangles = 4, mostTriangles = 100'000'000;

/// A row of the dialog. The number of triangles is what such programs usually take; 0: as many as there are.
struct Preset
{
    const char* ending;
    int triangles;
    bool prints;
    const char* title;
    const char* words;
};
constexpr Preset presets[] = {
    {"stl", 0, true, QT_TRANSLATE_NOOP("ui::ExportDialog", "&Print: STL"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "The shape alone, in millimetres, Z up. Every slicer reads it.")},
    {"3mf", 0, true, QT_TRANSLATE_NOOP("ui::ExportDialog", "Print with &colour: 3MF"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "Shape and colours, in millimetres for certain, Z up. Newer slicers read it.")},
    {"glb", 20'000, false, QT_TRANSLATE_NOOP("ui::ExportDialog", "&Game: GLB"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "Shape and colours, in metres, Y up. Game engines, web pages and Blender read it.")}};

class ExportDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::ExportDialog)

public:
    ExportDialog(QWidget* parent, const ModelFacts& facts) : QDialog(parent), m_presets(new QButtonGroup(this))
    {
        setObjectName(QStringLiteral("exportChoice"));
        setAttribute(Qt::WA_DeleteOnClose);
        setWindowTitle(tr("Export for Print or Game"));
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(margin, margin, margin, margin);
        column->setSpacing(gap);
        column->addWidget(text(tr("What is the file for?")));
        for (const Preset& preset : presets)
            addPreset(column, preset);
        column->addSpacing(gap);
        addBudget(column, facts);
        addTrial(column);
        column->addSpacing(gap);
        addButtons(column);
        column->setSizeConstraint(QLayout::SetFixedSize);
        connect(m_presets, &QButtonGroup::idToggled, this, [this](int id, bool isChosen) {
            if (isChosen)
                choose(presets[id]);
        });
        m_presets->button(0)->setChecked(true);
        m_presets->button(0)->setFocus();
    }

    ExportChoice choice() const
    {
        return {QLatin1StringView(presets[m_presets->checkedId()].ending), m_limits->isChecked() ? static_cast<quint64>(m_most->value()) : 0,
                m_slices->isEnabled() && m_slices->isChecked()};
    }

private:
    static QLabel* text(const QString& sentence)
    {
        auto* label = new QLabel(sentence);
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setFixedWidth(textWidth);
        return label;
    }

    void addPreset(QVBoxLayout* column, const Preset& preset)
    {
        auto* button = new QRadioButton(tr(preset.title));
        button->setObjectName(QLatin1StringView(preset.ending));
        button->setToolTip(tr(preset.words));
        button->setAccessibleDescription(tr(preset.words));
        m_presets->addButton(button, static_cast<int>(m_presets->buttons().size()));
        column->addWidget(button);
        QLabel* words = text(tr(preset.words));
        words->setIndent(3 * gap);
        column->addWidget(words);
    }

    void addBudget(QVBoxLayout* column, const ModelFacts& facts)
    {
        m_limits = new QCheckBox(tr("At &most so many triangles:"));
        m_limits->setObjectName(QStringLiteral("limits"));
        m_limits->setToolTip(tr("Takes away triangles where the shape and the colours lose least by it. The model in the window keeps its own."));
        m_most = new QSpinBox;
        m_most->setObjectName(QStringLiteral("most"));
        m_most->setAccessibleName(tr("Most triangles"));
        m_most->setToolTip(tr("The file has at most so many triangles."));
        m_most->setRange(leastTriangles, mostTriangles);
        m_most->setGroupSeparatorShown(true);
        m_most->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        m_most->setValue(presets[2].triangles);
        auto* row = new QHBoxLayout;
        row->setSpacing(gap);
        row->addWidget(m_limits);
        row->addWidget(m_most, 1);
        column->addLayout(row);
        column->addWidget(text(tr("The model has %1 triangles. The file is read back and judged when it is written.")
                                   .arg(QLocale().toString(facts.faces))));
        connect(m_limits, &QCheckBox::toggled, m_most, &QWidget::setEnabled);
    }

    /// Seen where there is a slicer.
    void addTrial(QVBoxLayout* column)
    {
        m_slices = new QCheckBox(tr("&Try whether PrusaSlicer slices it"));
        m_slices->setObjectName(QStringLiteral("slices"));
        m_slices->setToolTip(tr("Slices the file with PrusaSlicer's own settings, and tells layers and time or its complaint; Esc stops it."));
        column->addWidget(m_slices);
        m_slices->setVisible(!installedSlicer().isEmpty());
    }

    void addButtons(QVBoxLayout* column)
    {
        auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
        auto* agree = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
        column->addWidget(buttons);
        agree->setDefault(true);
        connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
        connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    }

    void choose(const Preset& preset)
    {
        m_slices->setEnabled(preset.prints);
        m_limits->setChecked(preset.triangles > 0);
        m_most->setEnabled(preset.triangles > 0);
        if (preset.triangles > 0)
            m_most->setValue(preset.triangles);
    }

    QButtonGroup* m_presets;
    QCheckBox* m_limits = nullptr;
    QSpinBox* m_most = nullptr;
    QCheckBox* m_slices = nullptr;
};
} // namespace

void askForExportChoice(QWidget* parent, const ModelFacts& facts, const std::function<void(const ExportChoice&)>& answer)
{
    auto* dialog = new ExportDialog(parent, facts);
    QObject::connect(dialog, &QDialog::accepted, dialog, [dialog, answer] { answer(dialog->choice()); });
    dialog->open();
}
} // namespace ui
