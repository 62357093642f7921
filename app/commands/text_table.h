#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace app
{
/// Lines for a terminal, in columns. Chinese, Japanese and Korean signs are two columns wide there, marks on letters
/// none.
int columnsOf(const QString& text);

/// Cuts a text in its middle, which then is "…", to so many columns. What would break a line is a space.
QString shortened(const QString& text, int columns);

/// A line break follows. `widths`: so many columns; below 0: words begin at the left; else figures end at the right.
/// What is longer stays whole and moves the rest.
QString tableLine(const QStringList& fields, const std::vector<int>& widths);

/// Quotes what a field of CSV must have quoted (RFC 4180).
QString csvField(QString text);
} // namespace app
