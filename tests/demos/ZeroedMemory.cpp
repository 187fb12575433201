// OMPL's LBTRRT reads a cost of its root that it never sets. So that trees do not depend on what stood there before, all
// memory of this program is zero at first.

#include <cstdlib>
#include <new>

void *operator new(std::size_t size)
{
    if (void *memory = std::calloc(1, size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}
