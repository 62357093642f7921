#pragma once

#include <QtGlobal>

/// Asks the windows of another process to close, as their close button does. Returns false if it shows no window.
/// Thread: one at a time.
bool askToClose(qint64 process);
