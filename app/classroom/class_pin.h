#pragma once

#include <QString>

namespace app
{
// Storage of a teacher's PIN in a file, with a salt, by PBKDF2. A PIN has few digits: pupils cannot read it, but a
// program could try all. pinRecord() and isPin() take about 0.1 s each, on purpose. Thread: any.

QString pinRecord(const QString& pin);
bool isPin(const QString& pin, const QString& record);

/// Returns whether the text has the format of pinRecord().
bool isPinRecord(const QString& text);
} // namespace app
