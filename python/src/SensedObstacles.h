#ifndef OMPL_CERTIFICATES_PYTHON_SENSED_OBSTACLES_
#define OMPL_CERTIFICATES_PYTHON_SENSED_OBSTACLES_

#include <ompl_certificates/scene/Scene.h>

#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    /** \brief Add to Scene what adds obstacles that a sensor saw: clouds, grids, maps and octomaps */
    void bindSensed(pybind11::class_<ompl_certificates::Scene> &scene);
}

#endif
