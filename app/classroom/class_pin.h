#pragma once

#include <QString>

namespace app
{
// A teacher's PIN as it may stand in a file: with a salt, by PBKDF2. A PIN has few digits: this keeps a pupil from
// reading it, not somebody with time and a program from trying all. Any thread; each of the first two takes about a
// tenth of a second, on purpose.

QString pinRecord(const QString& pin);
bool isPin(const QString& pin, const QString& record);

/// Whether it can be one of pinRecord()'s.
bool isPinRecord(const QString& text);
} // namespace app
