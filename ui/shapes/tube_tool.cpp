#include "ui/shapes/tube_tool.h"

#include "ui/actions/actions.h"
#include "ui/model/primitive_messages.h"
#include "ui/settings/brush_settings.h"
#include "ui/shapes/tube_card.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/drawn_curve.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/view_hint.h"

#include "core/operations/mirror_image.h"
#include "core/primitives/model_limits.h"
#include "core/primitives/tube_path.h"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double tolerance = 5; ///< pixels between the drawn curve and the lines between its points
constexpr double minLength = 8; ///< pixels; a shorter curve is begun again
constexpr double minStep = 3;   ///< pixels between points where the curve is held against the model
constexpr double maxSamples = 600;

constexpr double previewFaces = 20'000; ///< about the largest number of triangles of the preview

/// Returns the length of the curve, logical pixels.
double lengthOf(const QPolygonF& curve)
{
    double length = 0;
    for (qsizetype i = 1; i < curve.size(); ++i)
        length += QLineF(curve[i - 1], curve[i]).length();
    return length;
}

/// Returns points on the curve, a step apart.
QPolygonF sampled(const QPolygonF& curve)
{
    const double step = std::max(minStep, lengthOf(curve) / maxSamples);
    QPolygonF samples{curve.front()};
    double ahead = step; // way to the next sample
    for (qsizetype i = 1; i < curve.size(); ++i) {
        QLineF line(curve[i - 1], curve[i]);
        const double length = line.length();
        double way = ahead;
        for (; way < length; way += step)
            samples << line.pointAt(way / length);
        ahead = way - length;
    }
    return samples << curve.back();
}

/// Returns a depth for each ray: of the surface that it meets, else one between those of the nearest rays that do.
std::vector<double> depthsOf(const std::vector<std::optional<core::SurfaceHit>>& hits, const OrbitCamera& camera)
{
    const auto depthOf = [&](const core::Vec3& p) { return (p - camera.eye()).dot(camera.viewDirection()); };
    std::vector<double> depths(hits.size(), depthOf(camera.pivot()));
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i])
            continue;
        depths[i] = depthOf(hits[i]->position);
        for (std::size_t k = last ? *last + 1 : 0; k < i; ++k)
            depths[k] = last ? std::lerp(depths[*last], depths[i], double(k - *last) / double(i - *last)) : depths[i];
        last = i;
    }
    for (std::size_t k = last ? *last + 1 : hits.size(); k < hits.size(); ++k)
        depths[k] = depths[*last];
    return depths;
}

/// Returns the depths as a tube of this radius can follow them: where the curve comes to the model from beside it, the
/// depth changes faster than the tube can bend. Each is a mean of those within a radius. `ways`: along the curve, mm.
std::vector<double> smoothed(const std::vector<double>& depths, const std::vector<double>& ways, double radius)
{
    std::vector<double> result(depths.size());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        double sum = 0, weights = 0;
        const double halfWidth = std::min({radius, ways[i] - ways.front(), ways.back() - ways[i]});
        for (std::size_t k = 0; k < depths.size(); ++k) {
            const double weight = std::max(0.0, halfWidth - std::abs(ways[k] - ways[i]));
            sum += weight * depths[k];
            weights += weight;
        }
        result[i] = weights > 0 ? sum / weights : depths[i];
    }
    return result;
}
} // namespace

TubeTool::TubeTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport)
    : ViewTool(actions.get(QStringLiteral("model.tube")), brush, viewport, "tubeTool")
    , m_card(new TubeCard(viewport))
{
    connect(m_card, &TubeCard::applied, this, &TubeTool::apply);
    connect(m_card, &TubeCard::cancelled, this, &TubeTool::end);
    connect(m_card, &TubeCard::radiusEntered, this, [this](double radius, bool ofAll) {
        for (std::size_t i = 0; i < m_path.size(); ++i) {
            if (ofAll || i == m_chosen)
                m_path[i].radius = radius;
        }
        refresh();
    });
}

void TubeTool::clear()
{
    m_curve.clear();
    m_path.clear();
    m_hot.reset();
    m_dragged.reset();
    m_isDrawing = false;
    m_card->hide();
    viewport()->showTranslucent({});
}

bool TubeTool::handleKey(const QKeyEvent& event)
{
    const bool isRemoval = event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
    const bool isEnd = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (m_path.empty() || !isEnabled() || (!isRemoval && !isEnd))
        return false;
    if (event.type() != QEvent::KeyPress)
        return true;
    if (isEnd) {
        apply();
    } else if (m_path.size() > 2 && !isHeld()) {
        m_path.erase(m_path.begin() + static_cast<std::ptrdiff_t>(m_chosen));
        m_hot.reset();
        m_chosen = std::min(m_chosen, m_path.size() - 1);
        refresh();
    }
    return true;
}

bool TubeTool::handlePointer(const QSinglePointEvent& event)
{
    if (isPress(event))
        return press(event);
    if (event.isUpdateEvent())
        return moveTo(event);
    return event.button() == Qt::LeftButton ? release() : isHeld();
}

bool TubeTool::release()
{
    if (!std::exchange(m_isDrawing, false))
        return std::exchange(m_dragged, std::nullopt).has_value();
    endCurve();
    return true;
}

bool TubeTool::press(const QSinglePointEvent& event)
{
    if (isHeld())
        return true;
    if (event.button() != Qt::LeftButton)
        return false;
    if (m_path.empty()) {
        if (isAsking())
            return true;
        m_isDrawing = true;
        m_curve = QPolygonF({event.position()});
        return true;
    }
    const TubeHandles handles(viewport()->camera(), m_path);
    const std::optional<TubeHandle> handle = handles.handleAt(event.position());
    if (handle) {
        m_dragged = m_hot = handle;
        m_chosen = handle->point;
        viewport()->setFocus();
        refresh();
        return true;
    }
    if (event.type() != QEvent::MouseButtonDblClick)
        return false;
    const auto insertion = handles.insertionAt(event.position());
    if (!insertion || m_path.size() == core::PrimitiveLimits::maxProfile)
        return false;
    m_chosen = insertion->first;
    m_path.insert(m_path.begin() + static_cast<std::ptrdiff_t>(m_chosen), insertion->second);
    refresh();
    return true;
}

bool TubeTool::moveTo(const QSinglePointEvent& event)
{
    if (isHeld() && event.buttons() == Qt::NoButton)
        return release(); // which went to another window
    if (m_isDrawing) {
        m_curve << event.position();
        update();
    } else if (m_dragged) {
        drag(event);
    } else if (event.buttons() == Qt::NoButton && !m_path.empty()) {
        const auto handle = TubeHandles(viewport()->camera(), m_path).handleAt(event.position());
        if (std::exchange(m_hot, handle) != handle) {
            viewport()->setCursor(handle ? Qt::PointingHandCursor : Qt::ArrowCursor);
            update();
        }
    }
    return isHeld();
}

/// Moves the dragged point, or changes its radius; with Shift, all radii by the same factor.
void TubeTool::drag(const QSinglePointEvent& event)
{
    const TubeHandles handles(viewport()->camera(), m_path);
    core::TubePoint& point = m_path[m_dragged->point];
    if (!m_dragged->isRim) {
        point.position = handles.placeAt(event.position(), m_dragged->point);
        if (isAtPlane(point.position))
            point.position[core::axisOf(symmetry())] = 0;
        return refreshSoon();
    }
    const double radius = std::max(handles.radiusAt(event.position(), m_dragged->point), core::ModelLimits::minExtent);
    const double factor = radius / point.radius;
    point.radius = radius;
    for (core::TubePoint& other : m_path) {
        if (event.modifiers() & Qt::ShiftModifier && &other != &point)
            other.radius *= factor;
    }
    refreshSoon();
}

/// Ends the drawn curve, and asks where its points meet the model.
void TubeTool::endCurve()
{
    const QPolygonF curve = sampled(simplified(m_curve, tolerance));
    const bool isLong = lengthOf(m_curve) >= minLength;
    m_curve.clear();
    update();
    if (!isLong)
        return;
    std::vector<core::Ray> rays;
    for (const QPointF& p : curve)
        rays.push_back(viewport()->camera().ray({p.x(), p.y()}));
    ask(rays);
}

void TubeTool::place(const std::vector<core::Ray>& rays, const Hits& hits)
{
    const OrbitCamera& camera = viewport()->camera();
    const double radius = brush()->value(core::Parameter::Radius);
    const auto placeAt = [&](std::size_t i, double depth) -> core::Vec3 {
        const core::Ray& ray = rays[i];
        const core::Vec3 ahead = camera.viewDirection();
        return ray.origin + (depth - (ray.origin - camera.eye()).dot(ahead)) / ray.direction.dot(ahead) * ray.direction;
    };
    const std::vector<double> depths = depthsOf(hits, camera);
    std::vector<double> ways{0}; // along the curve as it is seen, mm
    for (std::size_t i = 1; i < rays.size(); ++i)
        ways.push_back(ways.back() + (placeAt(i, depths[i]) - placeAt(i - 1, depths[i])).norm());
    const std::vector<double> followed = smoothed(depths, ways, radius);
    std::vector<core::TubePoint> drawn;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        drawn.push_back({placeAt(i, followed[i]), radius});
        if (isAtPlane(drawn.back().position))
            drawn.back().position[core::axisOf(symmetry())] = 0;
    }
    m_path = core::thinnedPath(drawn, std::min(tolerance / camera.pixelsPerMm(drawn.front().position), radius / 2));
    m_chosen = 0;
    viewport()->setCursor(Qt::ArrowCursor);
    refresh();
}

core::Primitive TubeTool::primitive() const
{
    core::Primitive tube;
    tube.kind = core::Primitive::Kind::Tube;
    tube.path = m_path;
    return tube;
}

/// Shows the path, what the tube will be, and the hint.
void TubeTool::refresh()
{
    if (!m_path.empty()) {
        const core::PrimitiveResult judged = core::judgePrimitive(primitive());
        if (judged.fault == core::PrimitiveFault::None)
            showTranslucent(
                core::Tube(m_path, judged.limit * std::sqrt(std::max(1.0, judged.faces / previewFaces))).swept());
        else
            showTranslucent({});
        m_card->show(m_path[m_chosen].radius, PrimitiveMessages::problem(judged));
    }
    hint()->showText(m_path.empty() ? tr("Draw the middle of a tube, on the model or beside it. Esc cancels.")
                                    : tr("Drag a point or its circle; with Shift all circles. A double click on the "
                                         "line adds a point, Delete removes one."),
                     width());
    m_card->raise();
    update();
}

void TubeTool::apply()
{
    if (m_path.empty() || !isEnabled() || core::judgePrimitive(primitive()).fault != core::PrimitiveFault::None)
        return;
    core::Insert insert;
    insert.primitive = primitive();
    insert.place = core::Insert::Place::AsItIs;
    insert.combination = m_card->combination();
    insert.symmetry = symmetry();
    if (insert.combination == core::Insert::Combination::Part)
        insert.name = PrimitiveMessages::kind(core::Primitive::Kind::Tube).toStdString();
    m_card->storeCombination();
    request(insert);
}

void TubeTool::paintEvent(QPaintEvent* event)
{
    ViewTool::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_curve.size() > 1) {
        QPainterPath path;
        path.addPolygon(m_curve);
        painter.strokePath(path, QPen(QColor(0, 0, 0, 110), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.strokePath(path, QPen(QColor(255, 246, 232), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
    TubeHandles(viewport()->camera(), m_path).paint(painter, m_chosen, m_hot);
}
} // namespace ui
