#pragma once

/// Values of OpenGL's constants, for templates that take a table of OpenGL functions. core includes no OpenGL header
/// and links no OpenGL library.
namespace core::gl
{
inline constexpr unsigned int triangles = 0x0004;
inline constexpr unsigned int signedByte = 0x1400, unsignedByte = 0x1401, unsignedInt = 0x1405, singleFloat = 0x1406;
inline constexpr unsigned int arrayBuffer = 0x8892, elementArrayBuffer = 0x8893;
inline constexpr unsigned int copyReadBuffer = 0x8F36, copyWriteBuffer = 0x8F37;
inline constexpr unsigned int dynamicDraw = 0x88E8;
} // namespace core::gl
