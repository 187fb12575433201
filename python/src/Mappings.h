#ifndef OMPL_CERTIFICATES_PYTHON_MAPPINGS_
#define OMPL_CERTIFICATES_PYTHON_MAPPINGS_

#include <map>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <utility>

namespace ompl_certificates_python
{
    /** \brief What Python gives as a dict or as any other mapping, such as types.MappingProxyType. pybind11 takes dicts
        alone for a std::map. */
    template <typename Key, typename Value>
    struct Mapping : std::map<Key, Value>
    {
        using std::map<Key, Value>::map;
    };

    /** \brief Whether \e object is a mapping of Python */
    inline bool isMapping(pybind11::handle object)
    {
        return pybind11::isinstance<pybind11::dict>(object) ||
               pybind11::isinstance(object, pybind11::module_::import("collections.abc").attr("Mapping"));
    }

    /** \brief A mapping as a dict; it must be one */
    inline pybind11::dict dictOf(pybind11::handle mapping)
    {
        return pybind11::dict(pybind11::reinterpret_borrow<pybind11::object>(mapping));
    }
}

namespace pybind11
{
    namespace detail
    {
        template <typename Key, typename Value>
        struct type_caster<ompl_certificates_python::Mapping<Key, Value>>
        {
            using Map = std::map<Key, Value>;
            using Mapping = ompl_certificates_python::Mapping<Key, Value>;

            PYBIND11_TYPE_CASTER(Mapping, make_caster<Map>::name);

            bool load(handle source, bool convert)
            {
                make_caster<Map> map;
                if (!source || !ompl_certificates_python::isMapping(source) ||
                    !map.load(ompl_certificates_python::dictOf(source), convert))
                    return false;
                static_cast<Map &>(value) = std::move(cast_op<Map &>(map));
                return true;
            }

            static handle cast(const Mapping &source, return_value_policy policy, handle parent)
            {
                return make_caster<Map>::cast(static_cast<const Map &>(source), policy, parent);
            }
        };
    }
}

#endif
