#pragma once

#include <QOpenGLShaderProgram>

#include <Eigen/Core>

#include <memory>
#include <vector>

class QOpenGLExtraFunctions;

namespace vr
{
class Program;

/// A uniform of one program, by its name in the shaders. Set while the program is in use; a name that no shader has is
/// ignored.
class Uniform
{
public:
    Uniform(Program* program, const char* name);
    Uniform(const Uniform&) = delete;
    Uniform& operator=(const Uniform&) = delete;

    void set(int value) const;
    void set(float value) const;
    void set(const Eigen::Vector2f& value) const;
    void set(const Eigen::Vector3f& value) const;
    void set(const Eigen::Vector4f& value) const;
    void set(const Eigen::Matrix3f& value) const;
    void set(const Eigen::Matrix4f& value) const;

private:
    friend class Program;

    const Program* m_program;
    const char* m_name;
    int m_location = -1;
};

/// A QOpenGLShaderProgram of a vertex and a fragment shader of :/shaders, with uniforms of Eigen's types. Derive and
/// give the class its uniforms as members: `Uniform color{this, "color"};`
///
/// Precondition: the context that was current at create(), by Qt too, is current at every call.
class Program
{
public:
    Program() = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// File names without their folder. An input named vertexPosition is attribute 0. False if something does not
    /// compile; the log is in the debug output.
    bool create(QOpenGLExtraFunctions* gl, const char* vertexFile, const char* fragmentFile);
    void destroy();
    void use() const;

private:
    friend class Uniform;

    QOpenGLExtraFunctions* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::vector<Uniform*> m_uniforms;
};
} // namespace vr
