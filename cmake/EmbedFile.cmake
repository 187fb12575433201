# Turns a file into a C++ source with its bytes: cmake -D INPUT=… -D OUTPUT=… -D HEADER=… -D NAME=… -P EmbedFile.cmake
# defines NAME and NAME_SIZE in namespace ompl_certificates, which HEADER declares.
file(READ "${INPUT}" digits HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${digits}")
string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes
  "${bytes}")
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"
namespace ompl_certificates
{
const unsigned char ${NAME}[] = {
${bytes}};
const std::size_t ${NAME}_SIZE = sizeof(${NAME});
}
")
