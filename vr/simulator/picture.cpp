// PNG (ISO/IEC 15948) is a signature followed by chunks of length, name, bytes and checksum. The pixels are one zlib
// stream. Each row begins with the number of its filter, here always 0 for none.
#include "vr/simulator/picture.h"

#include <QByteArray>
#include <QtEndian>

#include <array>
#include <fstream>
#include <stdexcept>

namespace simulator
{
namespace
{
constexpr int fastCompression = 1;

constexpr std::array<quint32, 256> checkTable = [] {
    std::array<quint32, 256> table{};
    for (quint32 i = 0; i < table.size(); ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit)
            table[i] = (table[i] >> 1) ^ ((table[i] & 1) != 0 ? 0xEDB88320U : 0U);
    }
    return table;
}();

/// Returns the CRC-32 of ISO 3309, which PNG requires.
quint32 check(const QByteArray& bytes)
{
    quint32 sum = ~0U;
    for (const char byte : bytes)
        sum = checkTable[(sum ^ static_cast<quint8>(byte)) & 0xFF] ^ (sum >> 8);
    return ~sum;
}

QByteArray bigEndian(quint32 number)
{
    number = qToBigEndian(number);
    return QByteArray(reinterpret_cast<const char*>(&number), sizeof number);
}

QByteArray chunk(const char* name, const QByteArray& bytes)
{
    const QByteArray named = name + bytes;
    return bigEndian(static_cast<quint32>(bytes.size())) + named + bigEndian(check(named));
}

QByteArray header(const Picture& picture)
{
    constexpr char form[] = {8, 6, 0, 0,
                             0}; // bit depth, colour type RGBA, methods of compression, filtering and interlacing
    return bigEndian(static_cast<quint32>(picture.width)) + bigEndian(static_cast<quint32>(picture.height)) +
           QByteArray(form, sizeof form);
}

QByteArray pixels(const Picture& picture)
{
    const qsizetype row = qsizetype(4) * picture.width;
    QByteArray rows;
    rows.reserve((row + 1) * picture.height);
    for (int y = 0; y < picture.height; ++y) {
        rows.append('\0');
        rows.append(reinterpret_cast<const char*>(picture.rgba.data()) + y * row, row);
    }
    constexpr qsizetype ownLength = 4; // qCompress() puts the length before the zlib stream
    return qCompress(rows, fastCompression).mid(ownLength);
}
} // namespace

void writePng(const Picture& picture, const std::string& path)
{
    const QByteArray bytes = QByteArrayLiteral("\x89PNG\r\n\x1a\n") + chunk("IHDR", header(picture)) +
                             chunk("IDAT", pixels(picture)) + chunk("IEND", {});
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), bytes.size());
    if (!file.flush())
        throw std::runtime_error("cannot write " + path);
}
} // namespace simulator
