#include "ui/shapes/solid_tool.h"

#include "ui/actions/actions.h"
#include "ui/model/primitive_messages.h"
#include "ui/shapes/solid_card.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/view_hint.h"

#include "core/operations/mirror_image.h"

#include <QKeyEvent>
#include <QLineF>

#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr double minDrag = 4;           ///< pixels; a shorter drag makes a solid of the usual size
constexpr double usualShare = 1.0 / 16; ///< half size of a solid that was not dragged, as a share of the view's height

constexpr double around = 12; ///< pixels from the press within which the surface's direction is measured
constexpr int aroundRays = 8;

constexpr double maxPreviewFaces = 200'000; ///< number of triangles; a larger solid is not shown while it changes

/// Returns the mean of the surface's normals, so that a solid does not follow each triangle.
core::Vec3 meanNormal(const ViewTool::Hits& hits)
{
    core::Vec3 sum = core::Vec3::Zero();
    for (const auto& hit : hits) {
        if (hit && hit->normal.dot(hits.front()->normal) > 0.5) // of the same side, not of something behind it
            sum += hit->normal;
    }
    return sum.norm() > 0.1 ? sum.normalized() : hits.front()->normal;
}
} // namespace

SolidTool::SolidTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport)
    : ViewTool(actions.get(QStringLiteral("model.placeSolid")), brush, viewport, "solidTool")
    , m_card(new SolidCard(viewport))
{
    connect(m_card, &SolidCard::applied, this, &SolidTool::apply);
    connect(m_card, &SolidCard::cancelled, this, &SolidTool::end);
    connect(m_card, &SolidCard::edited, this, &SolidTool::refresh);
}

void SolidTool::clear()
{
    m_isPressed = m_isPlaced = false;
    m_card->hide();
    viewport()->showTranslucent({});
}

bool SolidTool::handleKey(const QKeyEvent& event)
{
    if (!m_isPlaced || (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter))
        return false;
    if (event.type() == QEvent::KeyPress)
        apply();
    return true;
}

bool SolidTool::handlePointer(const QSinglePointEvent& event)
{
    if (m_isPressed) {
        m_pointer = event.position();
        if (!(event.buttons() & Qt::LeftButton)) // also if the release went to another window
            m_isPressed = false;
        if (m_isPlaced) {
            resize();
            refreshSoon();
        }
        return true;
    }
    if (m_isPlaced || !isPress(event) || event.button() != Qt::LeftButton || isAsking())
        return false;
    m_isPressed = true;
    m_from = m_pointer = event.position();
    std::vector<core::Ray> rays{viewport()->camera().ray({m_from.x(), m_from.y()})};
    for (int i = 0; i < aroundRays; ++i) {
        const double angle = 2 * std::numbers::pi * i / aroundRays;
        rays.push_back(
            viewport()->camera().ray({m_from.x() + around * std::cos(angle), m_from.y() + around * std::sin(angle)}));
    }
    ask(rays);
    return true;
}

/// Returns where the ray meets the ground under the model, or, if it does not, the plane through the view's pivot.
core::SurfaceHit SolidTool::groundAt(const core::Ray& ray) const
{
    const core::Box& box = viewport()->navigation()->box();
    const double height = box.isEmpty() ? 0 : box.min().y();
    const double way = (height - ray.origin.y()) / ray.direction.y();
    const double farthest = 4 * (viewport()->camera().distance() + (box.isEmpty() ? 0 : box.diagonal().norm()));
    const bool isMet = ray.direction.y() < 0 && way > 0 && way < farthest;
    return {isMet ? core::Vec3(ray.origin + way * ray.direction) : viewport()->camera().acrossPivot(ray),
            core::Vec3::UnitY(), 0, 0};
}

void SolidTool::place(const std::vector<core::Ray>& rays, const Hits& hits)
{
    core::SurfaceHit base = hits.front().value_or(groundAt(rays.front()));
    if (hits.front())
        base.normal = meanNormal(hits);
    if (isAtPlane(base.position))
        core::putOnPlane(base.position, base.normal, symmetry());
    m_isPlaced = true;
    viewport()->setCursor(Qt::ArrowCursor);
    m_card->setSize(1);
    m_card->putOn(base.position, base.normal.normalized());
    resize();
    refresh();
}

core::Insert SolidTool::insertion() const
{
    core::Insert insertion = m_card->insertion();
    insertion.symmetry = symmetry();
    return insertion;
}

/// Gives the solid the size that the drag says.
void SolidTool::resize()
{
    const OrbitCamera& camera = viewport()->camera();
    const double dragged = QLineF(m_from, m_pointer).length();
    const double pixels = dragged < minDrag ? usualShare * viewport()->height() : dragged;
    m_card->setSize(pixels / camera.pixelsPerMm(m_card->insertion().centre));
    m_card->keepBase();
}

/// Shows the numbers, what the solid will be, and the hint.
void SolidTool::refresh()
{
    hint()->showText(m_isPlaced ? tr("Change the numbers, then apply (Return). Esc cancels.")
                                : tr("Press on the model or the ground, and drag to the size. Esc cancels."),
                     width());
    if (!m_isPlaced)
        return;
    core::Primitive solid = *m_card->insertion().primitive;
    const core::PrimitiveResult judged = core::judgePrimitive(solid);
    solid.edge = judged.limit;
    core::TriangleMesh translucent;
    if (judged.fault == core::PrimitiveFault::None && judged.faces < maxPreviewFaces)
        translucent = core::makePrimitive(solid).mesh.value_or(core::TriangleMesh());
    for (core::Vec3f& p : translucent.points)
        p = (p.cast<double>() + m_card->insertion().centre).cast<float>();
    showTranslucent(std::move(translucent));
    m_card->show(PrimitiveMessages::problem(judged));
    m_card->raise();
}

void SolidTool::apply()
{
    const core::Insert solid = insertion();
    if (!isEnabled() || core::judgePrimitive(*solid.primitive).fault != core::PrimitiveFault::None)
        return;
    m_card->storeCombination();
    request(solid);
}
} // namespace ui
