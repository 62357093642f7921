// Format: "pbkdf2-sha256:<rounds>:<salt>:<key>", with salt and key in hexadecimal digits.

#include "app/classroom/class_pin.h"

#include <QPasswordDigestor>
#include <QRandomGenerator>
#include <QStringList>

#include <array>

namespace app
{
namespace
{
constexpr int rounds = 100'000, maxRounds = 10'000'000;
constexpr int keyBytes = 32, saltWords = 4;
const QLatin1StringView method{"pbkdf2-sha256"};

struct PinRecord
{
    int rounds = 0; ///< iterations of PBKDF2; 0: not a valid record
    QByteArray salt, key;
};

PinRecord parse(const QString& text)
{
    const QStringList parts = text.split(u':');
    if (parts.size() != 4 || parts[0] != method)
        return {};
    bool isNumber = false;
    const int count = parts[1].toInt(&isNumber);
    const auto bytes = [](const QString& hex) { return QByteArray::fromHex(hex.toLatin1()); };
    const PinRecord record{count, bytes(parts[2]), bytes(parts[3])};
    const bool isHex =
        QString::fromLatin1(record.salt.toHex()) == parts[2] && QString::fromLatin1(record.key.toHex()) == parts[3];
    const bool isWhole =
        isNumber && count > 0 && count <= maxRounds && !record.salt.isEmpty() && record.key.size() == keyBytes;
    return isHex && isWhole ? record : PinRecord();
}

QByteArray keyOf(const QString& pin, const QByteArray& salt, int count)
{
    return QPasswordDigestor::deriveKeyPbkdf2(QCryptographicHash::Sha256, pin.toUtf8(), salt, count, keyBytes);
}
} // namespace

QString pinRecord(const QString& pin)
{
    std::array<quint32, saltWords> random;
    QRandomGenerator::system()->fillRange(random.data(), saltWords);
    const QByteArray salt(reinterpret_cast<const char*>(random.data()), sizeof random);
    const QByteArray hex = QByteArray::number(rounds) + ':' + salt.toHex() + ':' + keyOf(pin, salt, rounds).toHex();
    return method + u':' + QString::fromLatin1(hex);
}

bool isPin(const QString& pin, const QString& record)
{
    const PinRecord known = parse(record);
    return known.rounds > 0 && keyOf(pin, known.salt, known.rounds) == known.key;
}

bool isPinRecord(const QString& text)
{
    return parse(text).rounds > 0;
}
} // namespace app
