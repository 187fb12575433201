#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_FORGIVEN_LEAKS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_FORGIVEN_LEAKS_

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define OMPL_CERTIFICATES_TESTS_FIND_LEAKS
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define OMPL_CERTIFICATES_TESTS_FIND_LEAKS
#endif

#ifdef OMPL_CERTIFICATES_TESTS_FIND_LEAKS
#include <sanitizer/lsan_interface.h>
#endif

namespace ompl_certificates
{
    namespace test
    {
        /** \brief While it lives, the address sanitizer reports no leak of this thread's allocations: for foreign code
            that is known to leak */
        class ForgivenLeaks
        {
        public:
            /** \brief Forgives only if \e forgive is set */
            explicit ForgivenLeaks([[maybe_unused]] bool forgive)
            {
#ifdef OMPL_CERTIFICATES_TESTS_FIND_LEAKS
                forgive_ = forgive;
                if (forgive_)
                    __lsan_disable();
#endif
            }

            ~ForgivenLeaks()
            {
#ifdef OMPL_CERTIFICATES_TESTS_FIND_LEAKS
                if (forgive_)
                    __lsan_enable();
#endif
            }

            ForgivenLeaks(const ForgivenLeaks &) = delete;
            ForgivenLeaks &operator=(const ForgivenLeaks &) = delete;

        private:
#ifdef OMPL_CERTIFICATES_TESTS_FIND_LEAKS
            bool forgive_{false};
#endif
        };
    }
}

#endif
