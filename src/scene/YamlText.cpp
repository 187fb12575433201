#include "YamlText.h"

#include <algorithm>
#include <cctype>
#include <ompl/util/Exception.h>
#include <sstream>
#include <yaml-cpp/eventhandler.h>

namespace ompl_certificates
{
    namespace
    {
        /** A value takes some 500 bytes, a number within a list of numbers 250. */
        constexpr std::size_t MOST_VALUES = 6000000;

        /** Takes no notice of what a document holds, but whether it holds anything, and not too much. */
        class Ignored : public YAML::EventHandler
        {
        public:
            explicit Ignored(const std::string &source) : source_(source)
            {
            }

            bool isEmpty{true};

        private:
            void count()
            {
                isEmpty = false;
                if (++values_ > MOST_VALUES)
                    throw ompl::Exception(source_, "holds more than " + std::to_string(MOST_VALUES) + " values");
            }

            const std::string &source_;
            std::size_t values_{0};

            void OnDocumentStart(const YAML::Mark & /*mark*/) override
            {
            }
            void OnDocumentEnd() override
            {
            }
            void OnNull(const YAML::Mark & /*mark*/, YAML::anchor_t /*anchor*/) override
            {
            }
            void OnAlias(const YAML::Mark & /*mark*/, YAML::anchor_t /*anchor*/) override
            {
                count();
            }
            void OnScalar(const YAML::Mark & /*mark*/, const std::string & /*tag*/, YAML::anchor_t /*anchor*/,
                          const std::string & /*value*/) override
            {
                count();
            }
            void OnSequenceStart(const YAML::Mark & /*mark*/, const std::string & /*tag*/, YAML::anchor_t /*anchor*/,
                                 YAML::EmitterStyle::value /*style*/) override
            {
                count();
            }
            void OnSequenceEnd() override
            {
            }
            void OnMapStart(const YAML::Mark & /*mark*/, const std::string & /*tag*/, YAML::anchor_t /*anchor*/,
                            YAML::EmitterStyle::value /*style*/) override
            {
                count();
            }
            void OnMapEnd() override
            {
            }
        };
    }

    YamlNode parseYaml(const std::string &text, const std::string &source)
    {
        try
        {
            // Not YAML::LoadAll: of a text such as "," it makes documents for ever.
            std::istringstream stream(text);
            YAML::Parser parser(stream);
            Ignored ignored(source);
            if (!parser.HandleNextDocument(ignored))
                throw ompl::Exception(source, "is empty");
            // rostopic echo ends each message with the beginning of another document.
            Ignored second(source);
            if (parser.HandleNextDocument(second) && (!second.isEmpty || parser.HandleNextDocument(ignored)))
                throw ompl::Exception(source, "must hold one YAML document, not several");
            return YamlNode(YAML::Load(text), "", source);
        }
        catch (const YAML::Exception &exception)
        {
            const std::string line = exception.mark.is_null() ? "" : ":" + std::to_string(exception.mark.line + 1);
            // Some messages quote a character of the text.
            std::string message = exception.msg;
            std::replace_if(
                message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
            throw ompl::Exception(source + line, "not valid YAML: " + message);
        }
    }
}
