#pragma once

#include <QtGlobal>

/// Asks the windows of another process to close, as a click on their cross does. False: it shows none. Of one thread.
bool askToClose(qint64 process);
