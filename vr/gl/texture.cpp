#include "vr/gl/texture.h"

#include <QImage>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <algorithm>

namespace vr
{
namespace
{
// Enumerators of GL_EXT_texture_filter_anisotropic.
constexpr unsigned int anisotropyName = 0x84FE, maxAnisotropyName = 0x84FF;
/// Maximum anisotropy of the filter; above 1 because panels are often seen at a slant.
constexpr float wantedAnisotropy = 8;
constexpr float sharper = -0.4F; ///< LOD bias in mip levels: keeps the edges of text sharp without shimmering

void setFilters(QOpenGLExtraFunctions* gl)
{
    gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, sharper);
    if (!QOpenGLContext::currentContext()->hasExtension("GL_EXT_texture_filter_anisotropic"))
        return;
    float maxAnisotropy = 1;
    gl->glGetFloatv(maxAnisotropyName, &maxAnisotropy);
    gl->glTexParameterf(GL_TEXTURE_2D, anisotropyName, std::min(maxAnisotropy, wantedAnisotropy));
}
} // namespace

void Texture::create(QOpenGLExtraFunctions* gl)
{
    m_gl = gl;
    m_gl->glGenTextures(1, &m_id);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_id);
    setFilters(gl);
    m_gl->glBindTexture(GL_TEXTURE_2D, 0);
}

void Texture::destroy()
{
    if (m_gl)
        m_gl->glDeleteTextures(1, &m_id);
    *this = {};
}

void Texture::upload(const QImage& picture)
{
    const QImage bytes = picture.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
    const int width = bytes.width(), height = bytes.height();
    m_gl->glBindTexture(GL_TEXTURE_2D, m_id);
    if (bytes.size() == m_size)
        m_gl->glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.constBits());
    else
        m_gl->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.constBits());
    m_gl->glGenerateMipmap(GL_TEXTURE_2D);
    m_gl->glBindTexture(GL_TEXTURE_2D, 0);
    m_size = bytes.size();
}
} // namespace vr
