#include "ui/viewport/navigation_cube.h"

#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <utility>

namespace ui
{
namespace
{
using core::Vec3;
using Side = OrbitCamera::Side;

constexpr int extent = 88; ///< width and height of the widget, logical pixels
/// half of the cube's edge, pixels; its corners stay within the widget at any rotation
constexpr double halfEdge = 25;
constexpr double minSlant = 0.15; ///< smallest slant at which a face has a label
constexpr double degreesPerPixel = 1;

/// Axes of a face of the cube, as seen when looking at it.
struct FaceAxes
{
    Side side;
    Vec3 outwards, right, up;
};
const std::array<FaceAxes, 6>& faceAxes()
{
    static const std::array<FaceAxes, 6> axes{{{Side::Front, Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()},
                                               {Side::Back, -Vec3::UnitZ(), -Vec3::UnitX(), Vec3::UnitY()},
                                               {Side::Right, Vec3::UnitX(), -Vec3::UnitZ(), Vec3::UnitY()},
                                               {Side::Left, -Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()},
                                               {Side::Top, Vec3::UnitY(), Vec3::UnitX(), -Vec3::UnitZ()},
                                               {Side::Bottom, -Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()}}};
    return axes;
}

QString nameOf(Side side)
{
    switch (side) {
    case Side::Front:
        return NavigationCube::tr("Front");
    case Side::Back:
        return NavigationCube::tr("Back");
    case Side::Right:
        return NavigationCube::tr("Right");
    case Side::Left:
        return NavigationCube::tr("Left");
    case Side::Top:
        return NavigationCube::tr("Top");
    case Side::Bottom:
        return NavigationCube::tr("Bottom");
    }
    return {};
}
} // namespace

NavigationCube::NavigationCube(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("navigationCube"));
    setMouseTracking(true);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(tr("View cube"));
    setToolTip(tr("Click a face to look from there. Drag to turn the view."));
    place();
    parent->installEventFilter(this);
}

void NavigationCube::showFor(const OrbitCamera& camera)
{
    const Vec3 right = camera.right(), up = camera.up();
    if (right == m_right && up == m_up)
        return;
    m_right = right;
    m_up = up;
    const Vec3 toEye = -camera.viewDirection();
    const auto pixel = [&](const Vec3& p) {
        return QPointF(extent / 2.0 + halfEdge * p.dot(right), extent / 2.0 - halfEdge * p.dot(up));
    };
    m_faces.clear();
    for (const FaceAxes& face : faceAxes()) {
        const double slant = face.outwards.dot(toEye);
        if (slant <= 0)
            continue;
        const Vec3 middle = face.outwards;
        m_faces.push_back({face.side,
                           QPolygonF{pixel(middle - face.right + face.up), pixel(middle + face.right + face.up),
                                     pixel(middle + face.right - face.up), pixel(middle - face.right - face.up)},
                           slant});
    }
    update();
}

void NavigationCube::setLight(bool light)
{
    if (std::exchange(m_light, light) != light)
        update();
}

void NavigationCube::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Face& face : m_faces)
        paint(face, painter);
}

/// Draws a face, with its label projected onto it.
void NavigationCube::paint(const Face& face, QPainter& painter) const
{
    constexpr double flat = 100, most = 84; // side of the face and largest width of its label, before projection
    const bool isHovered = m_hovered == face.side;
    QColor fill = m_light ? QColor(70, 75, 82) : QColor(250, 251, 252);
    fill = m_light ? fill.lighter(100 + static_cast<int>(40 * face.slant))
                   : fill.darker(125 - static_cast<int>(25 * face.slant));
    fill.setAlpha(215);
    if (isHovered)
        fill = palette().color(QPalette::Highlight);
    const QColor ink = isHovered ? palette().color(QPalette::HighlightedText)
                       : m_light ? QColor(240, 242, 245)
                                 : QColor(40, 44, 50);
    QColor line = m_light ? QColor(20, 22, 26) : QColor(90, 96, 104);
    line.setAlpha(180);
    painter.setPen(QPen(line, 1));
    painter.setBrush(fill);
    painter.drawPolygon(face.corners);
    QTransform onFace;
    if (face.slant < minSlant ||
        !QTransform::quadToQuad(QPolygonF{{0, 0}, {flat, 0}, {flat, flat}, {0, flat}}, face.corners, onFace))
        return;
    QPainterPath word;
    QFont large = font();
    large.setPixelSize(30);
    word.addText({0, 0}, large, nameOf(face.side));
    const QRectF box = word.boundingRect();
    const double scale = std::min(1.0, most / box.width());
    painter.save();
    painter.setTransform(onFace, true);
    painter.translate(flat / 2, flat / 2);
    painter.scale(scale, scale);
    painter.translate(-box.center());
    painter.fillPath(word, ink);
    painter.restore();
}

std::optional<Side> NavigationCube::sideAt(const QPointF& point) const
{
    const auto found = std::ranges::find_if(
        m_faces, [&](const Face& face) { return face.corners.containsPoint(point, Qt::OddEvenFill); });
    return found == m_faces.end() ? std::nullopt : std::optional(found->side);
}

void NavigationCube::setHovered(const std::optional<Side>& side)
{
    if (std::exchange(m_hovered, side) != side)
        update();
}

bool NavigationCube::event(QEvent* event)
{
    if (event->type() == QEvent::Enter)
        Q_EMIT entered();
    if (event->type() == QEvent::Leave)
        setHovered({});
    return QWidget::event(event);
}

void NavigationCube::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_pressed = m_last = event->position();
    m_isDragged = false;
}

void NavigationCube::mouseMoveEvent(QMouseEvent* event)
{
    if (!(event->buttons() & Qt::LeftButton))
        return setHovered(sideAt(event->position()));
    m_isDragged = m_isDragged || (event->position() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (!m_isDragged)
        return;
    setHovered({});
    const QPointF by = degreesPerPixel * (event->position() - std::exchange(m_last, event->position()));
    Q_EMIT turned(by.x(), by.y());
}

void NavigationCube::mouseReleaseEvent(QMouseEvent* event)
{
    const std::optional<Side> side = sideAt(event->position());
    if (event->button() == Qt::LeftButton && !m_isDragged && side)
        Q_EMIT sideChosen(*side);
}

bool NavigationCube::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void NavigationCube::place()
{
    setGeometry(parentWidget()->width() - extent - gap / 2, gap / 2, extent, extent);
}
} // namespace ui
