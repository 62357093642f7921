#pragma once

#include <QOpenGLShaderProgram>

#include <Eigen/Core>

#include <memory>
#include <vector>

class QOpenGLExtraFunctions;

namespace vr
{
class Program;

/// A uniform variable of one program, found by its name in the shaders. A name that no shader has is ignored.
/// Precondition of set(): the program is in use.
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

/// A vertex and a fragment shader from :/shaders, linked by QOpenGLShaderProgram, with uniforms of Eigen's types. A
/// derived class declares its uniforms as members: `Uniform color{this, "color"};`
///
/// Precondition: the context of create() is current at every call, and Qt considers it current.
class Program
{
public:
    Program() = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Compiles and links two shader files, named without their folder. An input named vertexPosition becomes attribute
    /// 0. Returns false if compiling or linking fails; the log is in the debug output.
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
