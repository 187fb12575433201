#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_DOCUMENT_
#define OMPL_CERTIFICATES_SCENE_COLLADA_DOCUMENT_

#include "ColladaIds.h"
#include "LineReader.h"

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    /** \brief The elements of a COLLADA file, what their attributes refer to, and their numbers. All complaints are
        std::runtime_error and name the line, if there is one. */
    class ColladaDocument
    {
    public:
        using Node = pugi::xml_node;

        /** \brief Parse \e content, which must outlive the document.
            \throws std::runtime_error if it is too large, no XML or not of COLLADA */
        explicit ColladaDocument(std::string_view content);

        /** \brief The element around all others */
        Node getRoot() const
        {
            return document_.child("COLLADA");
        }

        /** \brief Let the ids within \e mesh count before those elsewhere; see ColladaIds. */
        void setMesh(const Node &mesh)
        {
            mesh_ = mesh;
        }

        /** \brief Complain of an element. */
        [[noreturn]] void fail(const Node &node, const std::string &complaint) const;

        /** \brief The element of that name whose id the attribute gives, if it is there */
        Node find(const Node &from, const char *attribute, std::string_view name) const;

        /** \brief The same, which must be there */
        Node require(const Node &from, const char *attribute, const std::string &name) const;

        /** \brief An attribute that counts something, or \e otherwise without it */
        std::size_t wholeAttribute(const Node &node, const std::string &name, std::size_t otherwise) const;

        /** \brief The numbers that are the text of an element */
        template <typename Number>
        std::vector<Number> numbersOf(const Node &node) const
        {
            std::vector<Number> numbers;
            for (const Node &child : node.children())
                if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                    for (LineReader text(child.value()); text.nextLine();)
                        for (std::string_view word = text.next(); !word.empty(); word = text.next())
                            if (!parseNumber(word, numbers.emplace_back()))
                                fail(node, "has " + inQuotes(word) + ", which is not a number for it");
            return numbers;
        }

        /** \brief The text of an attribute; empty without it */
        static std::string_view valueOf(const Node &node, const char *attribute)
        {
            return node.attribute(attribute).value();
        }

    private:
        [[noreturn]] void fail(std::ptrdiff_t offset, const std::string &complaint) const;

        std::string_view content_;
        pugi::xml_document document_;
        ColladaIds ids_;
        Node mesh_;
    };
}

#endif
