#include "ui/gizmo/transform_tool.h"

#include "ui/actions/actions.h"
#include "ui/gizmo/gizmo.h"
#include "ui/gizmo/transform_fields.h"
#include "ui/viewport/viewport.h"

#include <QAction>

#include <utility>

namespace ui
{
namespace
{
bool isEqual(const core::TransformRegion& a, const core::TransformRegion& b)
{
    return a.box.min() == b.box.min() && a.box.max() == b.box.max() && a.centre == b.centre && a.axes == b.axes &&
           a.vertices->slots == b.vertices->slots && a.vertices->weights == b.vertices->weights;
}
} // namespace

TransformTool::TransformTool(const Actions& actions, Viewport* viewport)
    : QObject(viewport)
    , m_viewport(viewport)
    , m_action(actions.get(QStringLiteral("model.transform")))
    , m_gizmo(new Gizmo(viewport))
    , m_fields(new TransformFields(viewport))
{
    m_gizmo->setObjectName(QStringLiteral("transformGizmo"));
    connect(m_action, &QAction::toggled, this, &TransformTool::setOn);
    connect(m_gizmo, &Gizmo::ended, m_action, [this] { m_action->setChecked(false); });
    connect(m_gizmo, &Gizmo::frameMoved, this, [this] {
        m_start = *m_gizmo->frame();
        m_keptFor = m_region->box.center();
        m_hasTurnedAxes = true;
    });
    connect(m_gizmo, &Gizmo::dragged, this, [this](const core::Transform& by) {
        m_fields->setValues(valuesOf(by, m_start));
        preview(by);
    });
    connect(m_gizmo, &Gizmo::dropped, this, &TransformTool::request);
    connect(m_fields, &TransformFields::edited, this, [this] { preview(transformOf(m_fields->values(), m_start)); });
    connect(m_fields, &TransformFields::entered, this, [this] { request(transformOf(m_fields->values(), m_start)); });
    connect(m_fields, &TransformFields::axesChosen, this, [this] {
        m_hasTurnedAxes = false;
        showFrame();
    });
    connect(m_fields, &TransformFields::closed, m_action, [this] { m_action->setChecked(false); });
}

bool TransformTool::isOn() const
{
    return m_action->isChecked();
}

void TransformTool::setOn(bool on)
{
    if (on)
        return Q_EMIT regionWanted();
    m_region.reset();
    m_keptFor.reset();
    m_hasTurnedAxes = false;
    m_gizmo->setFrame({});
    m_fields->hide();
    m_viewport->showMoved({});
}

void TransformTool::setBusy(bool isBusy)
{
    if (isBusy)
        m_gizmo->cancelDrag();
    m_gizmo->setEnabled(!isBusy);
}

void TransformTool::refresh()
{
    if (isOn())
        Q_EMIT regionWanted();
}

void TransformTool::dropRequest()
{
    if (!std::exchange(m_isRequested, false))
        return;
    m_keptFor.reset();
    m_region.reset(); // so that the preview ends although the region is as before
    refresh();
}

void TransformTool::setRegion(const core::TransformRegion& region)
{
    if (!isOn())
        return;
    const bool isSame = m_region && isEqual(*m_region, region);
    m_region = region;
    if (m_gizmo->isDragging() || isSame) // numbers that are being typed stay
        return;
    const core::Vec3 middle = region.box.isEmpty() ? core::Vec3(core::Vec3::Zero()) : core::Vec3(region.box.center());
    if (std::exchange(m_isRequested, false))
        m_keptFor = middle;
    if (m_keptFor != middle) {
        m_keptFor.reset();
        m_hasTurnedAxes = false;
        m_start.centre = region.centre;
    }
    m_viewport->showMoved({});
    showFrame();
    m_fields->show();
}

/// Shows the handles about the kept centre, along the chosen axes, and no change.
void TransformTool::showFrame()
{
    if (!m_region)
        return;
    if (!m_hasTurnedAxes)
        m_start.axes = m_fields->usesOwnAxes() ? m_region->axes : Eigen::Quaterniond::Identity();
    m_gizmo->setFrame(m_start);
    m_fields->setValues({});
    m_viewport->showMoved({});
}

void TransformTool::preview(const core::Transform& by)
{
    if (m_region)
        m_viewport->showMoved(by.isNothing() ? nullptr : m_region->vertices, by);
}

/// Requests the change, whose preview stays until the mesh has it.
void TransformTool::request(const core::Transform& by)
{
    if (!m_gizmo->isEnabled())
        return; // numbers stay, to be entered again
    if (!m_region || by.isNothing())
        return showFrame();
    m_viewport->showMoved(m_region->vertices, by, true);
    m_start = moved(m_start, by);
    m_isRequested = true;
    m_fields->setValues({});
    Q_EMIT requested(by);
}
} // namespace ui
