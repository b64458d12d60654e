function r = ringfilm_read (file)
%RINGFILM_READ  A NetCDF file of ringfilm as a struct: results, pads, studies, measurements.
%
%   r = ringfilm_read ("new.nc");
%   plot (r.crank_angle, r.min_film_thickness * 1e6)
%   ylabel (r.about.min_film_thickness.long_name)
%
%   Each variable of the file is a field of r by its name. Numbers are doubles in the unit of the file: SI, crank angles
%   in degrees, 0 at firing top dead centre. A vector is a column; a variable over (a, b) of the file is an array over
%   (b, a) here, as with ncread. Texts are cell arrays of char.
%
%   r.about.NAME      units, long_name, symbol, source_equation (as far as the file has them), and dimensions: the names
%                     in the order of the array here
%   r.attributes      of the file: title, program, commit, ...
%   r.kind            "result", "pad", "study" or "measurement"
%   r.unread          names of variables that could not be read: the texts, where the NetCDF of Octave cannot
%
%   For MATLAB without any toolbox, and for Octave with its package netcdf (Debian: octave-netcdf).
%   Errors: ringfilm_read:file where it cannot be opened, ringfilm_read:foreign where it is not of ringfilm.

  nc = netcdf_library ();
  if exist (file, 'file') ~= 2
    error ('ringfilm_read:file', 'ringfilm_read: there is no file %s', file);
  end
  try
    id = nc.open (file, 'NC_NOWRITE');
  catch reason
    error ('ringfilm_read:file', 'ringfilm_read: %s cannot be opened as NetCDF: %s', file, reason.message);
  end
  closes = onCleanup (@() nc.close (id));

  [n_dimensions, n_variables, n_attributes] = nc.inq (id);
  r = struct ();
  r.attributes = attributes_of (nc, id, nc.global_id, n_attributes);
  r.kind = kind_of (r.attributes, file);
  r.unread = {};
  r.about = struct ();

  for variable = 0:n_variables - 1
    [name, type, dimensions, n_attributes] = nc.inqVar (id, variable);
    field = field_name (name);
    about = attributes_of (nc, id, variable, n_attributes);
    about.dimensions = cell (1, 0);
    for k = 1:numel (dimensions)
      about.dimensions{k} = nc.inqDim (id, dimensions(k));
    end
    r.about.(field) = about;
    try
      if type == nc.text_type
        r.(field) = texts_of (file, name);
      else
        values = double (nc.getVar (id, variable));
        if isfield (about, 'FillValue')
          values(values == about.FillValue) = NaN;
        end
        if isvector (values)
          values = values(:);
        end
        r.(field) = values;
      end
    catch
      r.unread{end + 1} = name;
    end
  end
end

function nc = netcdf_library ()
% The calls of the NetCDF library, which MATLAB and Octave spell differently.
  names = {'open', 'close', 'inq', 'inqVar', 'inqDim', 'inqAttName', 'getAtt', 'getVar', 'getConstant'};
  in_octave = exist ('OCTAVE_VERSION', 'builtin') ~= 0;
  if in_octave
    try
      pkg load netcdf
    catch
      error ('ringfilm_read:package', ...
             'ringfilm_read: Octave lacks its package netcdf; on Debian: apt-get install octave-netcdf');
    end
  end
  nc = struct ();
  for k = 1:numel (names)
    if in_octave
      nc.(names{k}) = str2func (['netcdf_' names{k}]);
    else
      nc.(names{k}) = str2func (['netcdf.' names{k}]);
    end
  end
  nc.global_id = nc.getConstant ('NC_GLOBAL');
  nc.text_type = 12;  % NC_STRING
end

function attributes = attributes_of (nc, id, variable, count)
  attributes = struct ();
  for k = 0:count - 1
    name = nc.inqAttName (id, variable, k);
    value = nc.getAtt (id, variable, name);
    if isnumeric (value)
      value = double (value);
    end
    attributes.(field_name (name)) = value;
  end
end

function kind = kind_of (attributes, file)
  kinds = {'result', 'ringfilm_schema'; 'pad', 'ringfilm_pad_schema'; 'study', 'ringfilm_study_schema'; ...
           'measurement', 'ringfilm_measurement_schema'};
  for k = 1:size (kinds, 1)
    if isfield (attributes, kinds{k, 2})
      kind = kinds{k, 1};
      return
    end
  end
  error ('ringfilm_read:foreign', 'ringfilm_read: %s was not written by ringfilm', file);
end

function texts = texts_of (file, name)
% ncread reads text in MATLAB; Octave's package up to 1.0.16 does not, and throws.
  texts = ncread (file, name);
  if ~iscell (texts)
    texts = cellstr (texts);
  end
  texts = texts(:);
end

function field = field_name (name)
% "_FillValue" is not a valid name of a field.
  field = regexprep (name, '^_+', '');
  field = regexprep (field, '[^A-Za-z0-9_]', '_');
end
