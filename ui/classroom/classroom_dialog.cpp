#include "ui/classroom/classroom_dialog.h"

#include "ui/actions/actions.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/settings/stored_values.h"
#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace ui
{
namespace
{
constexpr int textWidth = 460, columns = 4;

class ClassroomDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::ClassroomDialog)

public:
    ClassroomDialog(QWidget* parent, const Actions& actions, const QString& folder)
        : QDialog(parent)
        , m_startFolder(folder)
    {
        QVBoxLayout* column = beginDialog(this, "classroomDialog", tr("Classroom"));
        QVBoxLayout* page = addScrolledPage(column);
        page->addWidget(dialogText(tr("A class has turns: each pupil begins with fresh clay, and Next Pupil keeps "
                                      "the work in the class's folder. "
                                      "Pupils cannot reach other files; leaving asks for your PIN."),
                                   textWidth));
        auto* form = new QFormLayout;
        form->setSpacing(dialogGap);
        addNames(form);
        addTimes(form);
        addPin(form);
        page->addLayout(form);
        page->addWidget(choices(tr("Starting shapes"), actions, MenuId::New));
        page->addWidget(choices(tr("Tools"), actions, MenuId::Tool));
        m_word = dialogText({}, textWidth);
        m_word->setObjectName(QStringLiteral("classroomWord"));
        column->addWidget(m_word);
        addDialogButtons(this, tr("&Save…"));
        m_title->setFocus();
    }

    ClassroomDraft draft() const
    {
        ClassroomDraft draft;
        Classroom& classroom = draft.classroom;
        classroom.title = m_title->text().simplified();
        classroom.folder = folder();
        for (const core::Starter starter : core::starters)
            if (box(QStringLiteral("new.") + QString::fromUtf8(core::name(starter)))->isChecked())
                classroom.starters << starter;
        for (const std::string_view name : core::toolNames())
            if (box(QStringLiteral("tool.") + QString::fromUtf8(name))->isChecked())
                classroom.tools << *core::named<core::Tool>(name);
        classroom.turnMinutes = m_turn->value();
        classroom.warningMinutes = std::min(m_warning->value(), m_turn->value());
        classroom.fullScreen = m_fullScreen->isChecked();
        classroom.asksQuestions = m_questions->isChecked();
        classroom.language = static_cast<Language>(m_language->currentData().toInt());
        draft.pin = m_pin->text();
        return draft;
    }

    void accept() override
    {
        const QString fault = faultIn(draft());
        m_word->setText(fault);
        if (fault.isEmpty())
            QDialog::accept();
    }

private:
    QString folder() const { return QDir::cleanPath(QDir::fromNativeSeparators(m_folder->text().trimmed())); }
    QCheckBox* box(const QString& id) const { return findChild<QCheckBox*>(QStringLiteral("class.") + id); }

    void addNames(QFormLayout* form)
    {
        m_title =
            named(new QLineEdit, "classTitleField", tr("Stands in the topmost bar, such as the name of the class."));
        form->addRow(tr("&Title:"), m_title);
        m_folder = named(new QLineEdit, "classFolderField",
                         tr("There each turn gets a folder with model, picture and record."));
        auto* choose = named(new QPushButton(tr("&Choose…")), "classFolderChoice", m_folder->toolTip());
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

    void addTimes(QFormLayout* form)
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
                         tr("So long is a turn. Nothing is taken away when it is over."));
        m_warning = minutes("classWarning", defaults.warningMinutes, tr("none"),
                            tr("So long before the end a notice appears, in the headset, too."));
        m_fullScreen = named(new QCheckBox(tr("Full &screen")), "classFullScreen",
                             tr("Nothing else is to be seen on the screen."));
        m_fullScreen->setChecked(defaults.fullScreen);
        m_questions =
            named(new QCheckBox(tr("Six &questions after each turn")), "classQuestions",
                  tr("Next Pupil shows a form about the program first. Its answers are kept with the work and "
                     "summed in the class report; each may be left out."));
        m_questions->setChecked(defaults.asksQuestions);
        m_language = named(new QComboBox, "classLanguage", tr("The words of the window in this class."));
        for (const Named<Language>& row : languages)
            m_language->addItem(PreferencesDialog::words(row.value), static_cast<int>(row.value));
        form->addRow(tr("T&urn:"), m_turn);
        form->addRow(tr("&Warning before the end:"), m_warning);
        form->addRow(tr("&Language:"), m_language);
        form->addRow({}, m_fullScreen);
        form->addRow({}, m_questions);
    }

    void addPin(QFormLayout* form)
    {
        const QString tip = tr("Leaving the class takes it. It is kept as a fingerprint, not as you type it.");
        m_pin = named(new QLineEdit, "classPin", tip);
        m_pinRepeated = named(new QLineEdit, "classPinAgain", tip);
        for (QLineEdit* field : {m_pin, m_pinRepeated}) {
            field->setEchoMode(QLineEdit::Password);
            field->setMaxLength(maxPinLength);
        }
        form->addRow(tr("&PIN:"), m_pin);
        form->addRow(tr("&Repeat PIN:"), m_pinRepeated);
    }

    QWidget* choices(const QString& title, const Actions& actions, MenuId menu)
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

    /// Empty, or what is missing.
    QString faultIn(const ClassroomDraft& draft) const
    {
        if (draft.classroom.title.isEmpty())
            return tr("The class has no title yet.");
        if (!QDir::isAbsolutePath(draft.classroom.folder) || !QFileInfo(draft.classroom.folder).isDir())
            return tr("This folder does not exist.");
        if (draft.classroom.starters.isEmpty())
            return tr("Choose at least one starting shape.");
        if (draft.classroom.tools.isEmpty())
            return tr("Choose at least one tool.");
        if (draft.pin.size() < minPinLength)
            return tr("The PIN needs at least %n characters.", nullptr, minPinLength);
        if (draft.pin != m_pinRepeated->text())
            return tr("The two PINs are not the same.");
        return {};
    }

    QString m_startFolder;
    QLineEdit *m_title = nullptr, *m_folder = nullptr, *m_pin = nullptr, *m_pinRepeated = nullptr;
    QSpinBox *m_turn = nullptr, *m_warning = nullptr;
    QCheckBox *m_fullScreen = nullptr, *m_questions = nullptr;
    QComboBox* m_language = nullptr;
    QLabel* m_word = nullptr;
};
} // namespace

void askForClassroom(QWidget* parent, const Actions& actions, const QString& folder,
                     const std::function<void(const ClassroomDraft&)>& callback)
{
    auto* dialog = new ClassroomDialog(parent, actions, folder);
    QObject::connect(dialog, &QDialog::accepted, parent, [dialog, parent, folder, callback] {
        askForClassFile(parent, folder, [callback, draft = dialog->draft()](const QString& path) mutable {
            draft.path = path;
            callback(draft);
        });
    });
    dialog->open();
}
} // namespace ui
