// What it takes to open and to export a model of a million vertices, beside a plain read and write of the same bytes and beside
// Assimp's import of the same file.
#include "bench_models.h"

#include "core/mesh_build.h"
#include "core/mesh_io.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <benchmark/benchmark.h>

#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

constexpr core::Slot cuts = 317; // 1,004,892 vertices
constexpr const char* labels[] = {"STL", "PLY", "GLB", "OBJ", "3MF"};
constexpr const char* endings[] = {"stl", "ply", "glb", "obj", "3mf"};

template <typename Work> double millisecondsOf(Work work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void require(bool done)
{
    if (!done)
        throw std::runtime_error("the file system refuses");
}

/// The whole file into fresh memory, by one core.
void readPlainly(const fs::path& path)
{
    const std::size_t size = fs::file_size(path);
    const auto buffer = std::make_unique_for_overwrite<char[]>(size);
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::size_t got = 0;
    for (ssize_t part = 1; got < size && part > 0; got += static_cast<std::size_t>(part))
        require((part = ::read(file, buffer.get() + got, size - got)) >= 0);
    ::close(file);
    require(got == size);
}

/// As many bytes, safe from a power cut.
void writePlainly(const fs::path& path, std::size_t size)
{
    const auto buffer = std::make_unique<char[]>(size);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    std::size_t done = 0;
    for (ssize_t part = 1; done < size && part > 0; done += static_cast<std::size_t>(part))
        require((part = ::write(file, buffer.get() + done, size - done)) >= 0);
    require(done == size && ::fsync(file) == 0);
    ::close(file);
}

void files(benchmark::State& state)
{
    const auto format = static_cast<std::size_t>(state.range(0));
    state.SetLabel(labels[format]);
    const fs::path folder = fs::temp_directory_path() / ("fettle_bench_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const fs::path path = folder / ("ball." + std::string(endings[format]));
    core::TriangleMesh ball = bench::shuffled(bench::geodesicSphere(cuts));
    for (core::Vec3f& p : ball.points)
        p *= 50;
    for ([[maybe_unused]] auto round : state) {
        core::TriangleMesh mesh;
        state.counters["write"] = millisecondsOf([&] { core::writeMesh(path, ball); });
        const std::size_t size = fs::file_size(path);
        state.counters["megabytes"] = static_cast<double>(size) * 1e-6;
        state.counters["plain_write"] = millisecondsOf([&] { writePlainly(folder / "plain", size); });
        state.counters["plain"] = millisecondsOf([&] { readPlainly(path); });
        state.counters["read"] = millisecondsOf([&] { mesh = core::readMesh(path); });
        state.counters["read_plain"] = state.counters["read"] / state.counters["plain"];
        state.counters["build"] = millisecondsOf([&] { require(core::buildMesh(mesh, false).mesh != nullptr); });
        Assimp::Importer importer;
        state.counters["assimp"] = millisecondsOf([&] { benchmark::DoNotOptimize(importer.ReadFile(path.string(), 0)); });
        state.SetIterationTime(state.counters["read"] * 1e-3);
    }
    fs::remove_all(folder);
}
BENCHMARK(files)->DenseRange(0, 4)->Iterations(1)->UseManualTime();
} // namespace
