/* The header of Wintab, as Qt wants it, by that of Wine, which needs three macros of Wine's own. */
#include <windows.h>
#define API WINAPI
#define DECL_WINELIB_TYPE_AW(type) typedef type##W type;
#define WINELIB_NAME_AW(name) name##W
#include "wine_wintab.h"
