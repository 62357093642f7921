#include "vr/gl/gl_program.h"

#include <QOpenGLExtraFunctions>

namespace vr
{
Uniform::Uniform(Program* program, const char* name) : m_program(program), m_name(name)
{
    program->m_uniforms.push_back(this);
}

void Uniform::set(int value) const
{
    m_program->m_gl->glUniform1i(m_location, value);
}

void Uniform::set(float value) const
{
    m_program->m_gl->glUniform1f(m_location, value);
}

void Uniform::set(const Eigen::Vector2f& value) const
{
    m_program->m_gl->glUniform2fv(m_location, 1, value.data());
}

void Uniform::set(const Eigen::Vector3f& value) const
{
    m_program->m_gl->glUniform3fv(m_location, 1, value.data());
}

void Uniform::set(const Eigen::Vector4f& value) const
{
    m_program->m_gl->glUniform4fv(m_location, 1, value.data());
}

void Uniform::set(const Eigen::Matrix3f& value) const
{
    m_program->m_gl->glUniformMatrix3fv(m_location, 1, GL_FALSE, value.data());
}

void Uniform::set(const Eigen::Matrix4f& value) const
{
    m_program->m_gl->glUniformMatrix4fv(m_location, 1, GL_FALSE, value.data());
}

bool Program::create(QOpenGLExtraFunctions* gl, const char* vertexFile, const char* fragmentFile)
{
    const QString folder = QStringLiteral(":/shaders/");
    m_gl = gl;
    m_program = std::make_unique<QOpenGLShaderProgram>();
    const auto add = [&](QOpenGLShader::ShaderType stage, const char* file) {
        return m_program->addShaderFromSourceFile(stage, folder + QLatin1StringView(file));
    };
    // Qt skips a shader that does not compile, and a program with only the other shader may still link.
    const bool hasVertex = add(QOpenGLShader::Vertex, vertexFile);
    const bool hasFragment = add(QOpenGLShader::Fragment, fragmentFile);
    m_program->bindAttributeLocation("vertexPosition", 0);
    const bool isLinked = hasVertex && hasFragment && m_program->link();
    for (Uniform* uniform : m_uniforms)
        uniform->m_location = m_program->uniformLocation(uniform->m_name);
    return isLinked;
}

void Program::destroy()
{
    m_program.reset();
    m_gl = nullptr;
}

void Program::use() const
{
    m_program->bind();
}
} // namespace vr
