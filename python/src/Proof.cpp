#include "Proof.h"

#include "Bindings.h"

namespace ompl_certificates_python
{
    namespace
    {
        std::string textOf(const Proof &proof)
        {
            if (proof.unproved.empty())
                return "<Proof: free throughout>";
            return "<Proof: " + std::to_string(proof.unproved.size()) + " motions are not proved" +
                   (proof.reason.is_none() ? "" : ", " + proof.reason.cast<std::string>()) + ">";
        }
    }

    Proof toProof(const FoundProof &found)
    {
        Proof proof{found.proof.unproved, py::none(), py::none()};
        if (found.proof.collision)
        {
            const std::vector<double> row = found.proof.collision->reals();
            proof.collision = Doubles(static_cast<py::ssize_t>(row.size()), row.data());
            proof.reason = py::str(found.collision);
        }
        return proof;
    }

    Proof reportProof(Outcome &plan, const FoundProof &found)
    {
        plan.report.setProof(found.proof);
        plan.report.collision = found.collision;
        plan.isProofReported = true;
        return toProof(found);
    }

    void bindProof(py::module_ &module)
    {
        py::class_<Proof> proofs(module, "Proof", "What is known of a path between the states at which it was checked");
        forbidNew(proofs, "Plan.prove() and Checker.prove() make proofs");
        proofs
            .def_property_readonly(
                "proved", [](const Proof &proof) { return proof.unproved.empty(); },
                "Whether all of the path is proved free")
            .def_readonly("unproved", &Proof::unproved,
                          "The motions that are not proved free, each by the row of the path that it starts at")
            .def_readonly("collision", &Proof::collision,
                          "The first invalid state that was found on these motions, of shape (coordinates,); None if "
                          "none was")
            .def_readonly("reason", &Proof::reason, "What collides there, in a few words; None if nothing was found")
            .def("__repr__", &textOf)
            .def("__bool__", [](const Proof &proof) { return proof.unproved.empty(); });
    }
}
