#include "vr/gl/gl_program.h"

#include <QDebug>
#include <QFile>
#include <QOpenGLExtraFunctions>

namespace vr
{
namespace
{
QByteArray sourceOf(const char* fileName)
{
    QFile file(QStringLiteral(":/shaders/") + QLatin1StringView(fileName));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void attachCompiled(QOpenGLExtraFunctions* gl, unsigned int program, unsigned int stage, const char* fileName)
{
    const QByteArray source = sourceOf(fileName);
    const char* text = source.constData();
    const unsigned int shader = gl->glCreateShader(stage);
    gl->glShaderSource(shader, 1, &text, nullptr);
    gl->glCompileShader(shader);
    GLint compiled = GL_FALSE;
    gl->glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        QByteArray log(4096, '\0');
        gl->glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        qWarning() << fileName << log.constData();
    }
    gl->glAttachShader(program, shader);
    gl->glDeleteShader(shader); // as soon as the program goes
}
} // namespace

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
    m_gl = gl;
    m_id = gl->glCreateProgram();
    attachCompiled(gl, m_id, GL_VERTEX_SHADER, vertexFile);
    attachCompiled(gl, m_id, GL_FRAGMENT_SHADER, fragmentFile);
    gl->glBindAttribLocation(m_id, 0, "vertexPosition");
    gl->glLinkProgram(m_id);
    GLint linked = GL_FALSE;
    gl->glGetProgramiv(m_id, GL_LINK_STATUS, &linked);
    for (Uniform* uniform : m_uniforms)
        uniform->m_location = gl->glGetUniformLocation(m_id, uniform->m_name);
    return linked != GL_FALSE;
}

void Program::destroy()
{
    if (m_gl)
        m_gl->glDeleteProgram(m_id);
    m_gl = nullptr;
    m_id = 0;
}

void Program::use() const
{
    m_gl->glUseProgram(m_id);
}
} // namespace vr
