#pragma once

/// Returns true if the current context uses Qt's own connection to the X server.
bool usesQtsConnection();
