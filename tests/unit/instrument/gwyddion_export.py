"""Writes a measurement in other formats by the libraries of gwyddion: python3 gwyddion_export.py IN OUT...

The program itself writes nothing but .gwy without a display; its exporters are called here one by one."""
import ctypes
import os
import sys

os.environ.pop("DISPLAY", None)
NONINTERACTIVE = 1
everywhere = ctypes.RTLD_GLOBAL
gtk = ctypes.CDLL("libgtk-x11-2.0.so.0", mode=everywhere)
names = ["gwyddion2", "gwyprocess2", "gwydraw2", "gwydgets2", "gwymodule2", "gwyapp2"]
libraries = {name: ctypes.CDLL("lib%s.so.0" % name, mode=everywhere) for name in names}
modules = next(
    path
    for path in ("/usr/lib/%s/gwyddion/modules/file" % folder for folder in [os.uname().machine + "-linux-gnu", "."])
    if os.path.isdir(path)
)
gtk.gtk_parse_args(ctypes.byref(ctypes.c_int(0)), None)
application = libraries["gwyapp2"]
application.gwy_app_data_browser_set_gui_enabled(0)
libraries["gwydraw2"].gwy_draw_type_init()
files = libraries["gwymodule2"]
files.gwy_module_register_modules((ctypes.c_char_p * 2)(modules.encode(), None))
files.gwy_file_load.restype = ctypes.c_void_p
error = ctypes.c_void_p(0)
data = ctypes.c_void_p(files.gwy_file_load(sys.argv[1].encode(), NONINTERACTIVE, ctypes.byref(error)))
if not data.value:
    sys.exit("gwyddion cannot load " + sys.argv[1])
application.gwy_app_data_browser_add(data)
application.gwy_app_data_browser_select_data_field(data, 0)
for target in sys.argv[2:]:
    if not files.gwy_file_save(data, target.encode(), NONINTERACTIVE, ctypes.byref(error)):
        sys.exit("gwyddion cannot save " + target)
sys.stdout.flush()
os._exit(0)
