#include "ui/classroom/classroom_dialog.h"

#include "ui/actions/actions.h"
#include "ui/classroom/lesson_choice.h"
#include "ui/classroom/names_field.h"
#include "ui/classroom/waiting_works_note.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/settings/stored_values.h"
#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int textWidth = 460, columns = 4;

QString starterId(core::Starter starter)
{
    return QStringLiteral("new.") + QString::fromUtf8(core::name(starter));
}

QCheckBox* boxOf(const QWidget* dialog, const QString& id)
{
    return dialog->findChild<QCheckBox*>(QStringLiteral("class.") + id);
}

QString toolId(std::string_view tool)
{
    return QStringLiteral("tool.") + QString::fromUtf8(tool);
}

/// Returns a row with two fields and the label of the second. The label of the form row belongs to the first field.
QWidget* beside(QWidget* first, const QString& label, QWidget* second)
{
    auto* both = new QWidget;
    both->setFocusProxy(first);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(dialogGap);
    row->addWidget(first, 1);
    if (!label.isEmpty()) {
        auto* words = new QLabel(label);
        words->setBuddy(second);
        row->addWidget(words);
    }
    row->addWidget(second, label.isEmpty() ? 0 : 1);
    return both;
}
} // namespace

ClassroomDialog::ClassroomDialog(QWidget* parent, const Actions& actions, const QString& folder,
                                 const QList<LessonCard>& lessons)
    : QDialog(parent)
    , m_lesson(new LessonChoice(lessons))
    , m_waiting(new WaitingWorksNote(textWidth))
    , m_startFolder(folder)
{
    QVBoxLayout* column = beginDialog(this, "classroomDialog", tr("Classroom"));
    auto* open = named(new QPushButton(tr("&Open a Class…")), "classOpen", tr("Opens a class file to change it."));
    open->setAutoDefault(false);
    connect(open, &QPushButton::clicked, this, [this] {
        askForClass(this, m_path.isEmpty() ? m_startFolder : QFileInfo(m_path).absolutePath(),
                    [this](const QString& path) { Q_EMIT openRequested(path); });
    });
    QVBoxLayout* page = addScrolledPage(column);
    page->addWidget(dialogText(tr("Pupils take turns: each begins with fresh clay, and Next Pupil saves the work in "
                                  "the class folder. Pupils cannot reach other files; leaving asks for your PIN."),
                               textWidth));
    page->addWidget(m_waiting);
    page->addWidget(open, 0, Qt::AlignLeft);
    auto* form = new QFormLayout;
    form->setSpacing(dialogGap);
    addNames(form);
    addPupils(form);
    form->addRow(tr("L&esson:"), m_lesson);
    addTimes(form);
    addPin(form);
    page->addLayout(form);
    page->addWidget(choices(tr("Starting shapes"), actions, MenuId::New));
    page->addWidget(choices(tr("Tools"), actions, MenuId::Tool));
    column->addWidget(foot());
    m_save = addDialogButtons(this, tr("&Save…"));
    m_saveAs = named(new QPushButton(tr("Save &As…")), "classSaveAs", tr("Saves the class to another file."));
    qobject_cast<QDialogButtonBox*>(m_save->parentWidget())->addButton(m_saveAs, QDialogButtonBox::ActionRole);
    m_saveAs->setAutoDefault(false);
    m_saveAs->hide();
    connect(m_saveAs, &QPushButton::clicked, this, &ClassroomDialog::saveAs);
    m_title->setFocus();
}

void ClassroomDialog::load(const Classroom& classroom, const QString& path)
{
    m_path = path;
    m_pinRecord = classroom.pin;
    m_title->setText(classroom.title);
    m_folder->setText(QDir::toNativeSeparators(classroom.folder));
    for (const core::Starter starter : core::starters)
        boxOf(this, starterId(starter))->setChecked(classroom.starters.contains(starter));
    for (const std::string_view name : core::toolNames())
        boxOf(this, toolId(name))->setChecked(classroom.tools.contains(*core::named<core::Tool>(name)));
    m_lesson->setLesson(classroom.lesson);
    m_turn->setValue(classroom.turnMinutes);
    m_warning->setValue(classroom.warningMinutes);
    m_fullScreen->setChecked(classroom.fullScreen);
    m_questions->setChecked(classroom.asksQuestions);
    m_names->setNames(classroom.names);
    m_others->setChecked(classroom.allowsOthers);
    m_language->setCurrentIndex(m_language->findData(static_cast<int>(classroom.language)));
    for (QLineEdit* field : {m_pin, m_pinRepeated}) {
        field->clear();
        field->setPlaceholderText(tr("unchanged"));
    }
    m_save->setText(tr("&Save"));
    m_save->setToolTip(QDir::toNativeSeparators(path));
    m_saveAs->show();
    showFault({});
}

void ClassroomDialog::showFault(const QString& sentence)
{
    m_word->setText(sentence);
    m_makeFolder->hide();
}

void ClassroomDialog::accept()
{
    if (m_path.isEmpty())
        return saveAs();
    if (std::optional<ClassroomDraft> made = checkedDraft()) {
        made->path = m_path;
        Q_EMIT drafted(*made);
    }
}

void ClassroomDialog::saveAs()
{
    const std::optional<ClassroomDraft> made = checkedDraft();
    if (!made)
        return;
    const QString start = m_path.isEmpty() ? m_startFolder : QFileInfo(m_path).absolutePath();
    askForClassFile(this, start, m_path.isEmpty() ? made->classroom.title : QFileInfo(m_path).completeBaseName(),
                    [this, draft = *made](const QString& path) mutable {
                        draft.path = path;
                        Q_EMIT drafted(draft);
                    });
}

/// Returns nullopt if something is missing, shows the reason and focuses the field.
std::optional<ClassroomDraft> ClassroomDialog::checkedDraft()
{
    const ClassroomDraft made = draft();
    const Fault fault = faultIn(made);
    showFault(fault.sentence);
    m_makeFolder->setVisible(fault.field == m_folder && QDir::isAbsolutePath(folder()) && !QFileInfo::exists(folder()));
    if (!fault.field)
        return made;
    fault.field->setFocus();
    return std::nullopt;
}

void ClassroomDialog::makeFolder()
{
    if (!QDir().mkpath(folder()))
        return showFault(tr("This folder cannot be created."));
    showFault({});
    m_folder->setFocus();
}

QString ClassroomDialog::folder() const
{
    return QDir::cleanPath(QDir::fromNativeSeparators(m_folder->text().trimmed()));
}

/// Builds the foot of the dialog: the message about what is missing, and a button that creates a missing folder.
QWidget* ClassroomDialog::foot()
{
    m_word = dialogText({}, textWidth);
    m_word->setObjectName(QStringLiteral("classroomWord"));
    m_makeFolder = named(new QPushButton(tr("&Make This Folder")), "classMakeFolder");
    m_makeFolder->setAutoDefault(false);
    m_makeFolder->hide();
    connect(m_makeFolder, &QPushButton::clicked, this, &ClassroomDialog::makeFolder);
    auto* foot = new QWidget;
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_word, 1);
    row->addWidget(m_makeFolder, 0, Qt::AlignTop);
    return foot;
}

ClassroomDraft ClassroomDialog::draft() const
{
    ClassroomDraft draft;
    Classroom& classroom = draft.classroom;
    classroom.title = m_title->text().simplified();
    classroom.folder = folder();
    for (const core::Starter starter : core::starters)
        if (boxOf(this, starterId(starter))->isChecked())
            classroom.starters << starter;
    for (const std::string_view name : core::toolNames())
        if (boxOf(this, toolId(name))->isChecked())
            classroom.tools << *core::named<core::Tool>(name);
    classroom.lesson = m_lesson->lesson();
    classroom.turnMinutes = m_turn->value();
    classroom.warningMinutes = std::min(m_warning->value(), m_turn->value());
    classroom.fullScreen = m_fullScreen->isChecked();
    classroom.asksQuestions = m_questions->isChecked();
    classroom.names = m_names->names();
    classroom.allowsOthers = m_others->isChecked() || classroom.names.isEmpty();
    classroom.language = static_cast<Language>(m_language->currentData().toInt());
    classroom.pin = m_pinRecord;
    draft.pin = m_pin->text();
    return draft;
}

void ClassroomDialog::addNames(QFormLayout* form)
{
    m_title = named(new QLineEdit, "classTitleField", tr("Shown in the top bar, such as the name of the class."));
    form->addRow(tr("&Title:"), m_title);
    m_folder = named(new QLineEdit, "classFolderField",
                     tr("Each turn gets a folder there, with model, picture and recording."));
    auto* choose = named(new QPushButton(tr("C&hoose…")), "classFolderChoice", m_folder->toolTip());
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, [this] {
        askForFolder(this, m_startFolder,
                     [this](const QString& path) { m_folder->setText(QDir::toNativeSeparators(path)); });
    });
    auto* both = new QWidget;
    both->setFocusProxy(m_folder);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_folder, 1);
    row->addWidget(choose);
    form->addRow(tr("&Folder for pupils' work:"), both);
}

void ClassroomDialog::addPupils(QFormLayout* form)
{
    m_names = new NamesField;
    m_others = named(new QCheckBox(tr("Allow other &names")), "classOthers",
                     tr("For guests, and for names that are not on the list."));
    m_others->setChecked(true);
    form->addRow(tr("&Pupils' names:"), m_names);
    form->addRow({}, m_others);
}

void ClassroomDialog::addTimes(QFormLayout* form)
{
    const Classroom defaults;
    const auto minutes = [this](const char* name, int value, const QString& none, const QString& tip) {
        auto* count = named(new QSpinBox, name, tip);
        count->setRange(0, maxTurnMinutes);
        count->setValue(value);
        count->setSuffix(tr(" min"));
        count->setSpecialValueText(none);
        return count;
    };
    m_turn = minutes("classTurn", defaults.turnMinutes, tr("no limit"),
                     tr("The length of a turn. Nothing is lost when it is over."));
    m_warning = minutes("classWarning", defaults.warningMinutes, tr("none"),
                        tr("How long before the end a notice appears, also in the headset."));
    m_fullScreen =
        named(new QCheckBox(tr("Full s&creen")), "classFullScreen", tr("Hides everything else on the screen."));
    m_fullScreen->setChecked(defaults.fullScreen);
    m_questions = named(new QCheckBox(tr("Six &questions after each turn")), "classQuestions",
                        tr("Next Pupil shows a form about the program first. Its answers are saved with the work and "
                           "summed up in the class report; each may be left out."));
    m_questions->setChecked(defaults.asksQuestions);
    m_language = named(new QComboBox, "classLanguage", tr("The language of the window in this class."));
    for (const Named<Language>& row : languages)
        m_language->addItem(PreferencesDialog::words(row.value), static_cast<int>(row.value));
    form->addRow(tr("T&urn:"), beside(m_turn, tr("&Warning before the end:"), m_warning));
    form->addRow(tr("&Language:"), beside(m_language, {}, m_fullScreen));
    form->addRow({}, m_questions);
}

void ClassroomDialog::addPin(QFormLayout* form)
{
    const QString tip = tr("Needed to leave the class. Stored as a hash, not as plain text.");
    m_pin = named(new QLineEdit, "classPin", tip);
    m_pinRepeated = named(new QLineEdit, "classPinAgain", tip);
    for (QLineEdit* field : {m_pin, m_pinRepeated}) {
        field->setEchoMode(QLineEdit::Password);
        field->setMaxLength(maxPinLength);
    }
    form->addRow(tr("P&IN:"), beside(m_pin, tr("&Repeat PIN:"), m_pinRepeated));
}

QWidget* ClassroomDialog::choices(const QString& title, const Actions& actions, MenuId menu)
{
    auto* group = new QGroupBox(title);
    auto* grid = new QGridLayout(group);
    int count = 0;
    for (const ActionInfo& row : actionTable()) {
        if (row.menu != menu)
            continue;
        const QAction* action = actions.get(QLatin1StringView(row.id));
        auto* box = named(new QCheckBox(action->iconText()), QStringLiteral("class.") + action->objectName(),
                          action->statusTip());
        box->setIcon(action->icon());
        box->setChecked(true);
        grid->addWidget(box, count / columns, count % columns);
        ++count;
    }
    return group;
}

/// Returns the first missing or invalid entry with its field.
ClassroomDialog::Fault ClassroomDialog::faultIn(const ClassroomDraft& draft) const
{
    const Classroom& classroom = draft.classroom;
    const auto firstBox = [this](MenuId menu) {
        const auto row = std::ranges::find(actionTable(), menu, &ActionInfo::menu);
        return boxOf(this, QLatin1StringView(row->id));
    };
    if (classroom.title.isEmpty())
        return {tr("The class has no title yet."), m_title};
    if (!QDir::isAbsolutePath(classroom.folder) || !QFileInfo(classroom.folder).isDir())
        return {tr("This folder does not exist."), m_folder};
    if (const QString fault = m_names->fault(); !fault.isEmpty())
        return {fault, m_names};
    const bool keepsPin = !classroom.pin.isEmpty() && draft.pin.isEmpty();
    if (!keepsPin && draft.pin.size() < minPinLength)
        return {tr("The PIN needs at least %n characters.", nullptr, minPinLength), m_pin};
    if (draft.pin != m_pinRepeated->text())
        return {tr("The two PINs are not the same."), m_pinRepeated};
    if (classroom.starters.isEmpty() && classroom.lesson.isEmpty())
        return {tr("Choose at least one starting shape."), firstBox(MenuId::New)};
    if (classroom.tools.isEmpty())
        return {tr("Choose at least one tool."), firstBox(MenuId::Tool)};
    return {};
}
} // namespace ui
