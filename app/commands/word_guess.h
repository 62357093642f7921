#pragma once

#include <QString>
#include <QStringList>

namespace app
{
/// Returns the word most similar to the typed one, ignoring dashes; empty if none is similar.
QString meantWord(const QString& typed, const QStringList& words);
} // namespace app
