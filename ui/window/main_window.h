#pragma once

#include "ui/classroom/classroom.h"
#include "ui/files/model_files.h"
#include "ui/headset/headset_actions.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/model_info.h"
#include "ui/window/progress_bar.h"

#include "core/operations/starter_models.h"

#include <QMainWindow>

#include <functional>
#include <memory>

class QAction;

namespace ui
{
class Actions;
class HistoryPanel;
class ModelPanel;
class Settings;
class Viewport;

/// The desktop window: viewport, menus, tool bar, brush bar, status bar. Decides nothing about the document: its parts
/// ask by signals, and it shows what it is told. Thread: gui.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Viewport* viewport() const;
    BrushSettings* brush() const;
    HistoryPanel* history() const;
    ModelPanel* modelPanel() const;
    /// Where models come from and go to.
    ModelFiles* files() const;
    HeadsetActions* headset() const;
    /// Long work, in the status bar. Save, Export and the commands of the model are disabled while it is shown.
    ProgressBar* progress() const;
    /// By its id in the action table. "edit.undo" and "edit.redo" start disabled; text and enablement are set by
    /// whoever owns the undo stack: use setUndoText() for a translated, uniform wording.
    QAction* action(const QString& id) const;
    /// `what` names the step ("Pull"), empty if there is none.
    void setUndoText(const QString& what);
    void setRedoText(const QString& what);

    /// Asked before the window closes: false keeps it open. Without one it closes.
    void setCanClose(std::function<bool()> canClose);

    /// Asked before that: false while what the hand did is still on its way. The window then closes after
    /// continueClosing().
    void setIsSettled(std::function<bool()> isSettled);

    /// Asked first of all when the window is to be closed: false keeps it open, and everything as it is.
    void setGuard(std::function<bool()> guard);

    /// From now on the window offers what that class may do, and nothing else, until it closes.
    void setClassroom(const ui::Classroom& classroom);
    /// Null: it is nobody's class.
    const Classroom* classroom() const;
    /// Brush, colours, switches and view are as they were when the class began.
    void beginTurn();
    /// For what lies over the window.
    const Actions& commands() const;

public Q_SLOTS:
    /// Another model is shown from now on: title, figures, ground, default radius, and the view frames it.
    void setModel(const ui::ModelInfo& modelInfo);
    /// The same model changed: figures; and if it is of quite another size now, the brush keeps its proportion to it.
    void updateModelInfo(const ui::ModelInfo& modelInfo);

    /// A refusal, one sentence, in a dialog that does not block the caller. A second one replaces the text of the
    /// first.
    void showProblem(const QString& sentence);
    /// Adds a button to the problem that is shown.
    void offerRemedy(const QString& text, const std::function<void()>& callback);
    /// The model has that file now.
    void showSaved(const ui::ModelInfo& modelInfo);
    /// It was written; the verdict, one line, is what the file was found to be.
    void showExported(const QString& path, const QString& verdict = {});
    /// Stamp becomes the tool, with the model of that file.
    void setBrushModel(const QString& path);
    /// A small word over the view, which goes by itself.
    void showNotice(const QString& sentence);
    /// What the VR menu offers; the sentence stands in the status bar while nobody is quite out.
    void setHeadset(ui::HeadsetState state, const QString& sentence);
    /// Retries closing, if that waits: something that it may wait for is done.
    void continueClosing();

Q_SIGNALS:
    /// By dialog or menu.
    void commandRequested(const core::ModelCommand& command);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
