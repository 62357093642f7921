#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

/// How the loader and a runtime find each other, interface version 1: the specification's chapter "Loader" says it,
/// Debian's headers lack it.
namespace simulator
{
enum class LoaderStructure : std::int32_t { LoaderInfo = 1, RuntimeRequest = 3 };
inline constexpr std::uint32_t loaderInterfaceVersion = 1;
/// The version of OpenXR that the simulator implements, whatever the headers' own is.
inline constexpr XrVersion implementedVersion = XR_MAKE_VERSION(1, 0, 20);

struct LoaderInfo
{
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t minInterfaceVersion, maxInterfaceVersion;
    XrVersion minApiVersion, maxApiVersion;
};

struct RuntimeRequest
{
    LoaderStructure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t interfaceVersion;
    XrVersion apiVersion;
    PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};
} // namespace simulator
