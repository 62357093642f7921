#include <cstdio>

int main()
{
    std::puts("fettle " FETTLE_VERSION);
}
