#pragma once

#include "ui/classroom/classroom.h"
#include "ui/lesson/lesson_panel.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace ui
{
class Actions;
class LessonChoice;
class NamesField;
class WaitingWorksNote;
enum class MenuId;

/// The entries of the dialog: the class, a new PIN, and the file to write.
struct ClassroomDraft
{
    Classroom classroom; ///< the hash in `pin` is the loaded class's; empty: no PIN yet
    QString pin;         ///< digits of a new PIN; empty: the PIN stays unchanged
    QString path;
};

/// A dialog that edits the settings of a class and writes them to a file. It stays open until the class has been saved
/// or the dialog is cancelled. Thread: gui.
class ClassroomDialog : public QDialog
{
    Q_OBJECT

public:
    /// `folder`: initial folder of the file dialogs. The dialog deletes itself when it closes.
    ClassroomDialog(QWidget* parent, const Actions& actions, const QString& folder,
                    const QList<LessonCard>& lessons = {});

    /// Shows a class that was read from the file `path`.
    void load(const Classroom& classroom, const QString& path);
    /// Shows a message at the foot of the dialog.
    void showFault(const QString& sentence);
    WaitingWorksNote* waitingWorks() const { return m_waiting; }
    /// Emits drafted() for the loaded file, or after asking for a file. If something is missing, shows a message
    /// instead.
    void accept() override;

Q_SIGNALS:
    void openRequested(const QString& path);
    void drafted(const ui::ClassroomDraft& draft);

private:
    struct Fault
    {
        QString sentence; ///< empty: no fault
        QWidget* field = nullptr;
    };

    void addNames(QFormLayout* form);
    void addPupils(QFormLayout* form);
    void addTimes(QFormLayout* form);
    void addPin(QFormLayout* form);
    QWidget* choices(const QString& title, const Actions& actions, MenuId menu);
    QWidget* foot();
    void makeFolder();
    std::optional<ClassroomDraft> checkedDraft();
    void saveAs();
    QString folder() const;
    ClassroomDraft draft() const;
    Fault faultIn(const ClassroomDraft& draft) const;

    LessonChoice* m_lesson;
    WaitingWorksNote* m_waiting;
    QString m_startFolder;
    QString m_path; ///< file of the loaded class
    QString m_pinRecord;
    QLineEdit *m_title = nullptr, *m_folder = nullptr, *m_pin = nullptr, *m_pinRepeated = nullptr;
    QSpinBox *m_turn = nullptr, *m_warning = nullptr;
    NamesField* m_names = nullptr;
    QCheckBox *m_fullScreen = nullptr, *m_questions = nullptr, *m_others = nullptr;
    QComboBox* m_language = nullptr;
    QLabel* m_word = nullptr;
    QPushButton *m_makeFolder = nullptr, *m_save = nullptr, *m_saveAs = nullptr;
};
} // namespace ui
