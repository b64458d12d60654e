# %% [markdown]
# # The end gap of the ring
#
# A cycle usually takes the film to be alike all around. Do the ends of the ring at its gap change friction and film?
#
# **The case:** the new ring of styles2014 (SYNTHETIC cylinder pressure) with an end gap of 0.3 mm, ASSUMED. The film of the whole ring is unrolled, on a coarse grid. No gas blows through the end gap in this model.

# %%
import matplotlib.pyplot as plt
import numpy as np
import ringfilm

case = ringfilm.Case.read("cases/styles2014/new.toml")
case["solver.cells"] = 60
case["solver.crank_step"] = "4 degree"
case["solver.step_error"] = None
case["solver.crank_step_control"] = "fixed"
case["output.crank_angles"] = "4 degree"
face = case.run()

case["film.dimension"] = "unrolled"
case["ring.end_gap"] = "0.3 mm"
case["solver.cells_y"] = 80
case["output.fields"] = [20]
whole = case.run()

# %% [markdown]
# ## The pressure of the film near the end gap
# The last 3 mm before one end, at 20 degrees after firing TDC:

# %%
data = whole.to_xarray().isel(field_crank_angle=0)
end = data.sel(y=slice(0, 3e-3))
figure, axes = plt.subplots(figsize=(7.5, 3.2), layout="constrained")
mesh = axes.pcolormesh(
    end.y * 1e3, end.x * 1e3, end.unrolled_film_pressure.transpose("x", "y") * 1e-5, shading="nearest", cmap="viridis"
)
axes.invert_yaxis()
axes.set(xlabel="distance from the end of the ring [mm]", ylabel="from the chamber edge [mm]")
figure.colorbar(mesh, label="film pressure [bar]")
plt.show()

# %% [markdown]
# *Film pressure near the end of the ring, chamber edge on top. At the end it is set to the mean of chamber and crankcase; half a millimetre further on the film does not change.*
#
# ## What the end does to the whole

# %%
for name, label, factor, unit in (
    ("mean_power_loss", "mean friction power", 1, "W"),
    ("min_film_thickness", "minimum film thickness", 1e6, "um"),
    ("mean_absolute_oil_flow", "mean absolute oil flow", 1e6, "mg/s"),
):
    one, other = face.values[name] * factor, whole.values[name] * factor
    print(
        f"{label:26s} alike all around {one:9.4f} {unit:5s} with its end gap {other:9.4f} {unit:5s} "
        f"{100 * (other / one - 1):+.3f} %"
    )
gap, bore = case["ring.end_gap"], case["engine.bore"]
print(f"The end gap itself is {100 * gap / (np.pi * bore):.3f} % of the circumference.")

# %%
angle = (whole.crank_angle + 360) % 720 - 360
order = np.argsort(angle)
figure, axes = plt.subplots(figsize=(7.5, 3), layout="constrained")
axes.plot(angle[order], whole.gap_leakage[order] * 1e6, color="black", linewidth=1.2)
axes.axhline(0, color="0.6", linewidth=0.8)
axes.set(xlim=(-360, 360), xlabel="crank angle [degree], 0 = firing TDC", ylabel="oil into the end gap [mg/s]")
axes.set_xticks(range(-360, 361, 90))
plt.show()

# %% [markdown]
# *Oil that leaves the film through both ends into the end gap; negative where it enters. The coarse grid shows the course, not the amount.*
#
# For friction and film of a ring in a round bore, take the film alike all around. The leakage does not converge with the cells, because the pressure jumps in the corners ([why](../manual/unrolled.md)).
