#pragma once

#include <QString>

namespace app
{
// A teacher's PIN is stored in a file as a salted PBKDF2 hash. Pupils cannot read the PIN from it, but a program could
// try all PINs, because they have few digits. pinRecord() and isPin() take about 0.1 s each, on purpose. Thread: any.

QString pinRecord(const QString& pin);
bool isPin(const QString& pin, const QString& record);

/// Returns whether the text has the format of pinRecord().
bool isPinRecord(const QString& text);
} // namespace app
