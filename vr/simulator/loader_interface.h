#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

/// The interface by which the loader and a runtime find each other, version 1. The specification's chapter "Loader"
/// defines it; Debian's headers lack it.
namespace simulator
{
enum class LoaderStructure : std::int32_t { LoaderInfo = 1, RuntimeRequest = 3 };
inline constexpr std::uint32_t loaderInterfaceVersion = 1;
/// Version of OpenXR that the simulator implements, whatever the version of the headers is.
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
