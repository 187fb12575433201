#ifndef OMPL_CERTIFICATES_PYTHON_NUMBERS_
#define OMPL_CERTIFICATES_PYTHON_NUMBERS_

#include <cstdint>
#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    /** \brief Whether \e object is a bool of Python or numpy */
    inline bool isBool(pybind11::handle object)
    {
        return pybind11::isinstance<pybind11::bool_>(object) ||
               pybind11::isinstance(object, pybind11::module_::import("numpy").attr("bool_"));
    }

    /** \brief The number of an obstacle, a cloud or a grid. To Python bools are whole numbers, too; here they are a
        mistake, and raise a TypeError. */
    struct Number
    {
        std::uint64_t value{0};

        operator std::uint64_t() const
        {
            return value;
        }
    };
}

namespace pybind11
{
    namespace detail
    {
        template <>
        struct type_caster<ompl_certificates_python::Number>
        {
            PYBIND11_TYPE_CASTER(ompl_certificates_python::Number, const_name("int"));

            bool load(handle source, bool convert)
            {
                make_caster<std::uint64_t> number;
                if (!source || ompl_certificates_python::isBool(source) || !number.load(source, convert))
                    return false;
                value.value = cast_op<std::uint64_t>(number);
                return true;
            }

            static handle cast(const ompl_certificates_python::Number &source, return_value_policy policy,
                               handle parent)
            {
                return make_caster<std::uint64_t>::cast(source.value, policy, parent);
            }
        };
    }
}

#endif
