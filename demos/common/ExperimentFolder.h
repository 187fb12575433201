#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_FOLDER_
#define OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_FOLDER_

#include "common/ExperimentTrial.h"

#include <string>
#include <vector>

namespace demos
{
    /** \brief The folder with an experiment's results: experiment.json says which grid they are of, scenes/ has a
        picture of each scene, and trials/ a file for each trial that is done. Several processes may work in one folder
        at once, each on a share of the trials. */
    class ExperimentFolder
    {
    public:
        /** \brief Use \e folder for \e grid; it is made if there is none.
            \throws ompl::Exception if it holds results of another grid or other files, or cannot be written */
        ExperimentFolder(const std::string &folder, const ExperimentGrid &grid);

        /** \brief The trials of share \e index of \e count shares (from 0), in the order in which to run them. Trials
            that are compared with each other, which differ in the method alone, are in one share and follow each other.
            Before any second trial of its kind comes the first one of every kind; small and large teams come mixed. */
        std::vector<ExperimentTrial> getTrials(unsigned int index, unsigned int count) const;

        /** \brief The result of a trial if it is there, else null. A file that is cut short, damaged or of another
            trial is taken for missing.
            \param damaged set to the file if it is there but useless, else to nothing */
        nlohmann::ordered_json read(const ExperimentTrial &trial, std::string &damaged) const;

        /** \brief Write the result of a trial, all of it or nothing
            \throws ompl::Exception that names the file if it cannot be written */
        void write(const ExperimentTrial &trial, const nlohmann::ordered_json &result) const;

        /** \brief Remove what a process left behind that was killed while it wrote the result of \e trial */
        void removeRemains(const ExperimentTrial &trial) const;

    private:
        std::string fileOf(const ExperimentTrial &trial) const;

        /** \brief The grid's mark on the folder */
        void claim() const;

        std::string folder_;
        const ExperimentGrid &grid_;
    };
}

#endif
