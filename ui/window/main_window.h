#pragma once

#include "ui/classroom/classroom.h"
#include "ui/files/model_files.h"
#include "ui/headset/headset_actions.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/model_info.h"
#include "ui/window/progress_bar.h"

#include "core/primitives/starter_models.h"

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

/// The desktop window: viewport, menus, tool bar, brush bar, panels, status bar. Does not own the document: its parts
/// emit requests as signals, and it shows the model it is given. Thread: gui.
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
    /// Returns the object that handles opening, saving and exporting of models.
    ModelFiles* files() const;
    HeadsetActions* headset() const;
    /// Returns the progress display in the status bar. Save, Export and the commands of the model are disabled while it
    /// is visible.
    ProgressBar* progress() const;
    /// Returns the action with this id in the action table. "edit.undo" and "edit.redo" start disabled; the owner of
    /// the undo stack must enable them, and set their texts by setUndoText() and setRedoText().
    QAction* action(const QString& id) const;
    /// Sets the text of the undo action. `what`: translated name of the step ("Pull"), empty if there is none.
    void setUndoText(const QString& what);
    void setRedoText(const QString& what);

    /// Sets a function that is called before the window closes; false keeps the window open. By default the window
    /// closes.
    void setCanClose(std::function<bool()> canClose);

    /// Sets a function that is called before canClose. It must return false while the user's last input is still being
    /// processed; the window then closes in continueClosing().
    void setIsSettled(std::function<bool()> isSettled);

    /// Sets a function that is called first when the window is to be closed; false: the window stays open, and the
    /// other functions are not called.
    void setGuard(std::function<bool()> guard);

    /// Restricts the window to what the class allows, until the window closes.
    void setClassroom(const ui::Classroom& classroom);
    /// Returns the class; null if no class is set.
    const Classroom* classroom() const;
    /// Restores brush, colours, switches and view to their state at the beginning of the class.
    void beginTurn();
    /// Returns the actions, for widgets that cover the window.
    const Actions& commands() const;

public Q_SLOTS:
    /// Shows another model: title, figures, ground, default radius, and a view that frames the model.
    void setModel(const ui::ModelInfo& modelInfo);
    /// Shows changed data of the present model. If its size has changed by more than a factor of 2, the brush's radius
    /// keeps its proportion to the model, and the view frames the model unless it follows the headset.
    void updateModelInfo(const ui::ModelInfo& modelInfo);

    /// Shows an error sentence in a dialog that does not block the caller. If the dialog is already open, replaces its
    /// text.
    void showProblem(const QString& sentence);
    /// Adds a button with a remedy to the error dialog that is open.
    void offerRemedy(const QString& text, const std::function<void()>& callback);
    /// Shows that the model was saved in the file of `modelInfo`.
    void showSaved(const ui::ModelInfo& modelInfo);
    /// Shows that a file was written. `verdict`: one line with the result of checking the file.
    void showExported(const QString& path, const QString& verdict = {});
    /// Selects the tool Stamp with the model in this file.
    void setBrushModel(const QString& path);
    /// Shows a short message over the view, which disappears after some seconds.
    void showNotice(const QString& sentence);
    /// Updates the VR menu. The sentence is shown in the status bar unless the state is Out.
    void setHeadset(ui::HeadsetState state, const QString& sentence);
    /// Closes the window if a close request was deferred until the input is processed. Call when the input
    /// may have been processed.
    void continueClosing();

Q_SIGNALS:
    /// The user requested a command on the model by dialog or menu.
    void commandRequested(const core::ModelCommand& command);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
