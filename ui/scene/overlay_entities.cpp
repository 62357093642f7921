#include "ui/scene/overlay_entities.h"

#include "ui/scene/gl_convert.h"

#include "core/stroke/symmetry_plane.h"

#include <QSize>
#include <QUrl>
#include <QVector2D>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

#include <cmath>
#include <numbers>
#include <vector>

namespace ui
{
namespace
{
using Qt3DRender::QParameter;

constexpr double ringHalfWidth = 2.4;   ///< logical pixels, including the dark edges
constexpr double planeBorder = 1.2;     ///< width of the pane's border, logical pixels
constexpr double sectorHalfWidth = 0.7; ///< half of a line's width, logical pixels
/// length of the lines as a multiple of the model's largest distance from the vertical axis
constexpr double bordersReach = 1.5;

/// One attribute of an interleaved array of floats.
struct Field
{
    const char* name;
    unsigned int floats;
};

Qt3DRender::QGeometryRenderer* triangles(const std::vector<float>& values, std::initializer_list<Field> fields)
{
    unsigned int perVertex = 0;
    for (const Field& field : fields)
        perVertex += field.floats;
    auto* geometry = new Qt3DCore::QGeometry;
    auto* buffer = new Qt3DCore::QBuffer(geometry);
    buffer->setData(QByteArray(reinterpret_cast<const char*>(values.data()),
                               static_cast<qsizetype>(values.size() * sizeof(float))));
    unsigned int offset = 0;
    const auto count = static_cast<unsigned int>(values.size()) / perVertex;
    for (const Field& field : fields) {
        geometry->addAttribute(new Qt3DCore::QAttribute(
            buffer, QLatin1StringView(field.name), Qt3DCore::QAttribute::Float, field.floats, count,
            offset * static_cast<unsigned int>(sizeof(float)), perVertex * static_cast<unsigned int>(sizeof(float))));
        offset += field.floats;
    }
    auto* renderer = new Qt3DRender::QGeometryRenderer;
    renderer->setGeometry(geometry);
    renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    return renderer;
}

Qt3DRender::QRenderPass* blendedPass(Qt3DRender::QShaderProgram* program, Qt3DRender::QDepthTest::DepthFunction depth)
{
    using Arguments = Qt3DRender::QBlendEquationArguments;
    auto* pass = new Qt3DRender::QRenderPass;
    pass->setShaderProgram(program);
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(depth);
    auto* factors = new Arguments;
    factors->setSourceRgb(Arguments::SourceAlpha);
    factors->setDestinationRgb(Arguments::OneMinusSourceAlpha);
    factors->setSourceAlpha(Arguments::One);
    factors->setDestinationAlpha(Arguments::OneMinusSourceAlpha);
    auto* equation = new Qt3DRender::QBlendEquation;
    equation->setBlendFunction(Qt3DRender::QBlendEquation::Add);
    auto* cull = new Qt3DRender::QCullFace;
    cull->setMode(Qt3DRender::QCullFace::NoCulling);
    for (Qt3DRender::QRenderState* state :
         std::initializer_list<Qt3DRender::QRenderState*>{test, factors, equation, cull, new Qt3DRender::QNoDepthMask})
        pass->addRenderState(state);
    return pass;
}

Qt3DRender::QShaderProgram* program(const QString& vertex, const QString& fragment)
{
    auto* made = new Qt3DRender::QShaderProgram;
    const QString url = QStringLiteral("qrc:/shaders/%1.%2");
    made->setVertexShaderCode(Qt3DRender::QShaderProgram::loadSource(QUrl(url.arg(vertex, QStringLiteral("vert")))));
    made->setFragmentShaderCode(
        Qt3DRender::QShaderProgram::loadSource(QUrl(url.arg(fragment, QStringLiteral("frag")))));
    return made;
}

Qt3DRender::QShaderProgram* program(const QString& name)
{
    return program(name, name);
}

Qt3DRender::QMaterial* material(std::initializer_list<Qt3DRender::QRenderPass*> passes)
{
    auto* technique = new Qt3DRender::QTechnique;
    technique->graphicsApiFilter()->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    technique->graphicsApiFilter()->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    technique->graphicsApiFilter()->setMajorVersion(3);
    technique->graphicsApiFilter()->setMinorVersion(3);
    for (Qt3DRender::QRenderPass* pass : passes)
        technique->addRenderPass(pass);
    auto* effect = new Qt3DRender::QEffect;
    effect->addTechnique(technique);
    auto* made = new Qt3DRender::QMaterial;
    made->setEffect(effect);
    return made;
}

QParameter* parameter(Qt3DRender::QMaterial* to, const char* name, const QVariant& value)
{
    auto* made = new QParameter(QLatin1StringView(name), value);
    to->addParameter(made);
    return made;
}

/// Appends two triangles for the segment a to b, in the format of cursor.vert; `afterB` gives the ribbon's direction at
/// b.
void appendSegment(std::vector<float>& out, const QVector3D& a, const QVector3D& b, const QVector3D& afterB)
{
    const auto corner = [&](const QVector3D& at, const QVector3D& next, float side) {
        out.insert(out.end(), {at.x(), at.y(), at.z(), next.x(), next.y(), next.z(), side});
    };
    corner(a, b, -1);
    corner(a, b, 1);
    corner(b, afterB, 1);
    corner(a, b, -1);
    corner(b, afterB, 1);
    corner(b, afterB, -1);
}

/// Returns a ring of radius 1 about Z, and a tick of length 0.3 along Z.
std::vector<float> ringAndTick()
{
    constexpr int segments = 96;
    const auto at = [](int i) {
        const double angle = 2 * std::numbers::pi * i / segments;
        return QVector3D(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
    };
    std::vector<float> out;
    for (int i = 0; i < segments; ++i)
        appendSegment(out, at(i), at(i + 1), at(i + 2));
    appendSegment(out, {0, 0, 0}, {0, 0, 0.3F}, {0, 0, 0.6F});
    return out;
}

/// Returns the colour of symmetry planes and sector borders on a dark or light background.
QVector3D symmetryColor(bool dark)
{
    return dark ? QVector3D(0.60F, 0.80F, 1.0F) : QVector3D(0.12F, 0.36F, 0.62F);
}

/// Returns the cell size of the grid, mm: 3 to 30 cells span a model of this size.
double gridCell(double size)
{
    return std::pow(10.0, std::floor(std::log10(size / 3)));
}
} // namespace

Ground::Ground(Qt3DCore::QNode* parent) : Qt3DCore::QEntity(parent), m_transform(new Qt3DCore::QTransform)
{
    auto* surfaceMaterial =
        material({blendedPass(program(QStringLiteral("ground")), Qt3DRender::QDepthTest::LessOrEqual)});
    m_cell = parameter(surfaceMaterial, "cell", 10.0F);
    m_center = parameter(surfaceMaterial, "center", QVector3D());
    m_under = parameter(surfaceMaterial, "under", QVector3D());
    m_reach = parameter(surfaceMaterial, "reach", 400.0F);
    m_footprint = parameter(surfaceMaterial, "footprint", QVector2D(50, 50));
    m_lineColor = parameter(surfaceMaterial, "lineColor", QVector3D());
    m_lineAlpha = parameter(surfaceMaterial, "lineAlpha", 0.3F);
    m_shade = parameter(surfaceMaterial, "shade", 0.2F);
    addComponent(triangles({-1, 0, -1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0, -1}, {{"vertexPosition", 3}}));
    addComponent(m_transform);
    addComponent(surfaceMaterial);
    setDark(false);
}

void Ground::place(const core::Box& box)
{
    constexpr double below =
        5e-4; // fraction of the box's diagonal: in the plane of a flat base, some pixels of the lines would be hidden
    const core::Vec3 center(box.center().x(), box.min().y() - below * box.diagonal().norm(), box.center().z());
    const auto reach = static_cast<float>(2.2 * box.diagonal().norm());
    const core::Vec3 half = 0.5 * box.sizes();
    m_transform->setTranslation(toQt(center));
    m_transform->setScale(reach);
    m_cell->setValue(static_cast<float>(gridCell(box.sizes().maxCoeff())));
    m_center->setValue(toQt(center));
    m_under->setValue(toQt(center));
    m_reach->setValue(reach);
    m_footprint->setValue(QVector2D(static_cast<float>(half.x()), static_cast<float>(half.z())));
}

void Ground::setDark(bool dark)
{
    m_lineColor->setValue(dark ? QVector3D(0.75F, 0.78F, 0.82F) : QVector3D(0.22F, 0.25F, 0.29F));
    m_lineAlpha->setValue(dark ? 0.22F : 0.30F);
    m_shade->setValue(dark ? 0.45F : 0.28F);
}

BrushCursor::BrushCursor(Qt3DCore::QNode* parent) : Qt3DCore::QEntity(parent), m_transform(new Qt3DCore::QTransform)
{
    auto* shader = program(QStringLiteral("cursor"));
    auto* seen = blendedPass(shader, Qt3DRender::QDepthTest::LessOrEqual);
    seen->addParameter(new QParameter(QStringLiteral("alpha"), 0.95F));
    auto* hidden = blendedPass(shader, Qt3DRender::QDepthTest::Greater);
    hidden->addParameter(new QParameter(QStringLiteral("alpha"), 0.22F));
    auto* surfaceMaterial = material({hidden, seen});
    m_viewport = parameter(surfaceMaterial, "viewport", QVector2D(1, 1));
    m_halfWidth = parameter(surfaceMaterial, "halfWidth", static_cast<float>(ringHalfWidth));
    m_color = parameter(surfaceMaterial, "color", QVector3D(1, 1, 1));
    addComponent(triangles(ringAndTick(), {{"vertexPosition", 3}, {"vertexNext", 3}, {"vertexSide", 1}}));
    addComponent(m_transform);
    addComponent(surfaceMaterial);
}

void BrushCursor::place(const core::Vec3& position, const core::Vec3& normal, double radius)
{
    m_transform->setTranslation(toQt(position));
    m_transform->setRotation(QQuaternion::rotationTo({0, 0, 1}, toQt(normal)));
    m_transform->setScale(static_cast<float>(radius));
}

void BrushCursor::setColor(const QColor& color)
{
    m_color->setValue(toQt(color));
}

void BrushCursor::setPixels(QSize target, double ratio)
{
    m_viewport->setValue(QVector2D(static_cast<float>(target.width()), static_cast<float>(target.height())));
    m_halfWidth->setValue(static_cast<float>(ringHalfWidth * ratio));
}

SymmetryPlane::SymmetryPlane(Qt3DCore::QNode* parent) : Qt3DCore::QEntity(parent), m_transform(new Qt3DCore::QTransform)
{
    auto* surfaceMaterial =
        material({blendedPass(program(QStringLiteral("plane")), Qt3DRender::QDepthTest::LessOrEqual)});
    m_color = parameter(surfaceMaterial, "color", QVector3D());
    m_border = parameter(surfaceMaterial, "border", static_cast<float>(planeBorder));
    addComponent(triangles({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0}, {{"vertexPosition", 3}}));
    addComponent(m_transform);
    addComponent(surfaceMaterial);
    setDark(false);
}

void SymmetryPlane::place(core::Symmetry symmetry, const core::Box& box)
{
    const core::SymmetryPlane pane = core::symmetryPlane(symmetry, box);
    const core::Vec3 x = pane.halfX.normalized(), y = pane.halfY.normalized();
    m_transform->setTranslation(toQt(pane.center));
    m_transform->setRotation(QQuaternion::fromAxes(toQt(x), toQt(y), toQt(core::planeNormal(symmetry))));
    m_transform->setScale3D({static_cast<float>(pane.halfX.norm()), static_cast<float>(pane.halfY.norm()), 1});
}

void SymmetryPlane::setDark(bool dark)
{
    m_color->setValue(symmetryColor(dark));
}

void SymmetryPlane::setPixelRatio(double ratio)
{
    m_border->setValue(static_cast<float>(planeBorder * ratio));
}

SectorBorders::SectorBorders(Qt3DCore::QNode* parent) : Qt3DCore::QEntity(parent), m_transform(new Qt3DCore::QTransform)
{
    auto* surfaceMaterial = material({blendedPass(program(QStringLiteral("plane"), QStringLiteral("sectors")),
                                                  Qt3DRender::QDepthTest::LessOrEqual)});
    m_color = parameter(surfaceMaterial, "color", QVector3D());
    m_border = parameter(surfaceMaterial, "border", static_cast<float>(sectorHalfWidth));
    m_sectors = parameter(surfaceMaterial, "sectors", 2.0F);
    addComponent(triangles({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0}, {{"vertexPosition", 3}}));
    addComponent(m_transform);
    addComponent(surfaceMaterial);
    setDark(false);
}

/// Places the lines. The first one extends from the vertical axis along +X if z = 0 is the plane of symmetry, else
/// along +Z.
void SectorBorders::place(int sectors, core::Symmetry symmetry, const core::Box& box)
{
    const core::Vec3 first = symmetry == core::Symmetry::Z ? core::Vec3::UnitX() : core::Vec3::UnitZ();
    const core::Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
    m_transform->setTranslation({0, static_cast<float>(box.min().y()), 0});
    m_transform->setRotation(QQuaternion::fromAxes(toQt(first), toQt(core::Vec3::UnitY().cross(first)), {0, 1, 0}));
    m_transform->setScale(static_cast<float>(bordersReach * std::hypot(farthest.x(), farthest.z())));
    m_sectors->setValue(static_cast<float>(sectors));
}

void SectorBorders::setDark(bool dark)
{
    m_color->setValue(symmetryColor(dark));
}

void SectorBorders::setPixelRatio(double ratio)
{
    m_border->setValue(static_cast<float>(sectorHalfWidth * ratio));
}
} // namespace ui
