#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

/// What the objects that are compiled for newer machines define. The linker keeps one of several functions of the same
/// name: if it kept one of these for all, the program would not run on an older machine.
namespace ringfilm::architecture {
namespace {

/// Symbols that one member of a library, as `nm` lists it, offers to other objects.
struct Offered {
  std::vector<std::string> tagged;  ///< functions with the tag in their names
  std::vector<std::string> others;  ///< functions without
};

/// @param listing of `nm --defined-only`: a line "member:", then lines "address type name"
Offered offered_by(const std::string& listing, const std::string& member, const std::string& tag) {
  Offered offered;
  std::istringstream lines(listing);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == ':') inside = line == member + ":";
    std::istringstream words(line);
    std::string address, type, name;
    if (!inside || !(words >> address >> type >> name)) continue;
    const bool is_local = std::islower(static_cast<unsigned char>(type[0])) && type != "u" && type != "w";
    const bool is_data = type == "D" || type == "R" || type == "B" || type == "V";
    if (is_local || is_data) continue;
    (name.find(tag) != std::string::npos ? offered.tagged : offered.others).push_back(name);
  }
  return offered;
}

/// Standard output of a command; empty if it cannot be run.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen((command + " 2>/dev/null").c_str(), "r"), ::pclose);
  std::string printed;
  for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF;) printed += static_cast<char>(c);
  return printed;
}

struct Machine {
  const char* member;
  const char* tag;  ///< base::InstructionSet as a template argument in a mangled name
};

TEST(MachineCode, ObjectsForNewerMachinesOfferNothingThatOlderOnesMightPickUp) {
  const std::string listing = output_of("nm --defined-only '" RINGFILM_FILM_LIBRARY "'");
  if (listing.empty()) GTEST_SKIP() << "nm (binutils) is missing: nothing lists what the objects define";
  if (listing.find("kernels_avx2.cpp") == std::string::npos) GTEST_SKIP() << "no kernels for newer machines were built";
  for (const Machine& machine :
       {Machine{"kernels_avx2.cpp.o", "14InstructionSetE1E"}, Machine{"kernels_avx512.cpp.o", "14InstructionSetE2E"}}) {
    const Offered offered = offered_by(listing, machine.member, machine.tag);
    EXPECT_GE(offered.tagged.size(), 6u) << machine.member;  // those that FilmKernels lists
    for (const std::string& name : offered.others) ADD_FAILURE() << machine.member << " offers " << name;
  }
}

TEST(MachineCode, FunctionsWithoutTheTagAreReported) {
  const std::string listing =
      "\nkernels_old.cpp.o:\n0000000000000000 W _ZNSt6vectorIdSaIdEE9push_backEOd\n"
      "\nkernels_new.cpp.o:\n0000000000000000 W _ZN4filmILN4base14InstructionSetE1EEEvv\n"
      "0000000000000000 D _ZN4film7kTableE\n0000000000000010 t _ZL5alonev\n0000000000000000 r .LC0\n"
      "0000000000000000 V DW.ref.__gxx_personality_v0\n"
      "0000000000000020 T _Z4openv\n0000000000000000 u _ZZ4openvE5state\n0000000000000000 W _ZSt4sqrtIdEvT_\n"
      "0000000000000000 W _ZN4filmILN4base14InstructionSetE0EEEvv\n";
  const Offered offered = offered_by(listing, "kernels_new.cpp.o", "14InstructionSetE1E");
  EXPECT_EQ(offered.tagged, std::vector<std::string>{"_ZN4filmILN4base14InstructionSetE1EEEvv"});
  EXPECT_EQ(offered.others, (std::vector<std::string>{"_Z4openv", "_ZZ4openvE5state", "_ZSt4sqrtIdEvT_",
                                                      "_ZN4filmILN4base14InstructionSetE0EEEvv"}));
}

}  // namespace
}  // namespace ringfilm::architecture
