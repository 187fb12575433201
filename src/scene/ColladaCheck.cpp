#include "ColladaCheck.h"

#include <algorithm>
#include <cstring>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::string_view DIGITS = "0123456789", SPACES = " \t\r\n";

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        /** Whether a number is at most \e bytes: each thing that is counted takes a byte of the file. */
        bool isPossible(std::string_view digits, std::size_t bytes)
        {
            return digits.size() <= 15 && std::stoull(std::string(digits)) <= bytes;
        }

        void checkCounts(const pugi::xml_node &node, std::size_t bytes)
        {
            for (const pugi::xml_attribute &attribute : node.attributes())
            {
                if (std::strcmp(attribute.name(), "count") != 0)
                    continue;
                const std::string_view value = attribute.value();
                if (value.empty() || value.find_first_not_of(DIGITS) != std::string_view::npos)
                    fail("count=\"" + std::string(value.substr(0, 10)) + "\" is not a number");
                if (!isPossible(value, bytes))
                    fail("it says that it has " + std::string(value.substr(0, 30)) + " of something, in " +
                         std::to_string(bytes) + " bytes");
            }
        }

        /** What the numbers that are the content of \e node add up to */
        std::size_t sumOf(const pugi::xml_node &node, std::size_t bytes)
        {
            std::size_t sum = 0;
            for (std::string_view rest = node.text().get(); !rest.empty();)
            {
                if (const std::size_t spaces = rest.find_first_not_of(SPACES); spaces > 0)
                {
                    rest.remove_prefix(std::min(spaces, rest.size()));
                    continue;
                }
                const std::size_t digits = std::min(rest.find_first_not_of(DIGITS), rest.size());
                const std::string_view word = rest.substr(0, rest.find_first_of(SPACES)),
                                       number = rest.substr(0, digits);
                if (digits == 0 || !isPossible(number, bytes))
                    fail("in <" + std::string(node.name()) + "> there is '" + std::string(word.substr(0, 10)) +
                         "', not a number that can be");
                sum += std::stoull(std::string(number));
                rest.remove_prefix(digits);
            }
            return sum;
        }

        /** Assimp reads from nowhere where an accessor is of an empty array. */
        void checkArray(const pugi::xml_node &array)
        {
            const auto isAccessor = [](const pugi::xml_node &node)
            { return std::strcmp(node.name(), "accessor") == 0 && node.attribute("count").as_ullong() > 0; };
            if (array.attribute("count").as_ullong() == 0 && array.parent().find_node(isAccessor))
                fail("a <float_array> is empty that is made use of");
        }

        class Check : public pugi::xml_tree_walker
        {
        public:
            explicit Check(std::size_t bytes) : bytes_(bytes)
            {
            }

            bool for_each(pugi::xml_node &node) override
            {
                const std::string_view name = node.name();
                checkCounts(node, bytes_);
                if (name == "float_array")
                    checkArray(node);
                // What is no number Assimp tries to read for ever.
                if (name == "p")
                    sumOf(node, bytes_);
                if (name == "vcount" && sumOf(node, bytes_) > bytes_)
                    fail("in <vcount> there are more than there are bytes");
                return true;
            }

        private:
            std::size_t bytes_;
        };
    }

    void checkCollada(const std::string &text)
    {
        pugi::xml_document document;
        if (const auto result = document.load_buffer(text.data(), text.size(), pugi::parse_full); !result)
            fail(std::string("it is not XML: ") + result.description());
        Check check(text.size());
        document.traverse(check);
    }
}
