#include "ui/reference/reference_actions.h"

#include "ui/actions/actions.h"
#include "ui/files/model_files.h"
#include "ui/reference/reference_images.h"
#include "ui/reference/reference_panel.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/side_column.h"

#include <QAction>
#include <QFileInfo>
#include <QMainWindow>

namespace ui
{
namespace
{
/// Returns the initial folder of the file dialog: that of the side's image, else of another side's image, else of the
/// last model.
QString folderFor(OrbitCamera::Side side, const ReferenceImages& images, const Settings& settings)
{
    QString path = images.path(side);
    for (const auto& other : viewSides)
        if (path.isEmpty())
            path = images.path(other.value);
    return path.isEmpty() ? settings.lastFolder() : QFileInfo(path).absolutePath();
}

void connectCommands(const ReferenceContext& context, ReferenceImages* images, const Settings* settings,
                     const Actions& actions)
{
    Viewport* viewport = context.viewport;
    const auto choose = [=](const QString& path) {
        images->choose(nearestSide(viewport->camera()), path, viewport->navigation()->box());
    };
    QObject::connect(actions.get(QStringLiteral("reference.choose")), &QAction::triggered, images,
                     [=, window = context.window] {
                         askForPicture(window, folderFor(nearestSide(viewport->camera()), *images, *settings), choose);
                     });
    QObject::connect(context.files, &ModelFiles::pictureDropped, images, choose);

    QAction* show = actions.get(QStringLiteral("reference.show"));
    QAction* remove = actions.get(QStringLiteral("reference.remove"));
    QObject::connect(show, &QAction::triggered, images, &ReferenceImages::setShown);
    QObject::connect(remove, &QAction::triggered, images, [=] { images->remove(nearestSide(viewport->camera())); });
    const auto showState = [=] {
        show->setChecked(images->isShown());
        remove->setEnabled(!images->path(nearestSide(viewport->camera())).isEmpty());
    };
    QObject::connect(images, &ReferenceImages::changed, show, showState);
    QObject::connect(viewport->input(), &PointerInput::viewChanged, show, showState);
    showState();
}

/// Turns the view to the side of a newly chosen image, unless the camera looks from this side already.
void turnTo(OrbitCamera::Side side, Viewport* viewport)
{
    if (!looksFrom(viewport->camera(), side))
        viewport->navigation()->turnTo(side);
}
} // namespace

void addReferences(const ReferenceContext& context, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice)
{
    Viewport* viewport = context.viewport;
    auto* images = new ReferenceImages(settings, viewport);
    connectCommands(context, images, settings, actions);
    QObject::connect(images, &ReferenceImages::changed, viewport, [=] { viewport->setReferences(images->shown()); });
    QObject::connect(images, &ReferenceImages::refused, viewport, notice);

    SidePanel* section = context.column->add(QStringLiteral("referencePanel"), ReferencePanel::tr("Image"),
                                             new ReferencePanel(images, viewport, actions), SidePanel::State::Hidden);
    QObject::connect(images, &ReferenceImages::chosen, section, [=](OrbitCamera::Side side) {
        turnTo(side, viewport);
        section->bringForward();
    });
}
} // namespace ui
