#include "ui/gizmo/plane_cut_tool.h"

#include "ui/actions/actions.h"
#include "ui/gizmo/gizmo.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/view_card.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <numbers>

namespace ui
{
namespace
{
constexpr int normalAxis = 1;
constexpr double planeShare = 0.62; ///< half side of the shown square, as a share of the part's diagonal
/// Distance beyond the plane at which the tint begins, as a share of the part's diagonal: a face that an earlier cut
/// has left in the plane is not tinted here and there.
constexpr double tintShare = 1e-4;
} // namespace

PlaneCutTool::PlaneCutTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport)
    : QObject(viewport)
    , m_viewport(viewport)
    , m_brush(brush)
    , m_action(actions.get(QStringLiteral("area.plane")))
    , m_gizmo(new Gizmo(viewport, GizmoShape::Handles::WithoutScale))
    , m_word(named(new QLabel, "planeCutWord"))
    , m_colors(named(new QCheckBox(tr("Colour the cu&t")), "planeCutColors",
                     tr("Cut Away gives the flat face the paint colour.")))
    , m_bar(makeBar())
{
    m_gizmo->setObjectName(QStringLiteral("planeCutGizmo"));
    connect(m_action, &QAction::toggled, this, &PlaneCutTool::setOn);
    connect(m_gizmo, &Gizmo::ended, m_action, [this] { m_action->setChecked(false); });
    for (const auto changed : {&Gizmo::dragged, &Gizmo::dropped})
        connect(m_gizmo, changed, this, &PlaneCutTool::showPlane);
    connect(m_gizmo, &Gizmo::frameMoved, this, &PlaneCutTool::showPlane);
    connect(brush, &BrushSettings::changed, this, &PlaneCutTool::showPlane);
}

ViewCard* PlaneCutTool::makeBar()
{
    auto* bar = new ViewCard(m_viewport, "planeCutBar");
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(gap, gap, gap, gap);
    column->addWidget(m_word);
    column->addWidget(m_colors);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    const auto add = [&](const char* name, const QString& text, const QString& tip, const auto& callback) {
        auto* button = named(new QPushButton(text), name, tip);
        connect(button, &QPushButton::clicked, this, callback);
        row->addWidget(button);
    };
    add("planeCutAway", tr("&Cut Away"), tr("Removes what is tinted, and closes the cut with a flat face."),
        [this] { request(false); });
    add("planeCutSplit", tr("&Split"), tr("Makes what is tinted a part of its own."), [this] { request(true); });
    add("planeCutSwap", tr("S&wap Sides"), tr("Turns the plane over, so that the other side is tinted."),
        [this] { swapSides(); });
    add("planeCutDone", tr("D&one"), tr("Hides the plane (Esc)."), [this] { m_action->setChecked(false); });
    return bar;
}

bool PlaneCutTool::isOn() const
{
    return m_action->isChecked();
}

void PlaneCutTool::setOn(bool on)
{
    if (on)
        return Q_EMIT regionWanted();
    m_box.reset();
    m_vertices.reset();
    m_gizmo->setFrame({});
    m_bar->hide();
    m_viewport->showCut({});
}

void PlaneCutTool::setBusy(bool isBusy)
{
    m_bar->setEnabled(!isBusy);
}

void PlaneCutTool::refresh()
{
    if (isOn())
        Q_EMIT regionWanted();
}

/// Begins with a level plane through the middle of the part. The plane stays where the user has it as long as it is
/// near the part.
void PlaneCutTool::setRegion(const core::TransformRegion& region)
{
    if (!isOn() || region.whole.isEmpty())
        return;
    m_box = region.whole;
    m_vertices = region.all;
    const double size = m_box->diagonal().norm();
    m_gizmo->setPlane(planeShare * size);
    if (!m_gizmo->frame() || m_box->exteriorDistance(m_gizmo->frame()->centre) > size)
        m_gizmo->setFrame(GizmoFrame{m_box->center()});
    m_bar->show();
    showPlane();
}

QString PlaneCutTool::wordFor(core::MirroredPlane image) const
{
    switch (image) {
    case core::MirroredPlane::None:
        break;
    case core::MirroredPlane::Other:
        return tr("Symmetry: the mirror image of the plane cuts, too.");
    case core::MirroredPlane::Same:
        return tr("Symmetry: the plane is its own mirror image, so it cuts once.");
    case core::MirroredPlane::Turned:
        return tr("This is the plane of symmetry, so one half goes.");
    }
    return {};
}

void PlaneCutTool::showPlane()
{
    const std::optional<GizmoFrame>& frame = m_gizmo->frame();
    if (!frame || !m_box)
        return;
    const core::Vec3 normal = frame->axis(normalAxis);
    const core::Symmetry symmetry = m_brush->stroke().symmetry;
    const core::MirroredPlane mirrored = core::mirroredPlane(frame->centre, normal, *m_box, symmetry);
    const core::Symmetry image = mirrored == core::MirroredPlane::Other ? symmetry : core::Symmetry::None;
    const core::Vec3 tintedFrom = frame->centre + tintShare * m_box->diagonal().norm() * normal;
    m_viewport->showCut(Viewport::Cut{tintedFrom, normal, image, m_vertices});
    m_gizmo->setImage(image);
    m_gizmo->update();
    const QString word = wordFor(mirrored);
    m_word->setText(word);
    m_word->setVisible(!word.isEmpty());
    m_bar->place();
}

void PlaneCutTool::swapSides()
{
    if (m_gizmo->isDragging())
        return;
    GizmoFrame frame = *m_gizmo->frame();
    frame.axes = frame.axes * Eigen::AngleAxisd(std::numbers::pi, core::Vec3::UnitX());
    m_gizmo->setFrame(frame);
    showPlane();
}

void PlaneCutTool::request(bool splits)
{
    const GizmoFrame& frame = *m_gizmo->frame();
    core::Trim trim = core::trimBeyond(frame.centre, frame.axis(normalAxis), *m_box, m_brush->stroke().symmetry);
    if (m_colors->isChecked())
        trim.color = m_brush->stroke().color;
    Q_EMIT requested(splits ? core::ModelCommand(core::SplitPart{trim.area, {}}) : core::ModelCommand(trim));
}
} // namespace ui
