#include "ui/shapes/solid_tool.h"

#include "ui/actions/actions.h"
#include "ui/model/primitive_messages.h"
#include "ui/shapes/solid_card.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/view_hint.h"

#include "core/mesh/draw_arrays.h"

#include <QKeyEvent>
#include <QLineF>

namespace ui
{
namespace
{
constexpr double leastDrag = 4;         ///< pixels; a shorter drag makes a solid of the usual size
constexpr double usualShare = 1.0 / 16; ///< half size of a solid that was not dragged, as a share of the view's height

constexpr double mostGlass = 200'000; ///< number of triangles; a larger solid is not shown while it changes

/// Returns the solid as glass where the insertion puts it.
std::shared_ptr<const core::DrawArrays> glassOf(const core::Insert& insertion, double edge)
{
    core::Primitive solid = *insertion.primitive;
    solid.edge = edge;
    core::PrimitiveResult made = core::makePrimitive(solid);
    if (!made.mesh)
        return {};
    for (core::Vec3f& p : made.mesh->points)
        p = (p.cast<double>() + insertion.centre).cast<float>();
    return std::make_shared<const core::DrawArrays>(core::drawArraysOf(*made.mesh));
}
} // namespace

SolidTool::SolidTool(const Actions& actions, Viewport* viewport)
    : ViewTool(actions.get(QStringLiteral("model.placeSolid")), viewport, "solidTool")
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
    viewport()->showGlass({});
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
        if (m_isPlaced)
            resize();
        return true;
    }
    if (m_isPlaced || !isPress(event) || event.button() != Qt::LeftButton || isAsking())
        return false;
    m_isPressed = true;
    m_from = m_pointer = event.position();
    ask({viewport()->camera().ray({m_from.x(), m_from.y()})});
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
    const core::SurfaceHit base = hits.front().value_or(groundAt(rays.front()));
    m_isPlaced = true;
    viewport()->setCursor(Qt::ArrowCursor);
    m_card->setSize(1);
    m_card->putOn(base.position, base.normal);
    resize();
}

/// Gives the solid the size that the drag says.
void SolidTool::resize()
{
    const core::Insert insertion = m_card->insertion();
    const OrbitCamera& camera = viewport()->camera();
    const double dragged = QLineF(m_from, m_pointer).length();
    const double pixels = dragged < leastDrag ? usualShare * viewport()->height() : dragged;
    m_card->setSize(pixels / camera.pixelsPerMm(insertion.centre));
    m_card->keepBase();
    refresh();
}

/// Shows the numbers, what the solid will be, and the hint.
void SolidTool::refresh()
{
    hint()->showText(m_isPlaced ? tr("Change the numbers, then apply (Return). Esc cancels.")
                                : tr("Press on the model or the ground, and drag to the size. Esc cancels."),
                     width());
    if (!m_isPlaced)
        return;
    const core::Insert insertion = m_card->insertion();
    const core::PrimitiveResult judged = core::judgePrimitive(*insertion.primitive);
    viewport()->showGlass(judged.fault == core::PrimitiveFault::None && judged.faces < mostGlass
                              ? glassOf(insertion, judged.limit)
                              : nullptr);
    m_card->show(PrimitiveMessages::problem(judged));
    m_card->raise();
}

void SolidTool::apply()
{
    const core::Insert insertion = m_card->insertion();
    if (!isEnabled() || core::judgePrimitive(*insertion.primitive).fault != core::PrimitiveFault::None)
        return;
    m_card->storeCombination();
    request(insertion);
}
} // namespace ui
