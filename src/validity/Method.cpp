#include "ompl_certificates/validity/Method.h"

#include "ompl_certificates/files/Suggestion.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    const std::vector<Method> &allMethods()
    {
        static const std::vector<Method> methods{Method::FCL, Method::STANDARD, Method::BASIC, Method::PARTIAL,
                                                 Method::SHARED_PROJECTION};
        return methods;
    }

    std::string nameOf(Method method)
    {
        switch (method)
        {
            case Method::FCL:
                return "fcl";
            case Method::STANDARD:
                return "standard";
            case Method::BASIC:
                return "basic";
            case Method::PARTIAL:
                return "partial";
            case Method::SHARED_PROJECTION:
                return "shared";
        }
        throw ompl::Exception("Unknown method");
    }

    Method methodOf(const std::string &name)
    {
        std::vector<std::string> names;
        for (const Method method : allMethods())
        {
            if (nameOf(method) == name)
                return method;
            names.push_back(nameOf(method));
        }
        throw ompl::Exception("There is no method '" + name + "'; the methods are " + joined(names) +
                              didYouMean(name, names));
    }
}
