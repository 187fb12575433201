#include "Changes.h"
#include "Compare.h"

#include "files/WholeFile.h"
#include "support/RandomStates.h"

#include "ompl_certificates/validity/CertificateFile.h"

#include <filesystem>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace stress
    {
        namespace
        {
            void compareAll(World &world, Tally &tally)
            {
                for (auto *state : world.pool)
                    compareState(world, state, tally);
            }

            /** Whether a checker takes the certificates of \e file */
            bool isLoaded(TeamValidityChecker &checker, const std::string &file)
            {
                try
                {
                    loadCertificates(checker, file);
                    return true;
                }
                catch (const ompl::Exception &)
                {
                    return false;
                }
            }
        }

        void changes(World &world, Tally &tally)
        {
            // In contact with what may be removed, so that the contact is remembered
            for (std::size_t i = 2; i < 6; ++i)
            {
                world.redraw(world.pool[i]);
                world.sink(world.pool[i], world.random.below(world.team->getRobotCount()));
            }
            compareAll(world, tally);
            world.changeObstacles();
            compareAll(world, tally);
            // OMPL assumes that a motion starts at a valid state.
            for (std::size_t i = 2; i < 6; ++i)
                if (world.checked->isValid(world.pool[i]))
                    compareMotion(world, world.pool[i], world.pool[i + 1], tally);
            for (int i = 0; i < 10; ++i)
            {
                auto *state = world.anyState();
                world.redraw(state);
                compareState(world, state, tally);
            }
        }

        void files(World &world, Tally &tally)
        {
            test::Random &random = world.random;
            TeamValidityChecker &partial = *world.checked->certified[1].checker;
            TeamValidityChecker &shared = *world.checked->certified[2].checker;
            // One file for each state of the obstacles: the older ones are of other obstacles.
            const auto fileAfter = [&world](unsigned int change)
            { return world.folder / ("certificates" + std::to_string(change)); };
            saveCertificates(shared, fileAfter(world.changes));

            TeamValidityChecker &loading = random.chance(0.5) ? partial : shared;
            const std::string older = fileAfter(random.below(world.changes + 1));
            std::string damaged = readWholeFile(fileAfter(world.changes));
            if (random.chance(0.5))
                damaged.resize(random.below(damaged.size()));
            else
                damaged[random.below(damaged.size())] ^= static_cast<char>(1 << random.below(8));
            loading.clear();
            if (isLoaded(loading, world.folder.write("damaged", damaged)))
                throw lieAbout(world, nameOf(loading.getMethod()) + " takes a damaged file of certificates", {});
            if (std::filesystem::exists(older) && isLoaded(loading, older))
                compareAll(world, tally);
            loading.clear();
            if (!isLoaded(loading, fileAfter(world.changes)))
                throw lieAbout(world, nameOf(loading.getMethod()) + " refuses the certificates of its obstacles", {});
            compareAll(world, tally);
        }
    }
}
