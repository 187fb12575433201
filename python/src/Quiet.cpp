#include "Quiet.h"

#include <mutex>
#include <set>

namespace ompl_certificates_python
{
    namespace
    {
        std::mutex &mutexOfLevels()
        {
            static std::mutex theMutex;
            return theMutex;
        }

        /** All levels that are asked for now */
        std::multiset<ompl::msg::LogLevel> &levels()
        {
            static std::multiset<ompl::msg::LogLevel> theLevels;
            return theLevels;
        }

        /** The level that was there before the first */
        ompl::msg::LogLevel &levelBefore()
        {
            static ompl::msg::LogLevel theLevel{ompl::msg::LOG_INFO};
            return theLevel;
        }

        void setLevel()
        {
            ompl::msg::setLogLevel(levels().empty() ? levelBefore() : *levels().rbegin());
        }
    }

    Quiet::Quiet(ompl::msg::LogLevel level) : level_(level)
    {
        const std::lock_guard<std::mutex> lock(mutexOfLevels());
        if (levels().empty())
            levelBefore() = ompl::msg::getLogLevel();
        levels().insert(level_);
        setLevel();
    }

    Quiet::~Quiet()
    {
        const std::lock_guard<std::mutex> lock(mutexOfLevels());
        levels().erase(levels().find(level_));
        setLevel();
    }
}
