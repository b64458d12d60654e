// Writes the synthetic instrument files of cases/measured/ into a folder.
#include <exception>
#include <iostream>

#include "measured_files.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_measured_files CASES FOLDER\n";
    return 2;
  }
  try {
    for (const auto& file : ringfilm::measured_files::all_files(argv[1])) {
      ringfilm::io::write_atomically(std::string(argv[2]) + "/" + file.name, file.bytes);
      std::cout << file.name << ": " << file.bytes.size() << " byte\n";
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
