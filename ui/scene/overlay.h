#pragma once

#include "ui/scene/orbit_camera.h"

#include <QMatrix4x4>
#include <QSize>
#include <QString>
#include <QVector2D>
#include <QVector3D>

#include <memory>
#include <variant>
#include <vector>

class QOpenGLContext;

namespace ui
{
/// Triangles that a shader program of resources/shaders draws over the clay, with OpenGL 3.3 core: sRGB colours,
/// blended by their alpha, tested against the clay's depth, which they leave as it is. Contains data only;
/// OverlayRenderer draws it. Thread: gui.
class Overlay
{
public:
    using Value = std::variant<float, QVector2D, QVector3D>;
    struct Uniform
    {
        const char* name;
        Value value;
    };
    /// One attribute of the interleaved vertices.
    struct Attribute
    {
        const char* name;
        int floats;
    };
    /// Pixels that a pass draws: those in front of the clay, or those behind it.
    enum class Depth { InFront, Behind };
    struct Pass
    {
        Depth depth = Depth::InFront;
        std::vector<Uniform> uniforms = {}; ///< those that differ between passes
    };
    /// Constant part of an overlay.
    struct Shape
    {
        QString vertexShader, fragmentShader; ///< file names in resources/shaders, without ".vert" and ".frag"
        std::vector<float> vertices;          ///< three for each triangle
        std::vector<Attribute> attributes;
        std::vector<Pass> passes = {Pass{}}; ///< in the order of drawing
    };

    explicit Overlay(Shape shape) : m_shape(std::move(shape)) {}

    const Shape& shape() const { return m_shape; }
    /// Returns the uniforms of all passes; always the same names in the same order.
    const std::vector<Uniform>& uniforms() const { return m_uniforms; }
    /// Returns the transformation from the overlay's space to the document's, mm.
    const QMatrix4x4& modelMatrix() const { return m_modelMatrix; }

    bool isShown() const { return m_isShown; }
    void setShown(bool shown) { m_isShown = shown; }

protected:
    ~Overlay() = default;

    void setModelMatrix(const QMatrix4x4& matrix) { m_modelMatrix = matrix; }
    /// Sets a uniform. Each has to be set in the constructor.
    void set(const char* name, const Value& value);

private:
    Shape m_shape;
    std::vector<Uniform> m_uniforms;
    QMatrix4x4 m_modelMatrix;
    bool m_isShown = false;
};

/// Draws a list of overlays that is given when it is made, and has the OpenGL context in which everything is drawn.
/// Thread: gui. The overlays must outlive it.
class OverlayRenderer
{
public:
    virtual ~OverlayRenderer() = default;

    /// Returns the context, which shares with QOpenGLContext::globalShareContext(). Never null.
    virtual QOpenGLContext* context() const = 0;
    /// Draws the overlays that are shown into the bound framebuffer. Precondition: the context is current; so it is
    /// afterwards, with the same framebuffer bound. Depth test, culling and blending may have changed.
    virtual void draw(const OrbitCamera& camera, QSize pixels) = 0;
};
} // namespace ui
