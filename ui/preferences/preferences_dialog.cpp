#include "ui/preferences/preferences_dialog.h"

#include "ui/preferences/pressure_curve.h"
#include "ui/preferences/pressure_test.h"
#include "ui/preferences/shortcuts_page.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>

namespace ui
{
namespace
{
constexpr QSize defaultSize{560, 520};

QFormLayout* formIn(QWidget* page)
{
    auto* form = new QFormLayout(page);
    form->setContentsMargins(2 * gap, 2 * gap, 2 * gap, 2 * gap);
    form->setSpacing(gap);
    return form;
}

QLabel* remark(const QString& sentence)
{
    auto* label = new QLabel(sentence);
    label->setWordWrap(true);
    return label;
}
} // namespace

PreferencesDialog::PreferencesDialog(const Preferences& now, const Actions& actions, QWidget* parent)
    : QDialog(parent)
    , m_now(now)
{
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* pages = new QTabWidget;
    pages->setDocumentMode(true);
    pages->setObjectName(QStringLiteral("pages"));
    pages->addTab(appearancePage(), tr("&Appearance"));
    pages->addTab(inputPage(), tr("&Input"));
    pages->addTab(keysPage(actions), tr("&Keys"));
    pages->addTab(filesPage(), tr("&Files"));

    QVBoxLayout* column = panelLayout(this);
    column->addWidget(pages);
    column->addWidget(buttonRow());
    resize(minimumSizeHint().expandedTo(defaultSize));
    setPreferences(now);
}

QWidget* PreferencesDialog::buttonRow()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* reset = buttons->addButton(tr("&Reset to Defaults"), QDialogButtonBox::ResetRole);
    named(reset, "reset", tr("Resets all settings of the program to their defaults, after a question."));
    reset->setAutoDefault(false);
    connect(reset, &QPushButton::clicked, this, &PreferencesDialog::askToReset);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void PreferencesDialog::askToReset()
{
    auto* question = new QMessageBox(QMessageBox::Question, windowTitle(), tr("Reset all settings to defaults?"),
                                     QMessageBox::Cancel, this);
    question->setObjectName(QStringLiteral("resetQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(
        tr("This resets colours, language, keys, pen and mouse, brush, view and the layout of panels. Models, recent "
           "files and swatches stay. The language changes at the next start."));
    QPushButton* reset = question->addButton(tr("&Reset"), QMessageBox::AcceptRole);
    connect(reset, &QPushButton::clicked, this, &PreferencesDialog::resetRequested);
    question->open();
}

QWidget* PreferencesDialog::appearancePage()
{
    auto* page = new QWidget;
    QFormLayout* form = formIn(page);
    addChoice(form, {"theme", tr("&Colours"), tr("Chooses a light or a dark window, or follows the desktop.")},
              themeChoices, &Preferences::theme);
    addChoice(form, {"language", tr("&Language"), tr("Chooses the language of the window's texts.")}, languages,
              &Preferences::language);
    addChoice(form, {"textSize", tr("&Text size"), tr("Makes the window's text larger than the desktop's.")}, textSizes,
              &Preferences::textSize);
    form->addRow(remark(tr("Restart Fettle to apply language and text size.")));
    addCheck(form,
             {"calm", tr("Reduced moti&on"),
              tr("The view jumps to its place instead of flying there, and the ring around a place that is pointed at "
                 "stands still.")},
             [](Preferences& all) { return &all.reducesMotion; });
    return page;
}

QWidget* PreferencesDialog::inputPage()
{
    auto* page = new QWidget;
    QFormLayout* form = formIn(page);
    addCheck(form,
             {"pressureToStrength", tr("Pen pressure controls &strength"),
              tr("A light touch changes little, a firm touch much.")},
             [](Preferences& all) { return &all.input.pressureToStrength; });
    addCheck(form,
             {"pressureToRadius", tr("Pen pressure controls ra&dius"),
              tr("A light touch makes a narrow stroke, a firm touch a wide one.")},
             [](Preferences& all) { return &all.input.pressureToRadius; });
    addCheck(form,
             {"altMovesView", tr("Alt and &mouse navigate"),
              tr("Hold Alt: left orbits, middle pans and right zooms, on the model too. The keys of ZBrush differ.")},
             [](Preferences& all) { return &all.input.altMovesView; });
    addPen(form);
    return page;
}

QWidget* PreferencesDialog::filesPage()
{
    static_assert(backupCount == 3, "the words below");
    auto* page = new QWidget;
    QFormLayout* form = formIn(page);
    addCheck(form,
             {"keepsVersions", tr("Keep the last three &versions of each saved file"),
              tr("Older versions stay beside the file, as vase.glb~1, vase.glb~2 and so on. Open them like any other "
                 "file.")},
             [](Preferences& all) { return &all.keepsBackups; });
    addCheck(
        form,
        {"objectsAsParts", tr("Open the &objects of a file as parts"),
         tr("Makes a part of each object of a 3MF, OBJ, glTF or AMF file. Otherwise all objects become one part.")},
        [](Preferences& all) { return &all.opensObjectsAsParts; });
    form->addRow(remark(
        tr("Unsaved changes are always kept if Fettle ends unexpectedly. The next start offers to recover them.")));
    return page;
}

QWidget* PreferencesDialog::keysPage(const Actions& actions)
{
    auto* page = new ShortcutsPage(actions);
    connect(page, &ShortcutsPage::changed, this, [this](const ShortcutSettings& keys) {
        Preferences to = m_now;
        to.keys = keys;
        change(to);
    });
    m_show.push_back([this, page] { page->setShortcuts(m_now.keys); });
    return page;
}

/// Adds the pressure curve and a field in which to try it.
void PreferencesDialog::addPen(QFormLayout* form)
{
    auto* curve = new PressureCurve;
    auto* test = new PressureTest;
    connect(curve, &PressureCurve::bent, this, [this](double exponent) {
        Preferences to = m_now;
        to.input.penExponent = exponent;
        change(to);
    });
    m_show.push_back([this, curve, test] {
        curve->setExponent(m_now.input.penExponent);
        test->setExponent(m_now.input.penExponent);
    });
    form->addRow(tr("Pressure &curve"), curve);
    form->addRow(tr("Pen test"), test);
}

/// Adds a check box. `part`: returns a pointer to the preference that the box changes.
template <class Part> void PreferencesDialog::addCheck(QFormLayout* form, const ControlText& words, Part part)
{
    auto* box = named(new QCheckBox(words.label), words.name, words.tip, QString(words.label).remove(QLatin1Char('&')));
    connect(box, &QCheckBox::clicked, this, [this, part](bool checked) {
        Preferences to = m_now;
        *part(to) = checked;
        change(to);
    });
    m_show.push_back([this, box, part] { box->setChecked(*part(m_now)); });
    form->addRow(box);
}

template <class T, std::size_t count>
void PreferencesDialog::addChoice(QFormLayout* form, const ControlText& words,
                                  const std::array<Named<T>, count>& choices, T Preferences::*what)
{
    auto* box = named(new QComboBox, words.name, words.tip, QString(words.label).remove(QLatin1Char('&')));
    for (const Named<T>& choice : choices)
        box->addItem(PreferencesDialog::words(choice.value), static_cast<int>(choice.value));
    connect(box, &QComboBox::activated, this, [this, box, what] {
        Preferences to = m_now;
        to.*what = static_cast<T>(box->currentData().toInt());
        change(to);
    });
    m_show.push_back([this, box, what] { box->setCurrentIndex(box->findData(static_cast<int>(m_now.*what))); });
    form->addRow(words.label, box);
}

QString PreferencesDialog::words(ThemeChoice theme)
{
    const QString names[] = {tr("Same as the system"), tr("Light"), tr("Dark")};
    static_assert(std::size(names) == static_cast<std::size_t>(ThemeChoice::Dark) + 1);
    return names[static_cast<std::size_t>(theme)];
}

QString PreferencesDialog::words(TextSize size)
{
    return tr("%1 %").arg(static_cast<int>(size));
}

/// Returns a language's name in that language, so that its speakers recognise it.
QString PreferencesDialog::words(Language language)
{
    const QString names[] = {tr("Same as the system"), QStringLiteral("English"), QStringLiteral("Deutsch"),
                             QStringLiteral("简体中文")};
    static_assert(std::size(names) == static_cast<std::size_t>(Language::Chinese) + 1);
    return names[static_cast<std::size_t>(language)];
}

void PreferencesDialog::setPreferences(const Preferences& preferences)
{
    m_now = preferences;
    for (const auto& show : m_show)
        show();
}

void PreferencesDialog::change(const Preferences& to)
{
    const bool isNew = m_now != to;
    setPreferences(to);
    if (isNew)
        Q_EMIT changed(m_now);
}
} // namespace ui
