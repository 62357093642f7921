#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace app
{
/// Returns the width of a text in a terminal, in columns. Chinese, Japanese and Korean characters are two columns wide,
/// combining marks none.
int columnsOf(const QString& text);

/// Shortens a text to `columns` by replacing its middle by "…". Unprintable characters become spaces.
QString shortened(const QString& text, int columns);

/// Returns a line of a table, with a line break. `widths`: columns of each field; negative: left-aligned, positive:
/// right-aligned. A longer field is not cut and shifts the following ones.
QString tableLine(const QStringList& fields, const std::vector<int>& widths);

/// Returns the text as a field of CSV, quoted if necessary (RFC 4180).
QString csvField(QString text);
} // namespace app
