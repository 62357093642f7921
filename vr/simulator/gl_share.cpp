#include "vr/simulator/gl_share.h"

#include <qopengl.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace simulator
{
namespace
{
std::uint8_t encoded(std::uint8_t linear)
{
    static const auto table = [] {
        std::array<std::uint8_t, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double value = static_cast<double>(i) / 255;
            const double srgb = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
            made[i] = static_cast<std::uint8_t>(std::lround(srgb * 255));
        }
        return made;
    }();
    return table[linear];
}

GLenum targetOf(const TextureForm& form)
{
    return form.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

/// Returns an OpenGL function found at run time. Linking by name is impossible: clients have variables of that name.
template <class Function> Function glFunction(const char* name)
{
    return reinterpret_cast<Function>(glFunctionAddress(name));
}

/// Allocates the memory of the bound texture.
void allocate(const TextureForm& form)
{
    const auto format = static_cast<GLenum>(form.format);
    if (form.layers > 1)
        glFunction<PFNGLTEXSTORAGE3DPROC>("glTexStorage3D")(targetOf(form), form.levels, format, form.width,
                                                            form.height, form.layers);
    else
        glFunction<PFNGLTEXSTORAGE2DPROC>("glTexStorage2D")(targetOf(form), form.levels, format, form.width,
                                                            form.height);
}

/// Reads the bound depth texture: red, green and blue contain the 24 bits of each depth.
void readDepth(const TextureForm& form, std::vector<std::uint8_t>& pixels)
{
    constexpr double deepest = (1 << 24) - 1;
    std::vector<float> depths(pixels.size() / 4);
    glGetTexImage(targetOf(form), 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto bits = static_cast<std::uint32_t>(std::lround(deepest * depths[i]));
        pixels[4 * i] = static_cast<std::uint8_t>(bits >> 16);
        pixels[4 * i + 1] = static_cast<std::uint8_t>(bits >> 8 & 0xFF);
        pixels[4 * i + 2] = static_cast<std::uint8_t>(bits & 0xFF);
        pixels[4 * i + 3] = 255;
    }
}

/// Returns a part of one layer's pixels, turned so that the top row is first.
Picture cut(const TexturePart& part, const std::uint8_t* layer)
{
    Picture picture{part.width, part.height, {}};
    picture.rgba.reserve(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height) * 4);
    for (int y = part.y + part.height - 1; y >= part.y; --y) {
        const std::uint8_t* row = layer + (static_cast<std::ptrdiff_t>(y) * part.form.width + part.x) * 4;
        picture.rgba.insert(picture.rgba.end(), row, row + static_cast<std::ptrdiff_t>(part.width) * 4);
    }
    return picture;
}
} // namespace

ShareContext::ShareContext(const GlClient& client) : m_client(client), m_context(createSharingContext(client)) {}

ShareContext::~ShareContext()
{
    destroyContext(m_client, m_context);
}

const std::vector<std::int64_t>& ShareContext::formats()
{
    static const std::vector<std::int64_t> all{GL_SRGB8_ALPHA8, GL_RGBA16F, GL_RGBA8, GL_DEPTH_COMPONENT32F,
                                               GL_DEPTH_COMPONENT24};
    return all;
}

bool ShareContext::isDepth(std::int64_t format)
{
    return format == GL_DEPTH_COMPONENT32F || format == GL_DEPTH_COMPONENT24;
}

std::vector<unsigned int> ShareContext::createTextures(const TextureForm& form, std::size_t count) const
{
    const CurrentContext current(m_client, m_context);
    std::vector<unsigned int> textures(count);
    glGenTextures(static_cast<GLsizei>(count), textures.data());
    for (const unsigned int texture : textures) {
        glBindTexture(targetOf(form), texture);
        allocate(form);
    }
    if (glGetError() != GL_NO_ERROR)
        throw std::runtime_error("OpenGL makes no such texture");
    glFinish();
    return textures;
}

void ShareContext::destroyTextures(const std::vector<unsigned int>& textures) const
{
    const CurrentContext current(m_client, m_context);
    glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
}

__GLsync* ShareContext::markDrawing()
{
    return glFunction<PFNGLFENCESYNCPROC>("glFenceSync")(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

bool ShareContext::isDone(__GLsync* mark)
{
    const GLenum result = glFunction<PFNGLCLIENTWAITSYNCPROC>("glClientWaitSync")(mark, 0, 0);
    glFunction<PFNGLDELETESYNCPROC>("glDeleteSync")(mark);
    return result == GL_ALREADY_SIGNALED;
}

Picture ShareContext::read(const TexturePart& part) const
{
    const CurrentContext current(m_client, m_context);
    const std::size_t layerSize =
        static_cast<std::size_t>(part.form.width) * static_cast<std::size_t>(part.form.height) * 4;
    std::vector<std::uint8_t> pixels(layerSize * static_cast<std::size_t>(part.form.layers));
    glBindTexture(targetOf(part.form), part.texture);
    if (isDepth(part.form.format))
        readDepth(part.form, pixels);
    else
        glGetTexImage(targetOf(part.form), 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    Picture picture = cut(part, pixels.data() + layerSize * static_cast<std::size_t>(part.layer));
    if (part.form.format == GL_RGBA8 || part.form.format == GL_RGBA16F) {
        for (std::size_t i = 0; i < picture.rgba.size(); ++i)
            picture.rgba[i] = i % 4 == 3 ? picture.rgba[i] : encoded(picture.rgba[i]);
    }
    return picture;
}
} // namespace simulator
