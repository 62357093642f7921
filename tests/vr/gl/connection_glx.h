#pragma once

/// Whether what is current on this thread draws over the connection to the X server that Qt has.
bool usesQtsConnection();
