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

/// Draft that a teacher typed: the class, a new PIN, and the file that it is to be kept in.
struct ClassroomDraft
{
    Classroom classroom; ///< its PIN is that of the class that was loaded; empty: there is none yet
    QString pin;         ///< the digits; empty: the PIN stays
    QString path;
};

/// Asks what a class may do, then where to keep it if it has no file yet, and stays open until the class is kept or
/// given up. Thread: gui.
class ClassroomDialog : public QDialog
{
    Q_OBJECT

public:
    /// `folder`: where the dialogs for files begin. Deletes itself when it closes.
    ClassroomDialog(QWidget* parent, const Actions& actions, const QString& folder,
                    const QList<LessonCard>& lessons = {});

    /// Shows a class that was read from a file.
    void load(const Classroom& classroom, const QString& path);
    /// Shows one sentence at the foot.
    void showFault(const QString& sentence);
    WaitingWorksNote* waitingWorks() const { return m_waiting; }
    /// Keeps the class in the file that it was loaded from, or asks for one, if all is there; else says what is
    /// missing.
    void accept() override;

Q_SIGNALS:
    void openRequested(const QString& path);
    void drafted(const ui::ClassroomDraft& draft);

private:
    struct Fault
    {
        QString sentence; ///< empty: none
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
    QString m_path; ///< of the class that was loaded
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
