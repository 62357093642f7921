#include "actions.h"

#include "themed_icon.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QToolBar>

namespace ui
{
namespace
{
// clang-format off
constexpr ActionInfo table[] = {
    {MenuId::File, "file.open", QT_TRANSLATE_NOOP("ui::Actions", "&Open…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Opens a model from a file."), "Ctrl+O", "open", false, Bar::Top},
    {MenuId::File, "file.browse", QT_TRANSLATE_NOOP("ui::Actions", "&Browse Files"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the panel with a folder of models as pictures."), "Ctrl+Shift+O", "files"},
    {MenuId::File, "file.revert", QT_TRANSLATE_NOOP("ui::Actions", "Re&vert"),
     QT_TRANSLATE_NOOP("ui::Actions", "Opens the model's file again, as it was last written."), "", "revert"},
    {MenuId::File, "file.save", QT_TRANSLATE_NOOP("ui::Actions", "&Save"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes the model to its file."), "Ctrl+S", "save", true, Bar::Top},
    {MenuId::File, "file.saveAs", QT_TRANSLATE_NOOP("ui::Actions", "Save &As…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes the model to another file, which is its own from then on."), "Ctrl+Shift+S", "save-as"},
    {MenuId::File, "file.saveCopy", QT_TRANSLATE_NOOP("ui::Actions", "Save Nu&mbered Copy"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes the model beside its file, with the next free number in the name."), "Ctrl+Alt+S", "save-copy"},
    {MenuId::File, "file.exportAs", QT_TRANSLATE_NOOP("ui::Actions", "&Export…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes the model to a file of any format; its own stays as it is."), "Ctrl+E", "export", false, Bar::Top},
    {MenuId::File, "file.exportFor", QT_TRANSLATE_NOOP("ui::Actions", "Export for &Print or Game…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes STL, 3MF or GLB with as many triangles as you like, and judges the file."), "Ctrl+Shift+E", "export-for"},
    {MenuId::File, "file.exportDrawing", QT_TRANSLATE_NOOP("ui::Actions", "Export &Drawing…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Writes a sheet with front, side and top view to scale: PDF, SVG or PNG."), "Ctrl+Shift+D", "drawing"},
    {MenuId::File, "file.quit", QT_TRANSLATE_NOOP("ui::Actions", "&Quit"),
     QT_TRANSLATE_NOOP("ui::Actions", "Closes the window and ends the program."), "Ctrl+Q", "quit", true},

    {MenuId::New, "new.ball", QT_TRANSLATE_NOOP("ui::Actions", "&Ball"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with a ball of clay."), "Ctrl+N", "starter-ball"},
    {MenuId::New, "new.cube", QT_TRANSLATE_NOOP("ui::Actions", "&Cube"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with a cube of clay."), "", "starter-cube"},
    {MenuId::New, "new.torus", QT_TRANSLATE_NOOP("ui::Actions", "&Torus"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with a ring of clay."), "", "starter-torus"},
    {MenuId::New, "new.slab", QT_TRANSLATE_NOOP("ui::Actions", "&Slab"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with a thick square plate."), "", "starter-slab"},
    {MenuId::New, "new.vase", QT_TRANSLATE_NOOP("ui::Actions", "&Vase"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with the turned blank of a vase."), "", "starter-vase"},
    {MenuId::New, "new.head", QT_TRANSLATE_NOOP("ui::Actions", "&Head"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with the blank of a head on its neck."), "", "starter-head"},
    {MenuId::New, "new.tablet", QT_TRANSLATE_NOOP("ui::Actions", "T&ablet"),
     QT_TRANSLATE_NOOP("ui::Actions", "Begins with a thin plate for a relief."), "", "starter-tablet"},

    {MenuId::Files, "files.open", QT_TRANSLATE_NOOP("ui::Actions", "&Open"),
     QT_TRANSLATE_NOOP("ui::Actions", "Opens the model that is marked in the Files panel, or enters the folder."), "Return; Enter", "open"},
    {MenuId::Files, "files.rename", QT_TRANSLATE_NOOP("ui::Actions", "&Rename"),
     QT_TRANSLATE_NOOP("ui::Actions", "Gives the file that is marked in the Files panel another name; its ending stays."), "F2", "rename"},
    {MenuId::Files, "files.duplicate", QT_TRANSLATE_NOOP("ui::Actions", "&Duplicate"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts a copy of the file that is marked in the Files panel beside it."), "Ctrl+D", "duplicate"},
    {MenuId::Files, "files.trash", QT_TRANSLATE_NOOP("ui::Actions", "Move to &Trash"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts the file that is marked in the Files panel into the trash, from which it can be taken back."), "Delete", "trash"},
    {MenuId::Files, "files.reveal", QT_TRANSLATE_NOOP("ui::Actions", "&Show in Folder"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the file that is marked in the Files panel in the desktop's program for files."), "", "reveal"},
    {MenuId::Files, "files.up", QT_TRANSLATE_NOOP("ui::Actions", "&Up"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows in the Files panel the folder in which this one lies."), "Alt+Up; Backspace", "folder-up", true},
    {MenuId::Files, "files.choose", QT_TRANSLATE_NOOP("ui::Actions", "&Choose Folder…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Asks for the folder that the Files panel shows."), "", "folder"},

    {MenuId::Edit, "edit.undo", QT_TRANSLATE_NOOP("ui::Actions", "&Undo"),
     QT_TRANSLATE_NOOP("ui::Actions", "Takes the last stroke back."), "Ctrl+Z", "undo", true, Bar::Top},
    {MenuId::Edit, "edit.redo", QT_TRANSLATE_NOOP("ui::Actions", "&Redo"),
     QT_TRANSLATE_NOOP("ui::Actions", "Does again what was taken back."), "Ctrl+Shift+Z; Ctrl+Y", "redo", false, Bar::Top},

    {MenuId::Edit, "edit.stop", QT_TRANSLATE_NOOP("ui::Actions", "&Stop"),
     QT_TRANSLATE_NOOP("ui::Actions", "Ends what is going on and leaves the model as it is."), "Esc", "stop", true},
    {MenuId::Edit, "edit.preferences", QT_TRANSLATE_NOOP("ui::Actions", "&Preferences…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Chooses colours, language, and how pen and mouse are taken."), "Ctrl+,", "preferences", true},

    {MenuId::Sculpt, "tool.pull", QT_TRANSLATE_NOOP("ui::Actions", "&Pull"),
     QT_TRANSLATE_NOOP("ui::Actions", "Draws the surface outwards. %1 pushes instead, Shift smooths."), "1", "pull", true, Bar::Palette, true},
    {MenuId::Sculpt, "tool.push", QT_TRANSLATE_NOOP("ui::Actions", "P&ush"),
     QT_TRANSLATE_NOOP("ui::Actions", "Presses the surface inwards. %1 pulls instead, Shift smooths."), "2", "push", false, Bar::Palette, true},
    {MenuId::Sculpt, "tool.flatten", QT_TRANSLATE_NOOP("ui::Actions", "&Flatten"),
     QT_TRANSLATE_NOOP("ui::Actions", "Levels the surface towards its mean plane. Shift smooths."), "3", "flatten", false, Bar::Palette, true},
    {MenuId::Sculpt, "tool.smooth", QT_TRANSLATE_NOOP("ui::Actions", "&Smooth"),
     QT_TRANSLATE_NOOP("ui::Actions", "Evens out what is rough."), "4", "smooth", false, Bar::Palette, true},
    {MenuId::Sculpt, "tool.paint", QT_TRANSLATE_NOOP("ui::Actions", "P&aint"),
     QT_TRANSLATE_NOOP("ui::Actions", "Colours the surface and leaves its shape. Shift smooths."), "5", "paint", false, Bar::Palette, true},
    {MenuId::Sculpt, "brush.smaller", QT_TRANSLATE_NOOP("ui::Actions", "S&maller Brush"),
     QT_TRANSLATE_NOOP("ui::Actions", "Makes the brush's radius a tenth smaller."), "[", "smaller", true},
    {MenuId::Sculpt, "brush.larger", QT_TRANSLATE_NOOP("ui::Actions", "&Larger Brush"),
     QT_TRANSLATE_NOOP("ui::Actions", "Makes the brush's radius a tenth larger."), "]", "larger"},
    {MenuId::Sculpt, "brush.radius", QT_TRANSLATE_NOOP("ui::Actions", "&Drag the Radius"),
     QT_TRANSLATE_NOOP("ui::Actions", "Changes the radius as the pointer moves; a click or Return keeps it, Esc or the right button goes back."), "F", "radius"},
    {MenuId::Sculpt, "brush.strength", QT_TRANSLATE_NOOP("ui::Actions", "Dra&g the Strength"),
     QT_TRANSLATE_NOOP("ui::Actions", "Changes the strength as the pointer moves; a click or Return keeps it, Esc or the right button goes back."), "Shift+F",
     "strength"},
    {MenuId::Sculpt, "brush.steady", QT_TRANSLATE_NOOP("ui::Actions", "S&teady Stroke"),
     QT_TRANSLATE_NOOP("ui::Actions", "Draws the brush on a string behind the pointer, so that a trembling hand draws smooth lines."), "Shift+S", "steady", false,
     Bar::None, true},
    {MenuId::Sculpt, "brush.add", QT_TRANSLATE_NOOP("ui::Actions", "Add &Ball"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts a ball of the brush's radius where you click next."), "A", "add", false, Bar::Palette, true},
    {MenuId::Sculpt, "turntable.on", QT_TRANSLATE_NOOP("ui::Actions", "Tur&ntable"),
     QT_TRANSLATE_NOOP("ui::Actions", "Turns the model under the hand: a hand that rests makes a groove all around."), "T", "turntable", false, Bar::Palette,
     true},
    {MenuId::Sculpt, "brush.ray", QT_TRANSLATE_NOOP("ui::Actions", "&Ray Brush"),
     QT_TRANSLATE_NOOP("ui::Actions", "Takes what lies near along the surface, and leaves the other side of a fold."), "R", "ray", true, Bar::Palette, true},
    {MenuId::Sculpt, "topology.uniform", QT_TRANSLATE_NOOP("ui::Actions", "Un&iform Topology"),
     QT_TRANSLATE_NOOP("ui::Actions", "Keeps one edge length for the whole model instead of one that follows the brush."), "U",
     "uniform", false, Bar::Palette, true},
    {MenuId::Sculpt, "topology.fusion", QT_TRANSLATE_NOOP("ui::Actions", "Fusi&on"),
     QT_TRANSLATE_NOOP("ui::Actions", "Surfaces that meet join and thin necks part; without it they stop at contact."), "J", "fusion", false, Bar::Palette, true},
    {MenuId::Sculpt, "symmetry.on", QT_TRANSLATE_NOOP("ui::Actions", "S&ymmetry"),
     QT_TRANSLATE_NOOP("ui::Actions", "Does on the other side of the plane what you do on this one."), "X", "symmetrize", false, Bar::Palette, true},
    {MenuId::Sculpt, "brush.color", QT_TRANSLATE_NOOP("ui::Actions", "Paint &Colour"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the panel that says what Paint colours with."), "C", "color", true, Bar::Palette},
    {MenuId::Sculpt, "color.pick", QT_TRANSLATE_NOOP("ui::Actions", "Pic&k Colour"),
     QT_TRANSLATE_NOOP("ui::Actions", "The next click on the model takes its colour for Paint."), "S", "pick", false, Bar::None, true},
    {MenuId::Sculpt, "color.swap", QT_TRANSLATE_NOOP("ui::Actions", "S&wap Colours"),
     QT_TRANSLATE_NOOP("ui::Actions", "Paints with the other colour, and keeps this one for the next swap."), "Shift+C", "swap"},

    {MenuId::Model, "model.move", QT_TRANSLATE_NOOP("ui::Actions", "&Move…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Moves the whole model by so many millimetres."), "", "move"},
    {MenuId::Model, "model.rotate", QT_TRANSLATE_NOOP("ui::Actions", "&Rotate…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Turns the whole model about an axis through the origin."), "", "rotate"},
    {MenuId::Model, "model.scale", QT_TRANSLATE_NOOP("ui::Actions", "&Scale…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Makes the whole model larger or smaller."), "", "scale"},
    {MenuId::Model, "model.mirror", QT_TRANSLATE_NOOP("ui::Actions", "M&irror…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Turns the whole model into its mirror image."), "", "mirror"},
    {MenuId::Model, "model.symmetrize", QT_TRANSLATE_NOOP("ui::Actions", "S&ymmetrize…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts the mirror image of one half of the model in the other's place."), "", "symmetrize"},
    {MenuId::Model, "model.recentre", QT_TRANSLATE_NOOP("ui::Actions", "Re&centre"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts the middle of the model at the origin."), "", "recentre"},
    {MenuId::Model, "model.reset", QT_TRANSLATE_NOOP("ui::Actions", "Reset to S&tart"),
     QT_TRANSLATE_NOOP("ui::Actions", "Gives the model the shape and the colours that it was opened with; Undo takes that back."), "", "reset"},
    {MenuId::Model, "model.insert", QT_TRANSLATE_NOOP("ui::Actions", "I&nsert…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Adds another model from a file to this one."), "", "insert", true},
    {MenuId::Model, "model.fill", QT_TRANSLATE_NOOP("ui::Actions", "&Fill with Colour"),
     QT_TRANSLATE_NOOP("ui::Actions", "Gives the whole model the paint colour."), "", "fill", true},
    {MenuId::Model, "model.remesh", QT_TRANSLATE_NOOP("ui::Actions", "Remesh &Uniformly…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Makes all triangles of the model about as large."), "", "remesh"},

    {MenuId::Model, "model.placeOnBed", QT_TRANSLATE_NOOP("ui::Actions", "P&lace on Bed"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts the model's lowest point at height 0, where a printer's bed is."), "", "place-on-bed", true},
    {MenuId::Model, "model.flattenBase", QT_TRANSLATE_NOOP("ui::Actions", "Flatten &Base…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Cuts the model level a little above its lowest point, so that it stands flat."), "", "flatten-base"},
    {MenuId::Model, "model.printCheck", QT_TRANSLATE_NOOP("ui::Actions", "&Print Check"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows whether the model prints: walls, overhangs, base, and the printer's bed."), "Ctrl+P", "print-check"},

    {MenuId::View, "view.frame", QT_TRANSLATE_NOOP("ui::Actions", "&Frame Model"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the whole model."), "Home; .", "frame", true, Bar::Top},
    {MenuId::View, "view.front", QT_TRANSLATE_NOOP("ui::Actions", "F&ront"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from the front: x to the right, y up."), "Num+1", "view-front", true},
    {MenuId::View, "view.back", QT_TRANSLATE_NOOP("ui::Actions", "&Back"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from behind: x to the left, y up."), "Ctrl+Num+1", "view-back"},
    {MenuId::View, "view.right", QT_TRANSLATE_NOOP("ui::Actions", "R&ight"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from the right: z to the left, y up."), "Num+3", "view-right"},
    {MenuId::View, "view.left", QT_TRANSLATE_NOOP("ui::Actions", "&Left"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from the left: z to the right, y up."), "Ctrl+Num+3", "view-left"},
    {MenuId::View, "view.top", QT_TRANSLATE_NOOP("ui::Actions", "&Top"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from above: x to the right, z down."), "Num+7", "view-top"},
    {MenuId::View, "view.bottom", QT_TRANSLATE_NOOP("ui::Actions", "Botto&m"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model from below: x to the right, z up."), "Ctrl+Num+7", "view-bottom"},
    {MenuId::View, "view.orthographic", QT_TRANSLATE_NOOP("ui::Actions", "&Orthographic"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows what is far as large as what is near, or as the eye sees it."), "Num+5", "orthographic", true, Bar::None, true},

    {MenuId::View, "view.wireframe", QT_TRANSLATE_NOOP("ui::Actions", "&Wireframe"),
     QT_TRANSLATE_NOOP("ui::Actions", "Draws the edges of the triangles over the model."), "W", "wireframe", true, Bar::Top, true},
    {MenuId::View, "view.flat", QT_TRANSLATE_NOOP("ui::Actions", "Fl&at Shading"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows each triangle in one shade instead of a smooth surface."), "Shift+W", "flat", false, Bar::None, true},
    {MenuId::View, "view.ground", QT_TRANSLATE_NOOP("ui::Actions", "&Ground Grid"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows a grid in millimetres under the model."), "G", "ground", false, Bar::None, true},
    {MenuId::View, "view.scaleBar", QT_TRANSLATE_NOOP("ui::Actions", "&Scale Bar"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows a length in millimetres in the corner of the view."), "Shift+G", "scale-bar", false, Bar::None, true},

    {MenuId::Material, "material.clay", QT_TRANSLATE_NOOP("ui::Actions", "&Clay"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as warm, dull clay."), "Alt+1", "material-clay", false, Bar::None, true},
    {MenuId::Material, "material.grey", QT_TRANSLATE_NOOP("ui::Actions", "&Grey Clay"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as cool grey clay, which hides no bump."), "Alt+2", "material-grey", false, Bar::None, true},
    {MenuId::Material, "material.wax", QT_TRANSLATE_NOOP("ui::Actions", "Red &Wax"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as red wax, soft in the shadows and shiny in the light."), "Alt+3", "material-wax", false, Bar::None, true},
    {MenuId::Material, "material.porcelain", QT_TRANSLATE_NOOP("ui::Actions", "&Porcelain"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as white, glazed porcelain."), "Alt+4", "material-porcelain", false, Bar::None, true},
    {MenuId::Material, "material.pearl", QT_TRANSLATE_NOOP("ui::Actions", "P&earl"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as pearl, which shimmers where it turns away."), "Alt+5", "material-pearl", false, Bar::None, true},
    {MenuId::Material, "material.skin", QT_TRANSLATE_NOOP("ui::Actions", "&Skin"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the model as skin, with light in its shadows."), "Alt+6", "material-skin", false, Bar::None, true},
    {MenuId::Material, "material.paint", QT_TRANSLATE_NOOP("ui::Actions", "Painted C&olours"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the colours that were painted as they are, shaded."), "Alt+7", "material-paint", true, Bar::None, true},

    {MenuId::Background, "background.theme", QT_TRANSLATE_NOOP("ui::Actions", "As the &Window"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts behind the model what suits the window, light or dark."), "", "background-theme", false, Bar::None, true},
    {MenuId::Background, "background.light", QT_TRANSLATE_NOOP("ui::Actions", "&Light"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts a light grey behind the model."), "", "background-light", false, Bar::None, true},
    {MenuId::Background, "background.dark", QT_TRANSLATE_NOOP("ui::Actions", "&Dark"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts a dark grey behind the model."), "", "background-dark", false, Bar::None, true},
    {MenuId::Background, "background.sky", QT_TRANSLATE_NOOP("ui::Actions", "&Sky"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts a pale blue sky behind the model."), "", "background-sky", false, Bar::None, true},
    {MenuId::Background, "background.white", QT_TRANSLATE_NOOP("ui::Actions", "W&hite"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts plain white behind the model."), "", "background-white", true, Bar::None, true},
    {MenuId::Background, "background.black", QT_TRANSLATE_NOOP("ui::Actions", "&Black"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts plain black behind the model."), "", "background-black", false, Bar::None, true},

    {MenuId::Reference, "reference.choose", QT_TRANSLATE_NOOP("ui::Actions", "&Choose…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Puts an image behind the model, on the side from which the view looks."), "", "reference-choose"},
    {MenuId::Reference, "reference.show", QT_TRANSLATE_NOOP("ui::Actions", "&Show Reference Images"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows the image of a side while the view looks from there."), "Shift+R", "reference", false, Bar::None, true},
    {MenuId::Reference, "reference.remove", QT_TRANSLATE_NOOP("ui::Actions", "&Remove Reference Image"),
     QT_TRANSLATE_NOOP("ui::Actions", "Takes away the image of the side from which the view looks."), "", "reference-remove"},

    {MenuId::Vr, "vr.status", QT_TRANSLATE_NOOP("ui::Actions", "&Look for a Headset"),
     QT_TRANSLATE_NOOP("ui::Actions", "Says whether a VR headset is ready."), "", "headset"},

    {MenuId::Help, "help.start", QT_TRANSLATE_NOOP("ui::Actions", "&Start Page"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows what to begin with: starters, recent files, and three short lessons."), "", "start"},
    {MenuId::Help, "help.guide", QT_TRANSLATE_NOOP("ui::Actions", "&User Guide"),
     QT_TRANSLATE_NOOP("ui::Actions", "Opens the guide beside the window: first steps, lessons, and a page for everything."), "Shift+F1", "guide"},
    {MenuId::Help, "help.keys", QT_TRANSLATE_NOOP("ui::Actions", "&Commands and Keys…"),
     QT_TRANSLATE_NOOP("ui::Actions", "Shows every command with its key, and finds one by its words."), "F1; F3", "keys"},
    {MenuId::Help, "help.about", QT_TRANSLATE_NOOP("ui::Actions", "&About Fettle"),
     QT_TRANSLATE_NOOP("ui::Actions", "Says what this program is, and its version."), "", "about", true},
};
// clang-format on

/// A starter looks like itself; all others are drawn in the text's colour.
QIcon iconOf(const ActionInfo& row)
{
    const QString name = QLatin1StringView(row.icon);
    return row.menu == MenuId::New ? QIcon(QStringLiteral(":/pictures/%1.png").arg(name)) : themedIcon(name);
}

/// "Pull (1)" and what it does.
QString toolTip(const QAction& action)
{
    QString name = action.iconText();
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    if (!key.isEmpty())
        name += QStringLiteral(" (%1)").arg(key);
    return QStringLiteral("%1\n%2").arg(name, action.statusTip());
}
} // namespace

std::span<const ActionInfo> actionTable()
{
    return table;
}

Actions::Actions(QWidget* window) : QObject(window)
{
    for (const ActionInfo& row : table)
        m_actions.insert(QLatin1StringView(row.id), make(row, window));
    setKeys({});
    window->installEventFilter(this);
}

QAction* Actions::make(const ActionInfo& row, QWidget* window)
{
    auto* action = new QAction(iconOf(row), tr(row.text), this);
    action->setObjectName(QLatin1StringView(row.id));
    action->setCheckable(row.checkable);
    action->setIconText(plain(action->text()));
    if (row.menu == MenuId::Files)
        action->setShortcutContext(Qt::WidgetShortcut);
    else
        window->addAction(action);
    return action;
}

QAction* Actions::get(const QString& id) const
{
    QAction* action = m_actions.value(id);
    Q_ASSERT_X(action, "Actions::get", qPrintable(id));
    return action;
}

/// "拉出(&P)": where the script has no letters for keys, the key stands behind in brackets.
QString Actions::plain(QString text)
{
    static const QRegularExpression menuOnly(QStringLiteral("\\(&.\\)|&| ?…"));
    return text.remove(menuOnly);
}

void Actions::setKeys(const KeyChoice& choice)
{
    m_choice = choice;
    m_keys = KeyMap(choice);
    for (const ActionInfo& row : table) {
        QAction* action = get(QLatin1StringView(row.id));
        action->setShortcuts(m_keys.keys(action->objectName()));
        action->setStatusTip(tr(row.tip).replace(QLatin1StringView("%1"), modifierName(heldKeys(choice.preset).invert)));
        action->setToolTip(toolTip(*action));
    }
}

QString Actions::modifierName(Qt::KeyboardModifier modifier)
{
    const QString withLetter = QKeySequence(modifier | Qt::Key_A).toString(QKeySequence::NativeText);
    return withLetter.section(u'+', 0, 0);
}

QString Actions::heldWords(KeyPreset preset)
{
    const HeldKeys held = heldKeys(preset);
    const QString brush = tr("Held on the model, %1 inverts Pull and Push, and %2 smooths.").arg(modifierName(held.invert), modifierName(Qt::ShiftModifier));
    return held.rightOrbits ? brush + u' ' + tr("The right button turns the view.") : brush;
}

namespace
{
/// Where Home goes to the first of something: there it is the control's and no command's.
bool hasHome(const QWidget* focus)
{
    return qobject_cast<const QComboBox*>(focus) || qobject_cast<const QAbstractItemView*>(focus) || qobject_cast<const QAbstractSlider*>(focus)
           || qobject_cast<const QTabBar*>(focus);
}
} // namespace

/// On X11 Qt looks up the shortcuts of the number pad's keys without saying that they are of the pad: "Num+1" would be
/// "1". What no widget has taken comes here first.
bool Actions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (event->type() == QEvent::ShortcutOverride && key->key() == Qt::Key_Home && hasHome(QApplication::focusWidget())) {
            event->accept();
            return true;
        }
        const QString id = key->modifiers() & Qt::KeypadModifier ? m_keys.owner(key->keyCombination()) : QString();
        if (!id.isEmpty() && get(id)->shortcutContext() == Qt::WindowShortcut) {
            event->accept();
            if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
                get(id)->trigger();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

QString Actions::menuTitle(MenuId menu) const
{
    switch (menu) {
    case MenuId::File:
        return tr("&File");
    case MenuId::New:
        return tr("&New");
    case MenuId::Files:
        return tr("Files &Panel");
    case MenuId::Edit:
        return tr("&Edit");
    case MenuId::Sculpt:
        return tr("&Sculpt");
    case MenuId::Model:
        return tr("&Model");
    case MenuId::View:
        return tr("&View");
    case MenuId::Material:
        return tr("Mat&erial");
    case MenuId::Background:
        return tr("Ba&ckground");
    case MenuId::Reference:
        return tr("Refere&nce Image");
    case MenuId::Vr:
        return tr("V&R");
    case MenuId::Help:
        return tr("&Help");
    }
    return {};
}

void Actions::fill(QMenu* menu, MenuId which) const
{
    for (const ActionInfo& row : table) {
        if (row.menu != which)
            continue;
        if (row.startsGroup && !menu->isEmpty())
            menu->addSeparator();
        menu->addAction(get(QLatin1StringView(row.id)));
    }
}

void Actions::fill(QToolBar* bar, Bar which) const
{
    for (const ActionInfo& row : table) {
        if (row.bar != which)
            continue;
        if (row.startsGroup && !bar->actions().isEmpty())
            bar->addSeparator();
        bar->addAction(get(QLatin1StringView(row.id)));
    }
}
} // namespace ui
