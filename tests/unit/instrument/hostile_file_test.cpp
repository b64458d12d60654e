#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zip.h>

#include <cmath>
#include <limits>

#include "ringfilm/instrument/formats/gwyddion_program.hpp"
#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Bytes;
using handmade::Sur;
using handmade::X3p;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string six_heights() { return Bytes().f64(1e-6).f64(2e-6).f64(3e-6).f64(4e-6).f64(5e-6).f64(6e-6); }

X3p small_x3p() {
  X3p x3p;
  x3p.points = six_heights();
  return x3p;
}

std::string gsf(int points_x, int points_y, const std::string& heights) {
  Bytes out;
  out.text("Gwyddion Simple Field 1.0\nXRes = " + std::to_string(points_x) + "\nYRes = " + std::to_string(points_y) +
           "\nXReal = 1e-6\nYReal = 1e-6\nXYUnits = m\nZUnits = m\n");
  out.zeros(4 - out.str().size() % 4);
  return out.str() + heights;
}

std::string sized_x3p(const std::string& points_x, const std::string& points_y) {
  X3p x3p = small_x3p();
  x3p.dimension = "<MatrixDimension><SizeX>" + points_x + "</SizeX><SizeY>" + points_y +
                  "</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
  return x3p_archive(x3p);
}

TEST(HostileFile, CutShortAnywhereIsRefused) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.sur", Sur().bytes()},
      {"a.sdf", handmade::sdf_header(7, 3, 2).str() + six_heights()},
      {"a.gsf", gsf(3, 2, std::string(24, '\0'))},
      {"a.x3p", x3p_archive(small_x3p())}};
  for (const auto& [name, bytes] : files) {
    ASSERT_EQ(refusal(name, bytes), "") << name;
    // Short heads are not known format and would each start gwyddion: from the end of the signature on.
    for (std::size_t length = 26; length < bytes.size(); length += 1 + length / 64) {
      const std::string printed = refusal(name, bytes.substr(0, length));
      EXPECT_THAT(printed, HasSubstr(name)) << length << " of " << bytes.size();
      EXPECT_THAT(printed, HasSubstr("\n    ")) << "no remedy for " << name << " cut to " << length;
    }
  }
}

TEST(HostileFile, FortyThousandSquaredInASmallFile) {
  Sur sur;
  sur.points_x = sur.points_y = 40000;
  const auto limit = HasSubstr("40000 x 40000 points, over the limit");
  EXPECT_THAT(refusal("a.sur", sur.bytes() + std::string(500, 'x')), limit);
  EXPECT_THAT(refusal("a.gsf", gsf(40000, 40000, std::string(900, 'x'))), limit);
  EXPECT_THAT(refusal("a.x3p", sized_x3p("40000", "40000")), limit);
  EXPECT_THAT(refusal("a.sdf", handmade::sdf_header(7, 40000, 40000).zeros(900)), limit);
  // Below the limit the size of the file decides, before any memory is taken.
  EXPECT_THAT(refusal("a.sdf", handmade::sdf_header(7, 10000, 10000).zeros(900)), HasSubstr("the file ends after 981"));
  EXPECT_THAT(refusal("a.x3p", sized_x3p("10000", "10000")), HasSubstr("bindata/data.bin has 48 bytes"));
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  EXPECT_LT(used.ru_maxrss, 400 * 1024) << "kilobytes";
}

TEST(HostileFile, WrongSizesInTheHeader) {
  for (const char* size : {"0", "-3", "1e300", "4294967296", "3.5", "", "three"}) {
    EXPECT_THAT(refusal("a.x3p", sized_x3p(size, "2")), HasSubstr("SizeX")) << size;
  }
  Sur sur;
  sur.points_x = -3;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("-3 x 2"));
  sur.points_x = 3;
  sur.points_y = 2000;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("byte 512: the map of 3 x 2000 points needs 24000 bytes"));
}

/// Every character in two bytes, behind the mark of their order.
std::string in_utf16(const std::string& ascii, bool high_byte_first) {
  std::string bytes = high_byte_first ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) bytes += high_byte_first ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST(HostileFile, ADoctypeCannotHideInUtf16) {
  X3p x3p;
  x3p.before_root = "<!DOCTYPE p:ISO5436_2 [<!ENTITY a \"b\">]>";
  const std::string points = six_heights();
  for (const bool high_byte_first : {false, true}) {
    for (const std::size_t mark : {0, 2}) {
      const std::string xml = in_utf16(x3p.xml(), high_byte_first).substr(mark);
      const std::string archive = handmade::zip({{"main.xml", xml}, {"bindata/data.bin", points}});
      EXPECT_THAT(refusal("a.x3p", archive), HasSubstr("main.xml has a DOCTYPE")) << high_byte_first << mark;
    }
  }
}

/// An archive with one entry of zeros, packed a thousand times smaller.
std::string bomb(const std::string& path, const X3p& x3p, std::size_t size) {
  int code = 0;
  zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  const std::string xml = x3p.xml(), zeros(size, '\0');
  zip_file_add(archive, "main.xml", zip_source_buffer(archive, xml.data(), xml.size(), 0), 0);
  zip_file_add(archive, "bindata/data.bin", zip_source_buffer(archive, zeros.data(), zeros.size(), 0), 0);
  zip_close(archive);
  return path;
}

TEST(HostileFile, AZipBombIsNotUnpacked) {
  const ScratchFolder folder;
  const std::string path = bomb(folder / "bomb.x3p", small_x3p(), std::size_t{200} << 20);
  ASSERT_LT(std::filesystem::file_size(path), 400000u);
  try {
    read_surface_file(path, {}, units());
    FAIL() << "200 MB of points for a map of six";
  } catch (const InputError& error) {
    EXPECT_THAT(describe(error.faults()), HasSubstr("bindata/data.bin has 209715200 bytes"));
  }
  X3p large = small_x3p();
  large.before_root = "<!-- " + std::string(std::size_t{70} << 20, ' ') + " -->";
  bomb(path, large, 48);
  try {
    read_surface_file(path, {}, units());
    FAIL() << "70 MB of XML";
  } catch (const InputError& error) {
    EXPECT_THAT(describe(error.faults()), HasSubstr("main.xml unpacks to"));
  }
}

TEST(HostileFile, AZipThatLiesAboutItsSizeIsStopped) {
  const ScratchFolder folder;
  const std::size_t size = std::size_t{20} << 20;
  std::ifstream in(bomb(folder / "bomb.x3p", small_x3p(), size), std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string stated = Bytes().i32(static_cast<std::int64_t>(size)), lie = Bytes().i32(48);
  int places = 0;
  for (std::size_t i = bytes.find(stated); i != std::string::npos; i = bytes.find(stated, i + 4), ++places) {
    bytes.replace(i, 4, lie);
  }
  ASSERT_EQ(places, 2) << "the size is in front of the entry and in the directory";
  EXPECT_THAT(refusal("a.x3p", bytes), HasSubstr("bindata/data.bin"));
}

TEST(HostileFile, AnEntityBombIsNotUnfolded) {
  X3p x3p = small_x3p();
  x3p.before_root = "<!DOCTYPE p [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("DOCTYPE"));
  x3p = small_x3p();
  x3p.data = "";
  for (int i = 0; i < 20000; ++i) x3p.data += "<deep>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, byte"));
}

TEST(HostileFile, NothingMeasuredIsAnError) {
  X3p x3p;
  Bytes points;
  for (int i = 0; i < 6; ++i) points.f64(kNaN);
  x3p.points = points;
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("no point was measured"));
  EXPECT_THAT(refusal("a.sdf", handmade::sdf_text("BAD BAD BAD BAD BAD BAD", 3, 2)),
              HasSubstr("no point was measured"));
}

TEST(HostileFile, SwappedByteOrderIsReported) {
  // Heights of the other byte order are far beyond any surface, or the check of the sizes fails first.
  X3p x3p;
  Bytes points(true);
  for (const double height : {1e-6, 2.1e-6, 3.3e-6, -4.7e-6, 5.1e-6, 6.9e-6}) points.f64(height);
  x3p.points = points;
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("byte order"));
  Bytes sdf(true);
  sdf.text("bISO-1.0").text("MAKER", 10).text("070320191200").text("070320191200").i16(3).i16(2);
  sdf.f64(2e-6).f64(3e-6).f64(1e-9).f64(-1).whole(0, 1).whole(7, 1).whole(0, 1).text(six_heights());
  EXPECT_THAT(refusal("a.sdf", sdf), HasSubstr("a.sdf: byte"));
  std::string sur = Sur().bytes();
  std::swap(sur[12], sur[13]);
  sur[12] = 1;
  EXPECT_THAT(refusal("a.sur", sur), HasSubstr("a.sur: byte"));
}

TEST(HostileFile, OneByNIsAProfileAndOnePointIsNot) {
  EXPECT_TRUE(read_bytes("a.sdf", handmade::sdf_text("1 2 3 4", 4, 1)).map.is_profile());
  const SurfaceFile upright = read_bytes("a.sdf", handmade::sdf_text("1 2 3 4", 1, 4));
  EXPECT_TRUE(upright.map.is_profile());
  EXPECT_EQ(upright.map.step_x_m, 3e-6);
  EXPECT_THAT(refusal("a.sdf", handmade::sdf_text("1", 1, 1)), HasSubstr("two or more points are required"));
}

TEST(HostileFile, NoFileAFolderAndAnEmptyOne) {
  const ScratchFolder folder;
  EXPECT_THROW(read_surface_file(folder / "none", {}, units()), InputError);
  EXPECT_THROW(read_surface_file(folder / "", {}, units()), InputError);
  EXPECT_THROW(read_surface_file("/dev/zero", {}, units()), InputError);
  EXPECT_THAT(refusal("a.sur", ""), HasSubstr("the file is empty"));
}

TEST(HostileFile, AnUnknownFileGoesToGwyddionAndComesBackWithAWord) {
  if (!has_gwyddion()) GTEST_SKIP() << "the program gwyddion is not installed";
  EXPECT_THAT(refusal("a.bin", std::string("\x01\x02junk\0\xFF", 8)),
              AllOf(HasSubstr("gwyddion cannot read the file"), HasSubstr("export the measurement")));
  EXPECT_THAT(refusal("-rf;$(x) `y`.prf", std::string("\x01\x02junk\0\xFF", 8)),
              HasSubstr("export the profile as text"));
}

TEST(HostileFile, WithoutGwyddionTheMessageReportsIt) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const std::string printed = refusal("a.di", std::string("\x01\x02junk\0\xFF", 8));
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_THAT(printed, AllOf(HasSubstr("gwyddion, which is not installed"), HasSubstr("apt install gwyddion")));
}

}  // namespace
}  // namespace ringfilm::instrument
