#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/instrument/formats/height_table_file.hpp"
#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// The entry point for measured surfaces: any known format in, a height map in metres out, with what was taken from
/// where.
namespace ringfilm::instrument {

/// How the remedies of errors write the options: those of the program, or those of the language from which it is
/// called.
struct OptionNames {
  std::string channel = "--channel N";             ///< SurfaceOptions::channel
  std::string height_unit = "--unit um";           ///< SurfaceOptions::height_unit
  std::string lateral_unit = "--lateral-unit um";  ///< SurfaceOptions::lateral_unit
  std::string step_x = "--step-x \"0.5 um\"";      ///< SurfaceOptions::step_x
};

/// What the user states in place of the file, or in contradiction to it. Nothing is guessed in their place.
struct SurfaceOptions {
  std::optional<std::string> channel;            ///< --channel: number counted from 1, or name
  std::optional<std::string> height_unit;        ///< --unit: of the heights, e.g. "um"
  std::optional<std::string> lateral_unit;       ///< --lateral-unit: of x and y, e.g. "mm"
  std::optional<std::string> step_x;             ///< --step-x: e.g. "0.5 um"
  std::optional<std::string> step_y;             ///< --step-y: the same as --step-x if omitted
  TableLayout layout = TableLayout::kByContent;  ///< --layout: of a text file
  io::TableReading table;                        ///< --columns, --skip-lines, --missing: of a text file
  OptionNames names;                             ///< for errors
};

/// Where a map or a trace comes from, for the record.
struct SurfaceOrigin {
  std::string path;    ///< path as named
  std::string sha256;  ///< SHA-256 of the file
  std::string format;  ///< in words, e.g. "Digital Surf, 16 bit, low byte first"; which program read it, if another did
  std::string channel;              ///< name of the channel that was taken
  std::size_t channel_number = 1;   ///< number of the channel, counted from 1
  std::string instrument;           ///< as the file names it; may be empty
  std::string date;                 ///< as the file writes it; may be empty
  std::vector<Channel> channels;    ///< all of the file
  std::vector<std::string> notes;   ///< for the record: what the user stated, what was chosen
  std::vector<std::string> doubts;  ///< why the heights may not be those of the surface
};

/// A map of heights as read, and where it came from.
struct SurfaceFile {
  surface::HeightMap map;  ///< in metres, nothing removed
  SurfaceOrigin origin;    ///< file, channel, and what the user stated
  /// Size in points and lengths, step, Sq, min, max, share of missing points: to be shown on every read.
  std::string plausibility_line;
};

/// A trace as read, its places as measured, and where it came from.
struct TraceFile {
  surface::Trace trace;           ///< places that rise; points that were not measured are omitted
  SurfaceOrigin origin;           ///< file, channel, and what the user stated
  std::string plausibility_line;  ///< points, length, step and range of heights: to be shown on every read
};

/// Opens a file of any known format: X3P, SDF, SUR, GSF, .gwy and text by our own readers, all else through the program
/// gwyddion. Throws InputError with file, place, rule and remedy.
/// @param stated what the user states of a text
InstrumentFile open_instrument_file(const std::string& path, TableLayout layout = TableLayout::kByContent,
                                    const io::TableReading& stated = {});

/// Reads one map of heights. In a file of several channels it is the chosen one, else the only one whose unit is a
/// length. Rows and columns are oriented as gwyddion shows them: row 0 is the upper edge of its picture. A map of one
/// column is turned into a profile, and a profile of uneven places in a text is resampled, with a note. Throws
/// InputError: no such channel or several to choose from, a unit or a step that neither the file nor the user states,
/// no measured point, heights beyond 1 m or otherwise certainly not those of a surface, and all faults of the file.
SurfaceFile read_surface_file(const std::string& path, const SurfaceOptions& options, const io::Units& units);

/// Reads a profile, whose places need not be even. Throws InputError also for a map of more than one row.
TraceFile read_trace_file(const std::string& path, const SurfaceOptions& options, const io::Units& units);

/// All channels of a file with their own units: lateral signals of an AFM, voltages, light. Throws InputError.
std::vector<ChannelValues> read_channels(const std::string& path);

/// A channel by its name or its number.
struct ChannelFound {
  std::optional<std::size_t> index;  ///< the only channel of the name, else the one of the number, from 1; or nothing
  std::size_t n_named = 0;           ///< channels of the name
};
/// The channel that `requested` names or numbers.
ChannelFound find_channel(const std::vector<Channel>& channels, const std::string& requested);

/// A table of the channels for a person: number, name, unit, points.
std::string channel_list(const std::vector<Channel>& channels);

/// The line by which the user can check whether the map was read as intended; it is.
std::string plausibility_line(const surface::HeightMap& map);

}  // namespace ringfilm::instrument
