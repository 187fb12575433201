#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_COMPLAINT_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_COMPLAINT_

#include "Message.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief The complaint of \e trial, with the same random numbers each time; empty if there is none */
        inline std::string complaintOf(const std::function<void()> &trial)
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            ompl::RNG::setSeed(5);
            return messageOf(trial);
        }

        /** \brief Expects that a complaint has all \e words */
        inline void expectWords(const std::string &complaint, const std::vector<std::string> &words)
        {
            for (const std::string &word : words)
                EXPECT_NE(complaint.find(word), std::string::npos) << "no '" << word << "' in: " << complaint;
        }
    }
}

#endif
